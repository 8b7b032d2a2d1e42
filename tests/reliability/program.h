// From a command line to an exit code: what the programs of this folder share.

#ifndef GEODESIC_TESTS_RELIABILITY_PROGRAM_H_
#define GEODESIC_TESTS_RELIABILITY_PROGRAM_H_

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

namespace geodesic::client {

// Parses the command line, then calls `run`, which returns what was not as it
// must be: a line each on standard error. Returns the exit code: 0 nothing, 1
// something, or `run` threw; 2 wrong usage, which `run` may find too and throw
// as a CLI::ParseError.
int RunMain(CLI::App& app, int argc, char** argv,
            const std::function<std::vector<std::string>()>& run);

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_RELIABILITY_PROGRAM_H_
