// Which of a setting's sources wins: its flag, else its environment variable,
// else the file.

#ifndef GEODESIC_SERVER_OPTIONS_SETTING_SOURCES_H_
#define GEODESIC_SERVER_OPTIONS_SETTING_SOURCES_H_

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace geodesic::server {

// Adds --config, whose settings variables win over.
void AddFile(CLI::App& app);

// Gives each flag that `app` has by now its variable.
void AddVariables(CLI::App& app);

// Takes the variables that `app`, which has parsed its command line, has passed
// over: CLI11 2.4 does so with values that it does not take, without a word.
// Errors: throws CLI::ParseError.
void TakeVariables(CLI::App& app);

// The arguments in the order in which CLI11 takes them, last first. CLI11 reads
// the file before the environment, so the file's own variable becomes a flag.
std::vector<std::string> ArgumentsInReverse(int argc, const char* const* argv);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_OPTIONS_SETTING_SOURCES_H_
