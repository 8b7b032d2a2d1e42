// How the command reaches its server: address, TLS, token.

#ifndef GEODESIC_CLIENT_CLI_CONNECTION_H_
#define GEODESIC_CLIENT_CLI_CONNECTION_H_

#include <CLI/CLI.hpp>

#include "absl/status/statusor.h"
#include "client/cli/arguments.h"
#include "geodesic_client/connection_options.h"

namespace geodesic::client {

// Adds --server and what belongs to it; `arguments` outlives the parsing.
void AddConnection(CLI::App* app, Arguments* arguments);

// Reads the files that the arguments name.
// Errors, all FileErrors: those of ReadTlsFiles and ReadTokenFile;
// FAILED_PRECONDITION if a token would go to another machine in clear.
absl::StatusOr<ConnectionOptions> ReadConnection(const Arguments& arguments);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_CONNECTION_H_
