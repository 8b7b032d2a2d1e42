// geodesicd's settings: flags, environment variables and a file.

#ifndef GEODESIC_SERVER_OPTIONS_OPTIONS_H_
#define GEODESIC_SERVER_OPTIONS_OPTIONS_H_

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "manual/pages.h"
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
  // HOST:PORT of the page and of gRPC-Web; empty: none.
  std::string web_listen;
  // Other origins whose pages may call there.
  std::vector<std::string> web_origins;
  // As token_file, for those who come there; empty: token_file holds for them.
  std::string web_token_file;
  // Where to write the port of web_listen that was taken; empty: nowhere.
  std::string web_port_file;
  // Where to write the port that was taken, or the socket's path; empty:
  // nowhere.
  std::string port_file;
  // HOST:PORT or unix:PATH of a Redis that several servers share; empty: none.
  std::string shared_tier;
  // Its password; empty: none.
  std::string shared_tier_password_file;
  // When it forgets a value.
  std::chrono::seconds shared_tier_expiry{86400};
  // Of one value, and of all that wait to be written.
  uint64_t shared_tier_max_value_bytes = uint64_t{32} << 20;
  // How long it may take over each 256 KiB.
  uint64_t shared_tier_timeout_ms = 5;
  // The folder of meshes and fields; empty: nothing outlives the server.
  std::string data_dir;
  // Requests at once; further streams are refused.
  uint64_t max_requests = 1000;
  // Largest gRPC message taken.
  uint64_t max_message_bytes = uint64_t{8} << 20;
  // Calls at once on one connection.
  uint64_t max_connection_streams = 256;
  // How long a message may take to come in.
  std::chrono::seconds receive_patience{60};
  // How long a client may take nothing of its answer.
  std::chrono::seconds send_patience{120};
  // Memory of messages that are still coming in.
  uint64_t receive_memory_bytes = uint64_t{512} << 20;
  // Memory of decoded requests and of the questions made from them.
  uint64_t request_memory_bytes = uint64_t{1} << 30;
  // How long requests may go on after SIGTERM.
  std::chrono::seconds drain{30};
  // How long without a request until the server ends by itself; 0: never.
  std::chrono::seconds exit_when_idle{0};
  // A level of spdlog.
  std::string log_level = "info";
  // What is divided among the budgets of `limits` and those above (memory.h).
  uint64_t memory_bytes = 0;
  uint64_t disk_bytes = uint64_t{80} << 30;
  // NAME=VALUE of those that were set one by one (limits.h).
  std::vector<std::string> chosen_limits;
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

// All settings, for the man page and the file that explains them.
manual::Page ProgramPage();

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_OPTIONS_OPTIONS_H_
