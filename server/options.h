// geodesicd's settings: flags, environment variables and a file.

#ifndef GEODESIC_SERVER_OPTIONS_H_
#define GEODESIC_SERVER_OPTIONS_H_

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "server/engine/base/limits.h"
#include "server/security/tls_files.h"

namespace geodesic::server {

// `limits.mesh_disk_bytes` and `limits.field_disk_bytes` are 0 without a
// data_dir.
struct ServerOptions {
  // HOST:PORT, where port 0 takes a free one; or unix:PATH.
  std::string listen = "127.0.0.1:50051";
  // Without files the server listens in clear. It then refuses addresses that
  // other machines can reach, unless insecure_listen is set.
  TlsFiles tls;
  bool insecure_listen = false;
  // See access_control.h; empty: everybody may do everything.
  std::string token_file;
  // HOST:PORT of /metrics, /livez and /readyz; empty: none.
  std::string metrics_listen;
  // Whether gRPC's channelz service is served, to everybody.
  bool channelz = false;
  // Where to write the port that was taken, or the socket's path; empty:
  // nowhere.
  std::string port_file;
  // The folder of meshes and fields; empty: nothing outlives the server.
  std::string data_dir;
  // Requests at once; further streams are refused.
  uint64_t max_requests = 1000;
  // Largest gRPC message taken.
  uint64_t max_message_bytes = uint64_t{4} << 20;
  // Calls at once on one connection.
  uint64_t max_connection_streams = 256;
  // How long a message may take to come in.
  std::chrono::seconds receive_patience{60};
  // Memory of messages that are still coming in.
  uint64_t receive_memory_bytes = uint64_t{256} << 20;
  // Memory of decoded requests and of the questions made from them.
  uint64_t request_memory_bytes = uint64_t{1} << 30;
  // How long requests may go on after SIGTERM.
  std::chrono::seconds drain{30};
  // How long without a request until the server ends by itself; 0: never.
  std::chrono::seconds exit_when_idle{0};
  // A level of spdlog.
  std::string log_level = "info";
  Limits limits;
};

// The result of the command line: run with `options`, or exit with `exit_code`
// if it is set (help or an error has then been printed).
struct CommandLine {
  ServerOptions options;
  std::optional<int> exit_code;
};

// A flag wins over its environment variable, which wins over the file.
CommandLine ParseCommandLine(int argc, const char* const* argv,
                             const std::string& version);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_OPTIONS_H_
