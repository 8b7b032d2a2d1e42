#include "client/cli/arguments/connection.h"

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "absl/strings/str_cat.h"
#include "client/cli/arguments/options.h"
#include "client/cli/terminal/exit_code.h"

namespace geodesic::client {
namespace {

// Whether what is sent there stays on this machine.
bool IsLoopback(std::string_view server) {
  const std::string_view host = server.substr(0, server.rfind(':'));
  return host == "localhost" || host == "[::1]" || host.starts_with("127.");
}

absl::StatusOr<std::string> ReadToken(const ConnectionArguments& connection) {
  if (!connection.token.empty() || connection.token_file.empty()) {
    return connection.token;
  }
  return ReadTokenFile(connection.token_file);
}

}  // namespace

void AddConnection(CLI::App* app, ConnectionArguments* arguments) {
  ConnectionArguments& connection = *arguments;
  AddValue(app, {"--server", "Where the server listens", "HOST:PORT"},
           ParseServer, &connection.server)
      ->default_str(connection.server)
      ->envname("GEODESIC_SERVER");
  app->add_flag("--tls", connection.tls,
                "Speak TLS and trust the authorities this system trusts; the "
                "other --tls options imply it")
      ->envname("GEODESIC_TLS");
  const auto add = [app](const std::string& name, std::string& value,
                         const std::string& help, const std::string& type,
                         const std::string& variable) {
    return app->add_option(name, value, help)
        ->type_name(type)
        ->envname(variable);
  };
  add("--tls-ca", connection.paths.authorities,
      "Trust the authorities in this PEM file instead", "FILE",
      "GEODESIC_TLS_CA");
  CLI::Option* certificate =
      add("--tls-cert", connection.paths.certificate,
          "Show this certificate to a server that asks for one", "FILE",
          "GEODESIC_TLS_CERT");
  CLI::Option* key =
      add("--tls-key", connection.paths.key, "The private key of --tls-cert",
          "FILE", "GEODESIC_TLS_KEY");
  certificate->needs(key);
  key->needs(certificate);
  add("--tls-server-name", connection.server_name,
      "The name the server's certificate must have, if it is not the host of "
      "--server",
      "NAME", "GEODESIC_TLS_SERVER_NAME");
  add("--token", connection.token,
      "Say who you are with this token; others on this machine can read "
      "command "
      "lines, so better the variable or --token-file",
      "TOKEN", "GEODESIC_TOKEN");
  add("--token-file", connection.token_file,
      "Read the token from the first line of this file", "FILE",
      "GEODESIC_TOKEN_FILE");
  app->add_flag("--no-retry", connection.no_retry,
                "Report at once that the server is full, away, or was cut off, "
                "instead of trying again a few times")
      ->envname("GEODESIC_NO_RETRY");
}

absl::StatusOr<ConnectionOptions> ReadConnection(
    const ConnectionArguments& connection) {
  ConnectionOptions options;
  if (connection.tls || !connection.paths.authorities.empty() ||
      !connection.paths.certificate.empty() ||
      !connection.server_name.empty()) {
    absl::StatusOr<TlsOptions> tls = ReadTlsFiles(connection.paths);
    if (!tls.ok()) return FileError(tls.status());
    options.tls = *std::move(tls);
    options.tls->server_name = connection.server_name;
  }
  absl::StatusOr<std::string> token = ReadToken(connection);
  if (!token.ok()) return FileError(token.status());
  if (!token->empty() && !options.tls.has_value() &&
      !IsLoopback(connection.server)) {
    return FileError(absl::FailedPreconditionError(
        absl::StrCat("the token would go to ", connection.server,
                     " in clear: use TLS (--tls or --tls-ca FILE)")));
  }
  options.token = *std::move(token);
  options.retry = !connection.no_retry;
  return options;
}

}  // namespace geodesic::client
