// How --help looks: what a value is, then a wrapped description.

#ifndef GEODESIC_CLIENT_CLI_ARGUMENTS_HELP_FORMATTER_H_
#define GEODESIC_CLIENT_CLI_ARGUMENTS_HELP_FORMATTER_H_

#include <CLI/CLI.hpp>
#include <string>

namespace geodesic::client {

class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter();

  std::string make_option_name(const CLI::Option* option,
                               bool is_positional) const override;
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_option_desc(const CLI::Option* option) const override;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_ARGUMENTS_HELP_FORMATTER_H_
