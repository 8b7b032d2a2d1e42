#include "client/cli/arguments/help_formatter.h"

#include <sstream>

#include "absl/strings/str_cat.h"

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

}  // namespace

HelpFormatter::HelpFormatter() { column_width(kNameColumns); }

std::string HelpFormatter::make_option_name(const CLI::Option* option,
                                            bool is_positional) const {
  std::string name = CLI::Formatter::make_option_name(option, is_positional);
  // A flag that may have a count shows the one it has without.
  const size_t brace = name.find('{');
  return brace == std::string::npos
             ? name
             : absl::StrCat(name.substr(0, brace), "[=N]");
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  const bool has_value = option->get_type_size() != 0;
  return has_value && !option->get_type_name().empty()
             ? absl::StrCat(" ", option->get_type_name())
             : std::string();
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
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

}  // namespace geodesic::client
