// The commands that ask a question, and what each may be given.

#ifndef GEODESIC_CLIENT_CLI_QUESTION_OPTIONS_H_
#define GEODESIC_CLIENT_CLI_QUESTION_OPTIONS_H_

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "client/cli/arguments.h"

namespace geodesic::client {

// Adds a command: its name, what it does, an example.
using AddCommand =
    std::function<CLI::App*(const std::string& name, const std::string& help,
                            const std::string& example, Command command)>;

// field, path, isolines, matrix, nearest, sample and logmap.
void AddQuestions(const AddCommand& add, Arguments* arguments);

// What options cannot say each for itself.
// Errors: throws CLI::ParseError naming the option and the way out.
void CheckArguments(const Arguments& arguments);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_QUESTION_OPTIONS_H_
