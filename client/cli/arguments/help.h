// How --help looks, and what is said about a wrong command line.

#ifndef GEODESIC_CLIENT_CLI_ARGUMENTS_HELP_H_
#define GEODESIC_CLIENT_CLI_ARGUMENTS_HELP_H_

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

namespace geodesic::client {

// Options with what their values are, and wrapped descriptions.
std::shared_ptr<CLI::FormatterBase> MakeHelpFormatter();

// What `error` says, with what somebody who mistyped a word may have meant.
// `given` is the command, or null if there is none.
std::string MessageOf(const CLI::App& app, const CLI::App* given,
                      const CLI::Error& error);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_ARGUMENTS_HELP_H_
