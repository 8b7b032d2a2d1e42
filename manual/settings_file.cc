#include "manual/settings_file.h"

#include <algorithm>
#include <sstream>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"

namespace geodesic::manual {
namespace {

constexpr size_t kColumns = 76;

std::string Comment(const std::string& text) {
  std::istringstream words(text);
  std::string comment = "#";
  size_t column = 1;
  for (std::string word; words >> word;) {
    if (column + 1 + word.size() > kColumns) {
      comment += "\n#";
      column = 1;
    }
    absl::StrAppend(&comment, " ", word);
    column += 1 + word.size();
  }
  return comment + "\n";
}

// As TOML writes it: numbers and truths bare, all else in quotes.
std::string TomlValue(const std::string& value) {
  const bool is_number =
      !value.empty() && std::ranges::all_of(value, absl::ascii_isdigit);
  return is_number || value == "true" || value == "false"
             ? value
             : absl::StrCat("\"", value, "\"");
}

}  // namespace

std::string SettingsFile(const Page& program,
                         const std::map<std::string, std::string>& values) {
  std::string file = absl::StrCat(
      Comment(absl::StrCat(
          "Settings of ", program.name,
          ". A line without # is in force; the others show the defaults, or "
          "what kind of value is meant. A variable of the environment, named "
          "behind each explanation, wins over this file, and a flag of the "
          "command line over both.")),
      "\n");
  std::string group;
  for (const Option& option : program.options) {
    if (!option.is_setting) continue;
    if (option.group != group) {
      group = option.group;
      absl::StrAppend(&file, "## ", group, "\n\n");
    }
    const std::string name = option.names.back().substr(2);
    const std::string shown = !option.default_value.empty()
                                  ? option.default_value
                              : option.value.empty() ? "false"
                                                     : option.value;
    const auto set = values.find(name);
    absl::StrAppend(
        &file, Comment(absl::StrCat(option.help, ". (", option.variable, ")")),
        set == values.end() ? "#" : "", name, " = ",
        TomlValue(set == values.end() ? shown : set->second), "\n\n");
  }
  return file;
}

}  // namespace geodesic::manual
