// What is written about a program and its commands, taken from the options
// themselves: man pages, completions of shells and a file of settings are made
// from this, and so cannot go stale.

#ifndef GEODESIC_MANUAL_PAGES_H_
#define GEODESIC_MANUAL_PAGES_H_

#include <string>
#include <vector>

namespace CLI {
class App;
}  // namespace CLI

namespace geodesic::manual {

struct Option {
  // With their dashes; a positional argument has one name, without.
  std::vector<std::string> names;
  // What stands for the value, e.g. "FILE"; empty for a flag.
  std::string value;
  // A flag that may have one, as "--flag=N".
  bool may_have_value = false;
  // The words that the value may be, if they are few.
  std::vector<std::string> choices;
  std::string help;
  // As the help shows it; empty: none.
  std::string default_value;
  // The environment variable that sets it; empty: none.
  std::string variable;
  // Whether a file of settings may hold it.
  bool is_setting = false;
  std::string group;
};

struct Page {
  std::string name;
  std::string help;
  // Paragraphs behind the options, as the help has them.
  std::string footer;
  std::vector<Option> arguments;
  std::vector<Option> options;
  std::vector<Page> commands;
};

// The page of a program and the pages of its commands.
Page Describe(const CLI::App& app);

}  // namespace geodesic::manual

#endif  // GEODESIC_MANUAL_PAGES_H_
