// How the command reaches its server: address, TLS, token.

#ifndef GEODESIC_CLIENT_CLI_ARGUMENTS_CONNECTION_H_
#define GEODESIC_CLIENT_CLI_ARGUMENTS_CONNECTION_H_

#include <string>

#include "absl/status/statusor.h"
#include "geodesic_client/connection_options.h"

namespace CLI {
class App;
}  // namespace CLI

namespace geodesic::client {

struct ConnectionArguments {
  std::string server = "127.0.0.1:50051";
  bool tls = false;
  TlsPaths paths;
  std::string server_name;
  std::string token;
  std::string token_file;
  bool no_retry = false;
};

// Adds --server and what belongs to it; `connection` outlives the parsing.
void AddConnection(CLI::App* app, ConnectionArguments* connection);

// Reads the files that the arguments name.
// Errors, all FileErrors: those of ReadTlsFiles and ReadTokenFile;
// FAILED_PRECONDITION if a token would go to another machine in clear.
absl::StatusOr<ConnectionOptions> ReadConnection(
    const ConnectionArguments& connection);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_ARGUMENTS_CONNECTION_H_
