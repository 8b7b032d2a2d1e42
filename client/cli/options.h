// Options that several commands share. Each function adds to `command` what
// writes into `arguments`, both of which outlive the parsing.

#ifndef GEODESIC_CLIENT_CLI_OPTIONS_H_
#define GEODESIC_CLIENT_CLI_OPTIONS_H_

#include <CLI/CLI.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "client/cli/arguments.h"

namespace geodesic::client {

// An option whose text goes through `parse`, which may say what is wrong; may
// be repeated.
template <typename Parse, typename Accept>
CLI::Option* AddParsed(CLI::App* command, const std::string& name,
                       const std::string& help, Parse parse, Accept accept) {
  return command
      ->add_option_function<std::vector<std::string>>(
          name,
          [name, parse, accept](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
              auto value = parse(text);
              if (!value.ok()) {
                throw CLI::ValidationError(
                    name, std::string(value.status().message()));
              }
              accept(text, *std::move(value));
            }
          },
          help)
      // One value after each mention: what follows may be MESH.
      ->allow_extra_args(false);
}

// MESH as questions have it: a file or a digest; and --format.
void AddMesh(CLI::App* command, Arguments* arguments);
// The same with a text of its own.
void AddMesh(CLI::App* command, const std::string& help, Arguments* arguments);
void AddFormat(CLI::App* command, Arguments* arguments);

// Only what the help says; CheckArguments sees to it.
enum class Need { kRequired, kOptional };

// --source, --curve, --sources.
void AddSources(CLI::App* command, Need need, Arguments* arguments);
// --target, --targets; `help` says what targets are for.
void AddTargets(CLI::App* command, Need need, const std::string& help,
                Arguments* arguments);

void AddAlgorithm(CLI::App* command, Arguments* arguments);
void AddPriority(CLI::App* command, Arguments* arguments);
void AddRadius(CLI::App* command, const std::string& help,
               Arguments* arguments);
void AddFloat32(CLI::App* command, Arguments* arguments);
// -o; `help` begins the sentence that the endings end.
void AddOutputs(CLI::App* command, const std::string& help,
                std::span<const OutputFormat> formats, Arguments* arguments);
// --view, --up, --size.
void AddPicture(CLI::App* command, Arguments* arguments);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_OPTIONS_H_
