#include "client/cli/arguments/help.h"

#include <algorithm>
#include <numeric>
#include <sstream>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"

namespace geodesic::client {
namespace {

constexpr size_t kNameColumns = 30;
constexpr size_t kDescriptionColumns = 50;

// CLI11 indents what follows a newline.
std::string Wrapped(const std::string& text) {
  std::istringstream words(text);
  std::string lines;
  size_t column = 0;
  for (std::string word; words >> word;) {
    if (column > 0 && column + 1 + word.size() > kDescriptionColumns) {
      lines.push_back('\n');
      column = 0;
    } else if (column > 0) {
      lines.push_back(' ');
      ++column;
    }
    lines.append(word);
    column += word.size();
  }
  return lines;
}

class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter() { column_width(kNameColumns); }

  std::string make_option_name(const CLI::Option* option,
                               bool is_positional) const override {
    std::string name = CLI::Formatter::make_option_name(option, is_positional);
    // A flag that may have a count shows the one it has without.
    const size_t brace = name.find('{');
    return brace == std::string::npos
               ? name
               : absl::StrCat(name.substr(0, brace), "[=N]");
  }

  std::string make_option_opts(const CLI::Option* option) const override {
    const bool has_value = option->get_type_size() != 0;
    return has_value && !option->get_type_name().empty()
               ? absl::StrCat(" ", option->get_type_name())
               : std::string();
  }

  std::string make_option_desc(const CLI::Option* option) const override {
    std::string text = option->get_description();
    if (option->get_required() && !option->get_positional()) {
      absl::StrAppend(&text, " (required)");
    }
    if (!option->get_default_str().empty()) {
      absl::StrAppend(&text, " (default ", option->get_default_str(), ")");
    }
    if (!option->get_envname().empty()) {
      absl::StrAppend(&text, " (or set ", option->get_envname(), ")");
    }
    return Wrapped(text);
  }
};

// The edit distance of Levenshtein, one row of its table at a time.
size_t EditDistance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (size_t i = 0; i < a.size(); ++i) {
    size_t diagonal = row[0]++;
    for (size_t j = 0; j < b.size(); ++j) {
      const size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

// The candidate nearest to `typed` by letters inserted, removed and replaced;
// empty if that takes more than one, and one more for three letters typed.
std::string Suggestion(std::string_view typed,
                       const std::vector<std::string>& candidates) {
  std::string nearest;
  size_t least = typed.size() / 3 + 2;
  for (const std::string& candidate : candidates) {
    const size_t distance = EditDistance(typed, candidate);
    if (distance < least) {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

// The names of the options, or of the commands, that one may have meant.
std::vector<std::string> Candidates(const CLI::App& app, const CLI::App* given,
                                    const std::string& typed) {
  std::vector<std::string> names;
  if (!typed.starts_with('-')) {
    for (const CLI::App* command : app.get_subcommands({})) {
      names.push_back(command->get_name());
    }
    return names;
  }
  for (const CLI::App* place : {&app, given}) {
    if (place == nullptr) continue;
    for (const CLI::Option* option : place->get_options()) {
      for (const std::string& name : option->get_lnames()) {
        names.push_back("--" + name);
      }
    }
  }
  return names;
}

}  // namespace

std::shared_ptr<CLI::FormatterBase> MakeHelpFormatter() {
  return std::make_shared<HelpFormatter>();
}

std::string MessageOf(const CLI::App& app, const CLI::App* given,
                      const CLI::Error& error) {
  // CLI11 lists these from the last to the first.
  const std::vector<std::string> rest = app.remaining(true);
  const bool is_extra =
      dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr;
  if (rest.empty() || (given != nullptr && !is_extra)) return error.what();
  const std::string typed = rest[0].substr(0, rest[0].find('='));
  const std::string suggestion =
      Suggestion(typed, Candidates(app, given, typed));
  return absl::StrCat(given == nullptr && !typed.starts_with('-')
                          ? "there is no command " + typed
                          : "not expected here: " + absl::StrJoin(rest, " "),
                      suggestion.empty() ? "" : "; did you mean ", suggestion,
                      suggestion.empty() ? "" : "?");
}

}  // namespace geodesic::client
