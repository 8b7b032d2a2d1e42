#include "manual/pages.h"

#include <CLI/CLI.hpp>
#include <regex>
#include <sstream>

namespace geodesic::manual {
namespace {

// The words of "interactive|batch"; none for another text.
std::vector<std::string> Choices(const std::string& value) {
  static constexpr char kWords[] = "[a-z0-9.-]+(\\|[a-z0-9.-]+)+";
  std::vector<std::string> choices;
  if (!std::regex_match(value, std::regex(kWords))) return choices;
  std::istringstream words(value);
  for (std::string word; std::getline(words, word, '|');) {
    choices.push_back(word);
  }
  return choices;
}

Option Describe(const CLI::Option& option) {
  Option described = {.may_have_value = !option.get_fnames().empty(),
                      .help = option.get_description(),
                      .default_value = option.get_default_str(),
                      .variable = option.get_envname(),
                      .is_setting = option.get_configurable(),
                      .group = option.get_group()};
  for (const std::string& name : option.get_snames()) {
    described.names.push_back("-" + name);
  }
  for (const std::string& name : option.get_lnames()) {
    described.names.push_back("--" + name);
  }
  if (option.get_positional()) described.names = {option.get_name(true)};
  if (option.get_type_size() != 0) {
    described.value = option.get_type_name();
    described.choices = Choices(described.value);
  }
  return described;
}

}  // namespace

Page Describe(const CLI::App& app) {
  Page page = {.name = app.get_name(),
               .help = app.get_description(),
               .footer = app.get_footer()};
  for (const CLI::Option* option : app.get_options()) {
    (option->get_positional() ? page.arguments : page.options)
        .push_back(Describe(*option));
  }
  for (const CLI::App* command : app.get_subcommands({})) {
    page.commands.push_back(Describe(*command));
  }
  return page;
}

}  // namespace geodesic::manual
