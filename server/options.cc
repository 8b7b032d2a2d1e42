#include "server/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <istream>
#include <memory>
#include <thread>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_replace.h"
#include "geodesic/solve_options.h"
#include "server/security/tls_files.h"
#include "server/unix_socket.h"
#include "server/web/origin_policy.h"

namespace geodesic::server {
namespace {

constexpr int kUsageError = 2;

constexpr uint64_t kMaxBytes = uint64_t{1} << 50;

// gRPC counts a message's bytes in an int.
constexpr uint64_t kMaxMessageBytes = uint64_t{1} << 30;

// The bound of core's 32-bit half-edge numbers.
constexpr uint64_t kMaxFaces = (uint64_t{1} << 32) / 3 - 1;
constexpr uint64_t kMaxVertices = uint64_t{1} << 31;

std::string InUnits(uint64_t bytes) {
  for (const auto& [shift, unit] :
       {std::pair{30, "GiB"}, {20, "MiB"}, {10, "KiB"}}) {
    const uint64_t size = uint64_t{1} << shift;
    if (bytes >= size && bytes % size == 0) {
      return absl::StrCat(bytes / size, unit);
    }
  }
  return absl::StrCat(bytes, "B");
}

void AddBytes(CLI::App& app, const std::string& flag, uint64_t& value,
              const std::string& help, uint64_t most = kMaxBytes,
              uint64_t least = 1) {
  app.add_option(flag, value, help)
      ->transform(CLI::AsSizeValue(/*kb_is_1000=*/true).description(""))
      ->check(CLI::Range(least, most).description(""))
      ->default_str(InUnits(value))
      ->type_name("BYTES");
}

CLI::Option& AddCount(CLI::App& app, const std::string& flag, uint64_t& value,
                      uint64_t most, const std::string& help,
                      uint64_t least = 1) {
  return *app.add_option(flag, value, help)
              ->check(CLI::Range(least, most).description(""))
              ->capture_default_str()
              ->type_name("N");
}

void AddSeconds(CLI::App& app, const std::string& flag,
                std::chrono::seconds& value, int64_t least,
                const std::string& help, int64_t most = 86400) {
  app.add_option_function<int64_t>(
         flag, [&value](int64_t count) { value = std::chrono::seconds(count); },
         help)
      ->check(CLI::Range(least, most).description(""))
      ->default_str(std::to_string(value.count()))
      ->type_name("SECONDS");
}

// Says what is wrong with an address; empty if it is well-formed.
std::string CheckAddress(const std::string& address) {
  const size_t colon = address.rfind(':');
  const std::string port =
      colon == std::string::npos ? "" : address.substr(colon + 1);
  const bool digits =
      !port.empty() && port.size() <= 5 &&
      std::all_of(port.begin(), port.end(), absl::ascii_isdigit);
  return digits && colon > 0 && std::stoi(port) <= 65535
             ? std::string()
             : absl::StrCat("\"", address, "\" is not HOST:PORT");
}

// The same for an address that may be a socket's.
std::string CheckListen(const std::string& address) {
  const std::optional<std::string> path = SocketPath(address);
  if (!path) return CheckAddress(address);
  const absl::Status status = CheckSocketPath(*path);
  return absl::IsInvalidArgument(status) ? std::string(status.message()) : "";
}

// The same for the address of another program.
std::string CheckShared(const std::string& address) {
  return SocketPath(address) ? "" : CheckAddress(address);
}

std::string CheckOrigin(const std::string& origin) {
  return IsOrigin(origin) ? ""
                          : absl::StrCat("\"", origin,
                                         "\" is not https://HOST or "
                                         "https://HOST:PORT");
}

CLI::Option& AddText(CLI::App& app, const std::string& flag, std::string& value,
                     const std::string& type, const std::string& help) {
  return *app.add_option(flag, value, help)->type_name(type);
}

// Adds every setting but --config, with its bounds, in the order of the help.
// The disk budgets' defaults are for the help; without --data-dir they are 0.
void AddOptions(CLI::App& app, ServerOptions& options) {
  Limits& limits = options.limits;
  limits.max_concurrent_jobs =
      std::max<uint64_t>(1, std::thread::hardware_concurrency());
  limits.mesh_disk_bytes = uint64_t{64} << 30;
  limits.field_disk_bytes = uint64_t{16} << 30;
  constexpr uint64_t kMillion = 1'000'000;
  constexpr uint64_t kMost = 100 * kMillion;

  app.option_defaults()->group("Network");
  AddText(app, "--listen", options.listen, "HOST:PORT",
          "Address and port to serve on; port 0 takes a free port; or "
          "unix:PATH, a socket that only this user can open")
      .check(&CheckListen)
      ->capture_default_str();
  AddText(app, "--port-file", options.port_file, "PATH",
          "Write the port that is served on, or the socket's path, to this "
          "file, for scripts");
  AddCount(app, "--max-requests", options.max_requests, kMillion,
           "Requests at once; each may hold a few messages in memory");
  AddCount(app, "--max-connection-streams", options.max_connection_streams,
           kMillion, "Requests at once on one connection; more wait");
  AddSeconds(app, "--receive-seconds", options.receive_patience, 1,
             "How long a message of a request may take to come in");
  AddBytes(app, "--max-message-bytes", options.max_message_bytes,
           "Largest gRPC message taken from a client", kMaxMessageBytes);

  app.option_defaults()->group("Browsers");
  AddText(app, "--web", options.web_listen, "HOST:PORT",
          "Serve a page for browsers here, and the RPCs over gRPC-Web")
      .check(&CheckAddress);
  app.add_option("--web-allow-origin", options.web_origins,
                 "Pages of this origin may call, too, e.g. "
                 "https://geo.example.org; name it for a proxy before --web")
      ->check(&CheckOrigin)
      ->type_name("ORIGIN");
  AddText(app, "--web-token-file", options.web_token_file, "FILE",
          "As --token-file, for those who come to --web, in place of that");
  AddText(app, "--web-port-file", options.web_port_file, "PATH",
          "Write the port of --web to this file, for scripts");

  app.option_defaults()->group("Security");
  AddText(app, "--tls-cert", options.tls.certificate, "FILE",
          "Serve over TLS with this certificate and its chain, in PEM; "
          "a changed file is taken up while the server runs");
  AddText(app, "--tls-key", options.tls.key, "FILE",
          "The certificate's private key");
  AddText(app, "--tls-client-ca", options.tls.client_authorities, "FILE",
          "Let in only clients with a certificate of these authorities");
  AddText(app, "--token-file", options.token_file, "FILE",
          "Serve only callers whose token's sha-256 is in this JSON "
          "file; a changed file is taken up, also on SIGHUP");
  app.add_flag("--insecure-listen", options.insecure_listen,
               "Listen to other machines though there is no TLS: whoever "
               "reaches the port reads and forges everything");

  app.option_defaults()->group("Replicas");
  app.add_option("--sibling", options.siblings,
                 "Ask the server there for meshes that this one lacks; may be "
                 "given several times, also with this server's own address")
      ->check(&CheckAddress)
      ->type_name("HOST:PORT");
  AddText(app, "--sibling-token-file", options.sibling_token_file, "FILE",
          "Ask siblings with the token in this file; a changed file is taken "
          "up");
  AddText(app, "--sibling-ca", options.sibling_authorities, "FILE",
          "Ask siblings over TLS; their certificates are signed by these "
          "authorities, in PEM");

  AddText(app, "--shared-tier", options.shared_tier, "HOST:PORT",
          "Share fields, what is prepared of meshes, and meshes with other "
          "servers in the Redis there, or at unix:PATH; servers of one version "
          "alone share fields")
      .check(&CheckShared);
  AddText(app, "--shared-tier-password-file", options.shared_tier_password_file,
          "FILE",
          "The password of --shared-tier; a changed file is taken up with the "
          "next connection");
  AddSeconds(app, "--shared-tier-seconds", options.shared_tier_expiry, 1,
             "When --shared-tier forgets a value, unless it has to before",
             /*most=*/2'592'000);
  AddBytes(app, "--shared-tier-max-value-bytes",
           options.shared_tier_max_value_bytes,
           "Largest value put into --shared-tier; as much may wait to be "
           "written",
           kMaxMessageBytes / 2);
  AddCount(app, "--shared-tier-timeout-ms", options.shared_tier_timeout_ms,
           1000,
           "Milliseconds a question waits for each 256 KiB of --shared-tier: a "
           "network of 1 Gbit/s takes 2, computing them a hundred; then it "
           "computes them");

  app.option_defaults()->group("Work");
  AddCount(app, "--threads", limits.max_concurrent_jobs, 4096,
           "Jobs (solves and mesh builds) that run at once, one thread each; "
           "default: as many as there are processors")
      .default_str("");
  AddCount(app, "--max-threads-per-solve", limits.max_threads_per_solve,
           kMostSolveThreads,
           "Threads that share one solve while they have no job of their own");
  AddCount(app, "--max-queued-jobs", limits.max_queued_jobs, kMillion,
           "Jobs that may wait for a thread; more are refused, to be retried",
           /*least=*/0);
  AddCount(app, "--max-queued-jobs-per-client",
           limits.max_queued_jobs_per_client, kMillion,
           "Jobs of one client (the name of its token, or its address) that "
           "may wait");

  app.option_defaults()->group("Questions");
  AddCount(app, "--max-sources", limits.max_sources, kMost,
           "Sources of one query");
  AddCount(app, "--max-curve-points", limits.max_curve_points, kMost,
           "Points of all curves of one query");
  AddCount(app, "--max-targets", limits.max_targets, kMost,
           "Targets of one query");
  AddCount(app, "--max-levels", limits.max_levels, kMost,
           "Levels of one request for isolines");
  AddCount(app, "--max-samples", limits.max_samples, kMost,
           "Farthest points sampled by one request");
  AddCount(app, "--max-pairs", limits.max_pairs, kMost,
           "Pairs of one question for their distances");
  AddCount(app, "--max-matrix-rows", limits.max_matrix_rows, kMost,
           "Rows of one matrix; each is a search of its own");
  AddCount(app, "--max-matrix-values", limits.max_matrix_values, kMaxBytes,
           "Rows times columns of one matrix");

  app.option_defaults()->group("Memory");
  AddBytes(app, "--receive-memory", options.receive_memory_bytes,
           "Memory for messages that are still coming in, all together");
  AddBytes(app, "--request-memory", options.request_memory_bytes,
           "Memory for requests in hand: decoded, and as questions");
  AddBytes(app, "--mesh-store", limits.mesh_store_bytes,
           "Memory for resident meshes; the least recently used are evicted");
  AddBytes(app, "--field-cache", limits.field_cache_bytes,
           "Memory for finished fields; the least recently used are evicted");
  AddBytes(app, "--upload-memory", limits.upload_memory_bytes,
           "Memory for uploads on their way to become meshes, all together");
  AddBytes(app, "--solver-memory", limits.solver_memory_bytes,
           "Memory for running solvers, all together");
  AddBytes(app, "--landmark-memory", limits.landmark_memory_bytes,
           "Memory for landmarks, 128 bytes a vertex of meshes whose distances "
           "between points are asked for; the least recently used are evicted; "
           "0 makes none",
           kMaxBytes, /*least=*/0);
  AddBytes(
      app, "--prepared-memory", limits.prepared_memory_bytes,
      "Memory for what approximate algorithms prepare of meshes; the least "
      "recently used is evicted");
  AddBytes(app, "--decimated-memory", limits.decimated_memory_bytes,
           "Memory for decimated meshes, 12 bytes a face, for those who draw "
           "them; the least recently used are evicted");

  app.option_defaults()->group("Disk");
  AddText(app, "--data-dir", options.data_dir, "DIR",
          "Keep meshes and fields in this folder, across restarts and "
          "crashes; made if need be; one server a folder");
  AddBytes(app, "--mesh-disk", limits.mesh_disk_bytes,
           "Disk for meshes in --data-dir; the least recently used are "
           "evicted");
  AddBytes(app, "--field-disk", limits.field_disk_bytes,
           "Disk for fields in --data-dir; the least recently used are "
           "evicted");

  app.option_defaults()->group("Meshes");
  AddBytes(app, "--max-upload-bytes", limits.max_upload_bytes,
           "Largest mesh file or pair of arrays a client may upload");
  AddCount(app, "--max-vertices", limits.max_vertices, kMaxVertices,
           "Vertices of one mesh");
  AddCount(app, "--max-faces", limits.max_faces, kMaxFaces,
           "Triangles of one mesh");

  app.option_defaults()->group("Operation");
  AddSeconds(app, "--drain-seconds", options.drain, 0,
             "After SIGTERM or SIGINT, how long requests may go on before they "
             "are cancelled; a second signal cancels them at once");
  AddSeconds(app, "--exit-when-idle", options.exit_when_idle, 0,
             "End when no request has been in hand for this long; 0 never "
             "does");
  AddText(app, "--metrics-listen", options.metrics_listen, "HOST:PORT",
          "Serve /metrics for Prometheus, /livez and /readyz here, over "
          "HTTP in clear")
      .check(&CheckAddress);
  app.add_flag("--channelz", options.channelz,
               "Show connections and calls to everybody, by gRPC's channelz");
  AddText(app, "--log-level", options.log_level, "LEVEL",
          "Least level that is logged; requests are logged at info")
      .check(CLI::IsMember(
          {"trace", "debug", "info", "warn", "error", "critical", "off"}))
      ->capture_default_str();

  for (const auto& [option, needed] :
       {std::pair{"--web-allow-origin", "--web"},
        {"--web-token-file", "--web"},
        {"--web-port-file", "--web"},
        {"--sibling-token-file", "--sibling"},
        {"--sibling-ca", "--sibling"},
        {"--shared-tier-password-file", "--shared-tier"}}) {
    app.get_option(option)->needs(needed);
  }
}

// "GEODESICD_MAX_FACES" for "max-faces".
std::string EnvironmentName(const std::string& flag) {
  return absl::StrCat("GEODESICD_", absl::AsciiStrToUpper(absl::StrReplaceAll(
                                        flag, {{"-", "_"}})));
}

// CLI11 lets a file win over the environment. In a container the file is in the
// image and operators set the environment, so here the environment wins.
class FileBelowEnvironment final : public CLI::ConfigBase {
 public:
  std::vector<CLI::ConfigItem> from_config(std::istream& input) const override {
    std::vector<CLI::ConfigItem> settings = ConfigBase::from_config(input);
    std::erase_if(settings, [](const CLI::ConfigItem& item) {
      return std::getenv(EnvironmentName(item.name).c_str()) != nullptr;
    });
    return settings;
  }
};

// The arguments in the order CLI11 takes them, last first. CLI11 reads the
// file before the environment, so the file's own variable becomes a flag.
std::vector<std::string> ArgumentsInReverse(int argc, const char* const* argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool has_flag = std::any_of(
      arguments.begin(), arguments.end(),
      [](const auto& argument) { return argument.starts_with("--config"); });
  const char* file = std::getenv("GEODESICD_CONFIG");
  if (file != nullptr && !has_flag) {
    arguments.insert(arguments.begin(), absl::StrCat("--config=", file));
  }
  std::reverse(arguments.begin(), arguments.end());
  return arguments;
}

std::string CheckTogether(const ServerOptions& options) {
  const TlsFiles& tls = options.tls;
  if (tls.certificate.empty() != tls.key.empty()) {
    return "--tls-cert and --tls-key belong together";
  }
  if (!tls.client_authorities.empty() && !tls.enabled()) {
    return "--tls-client-ca needs --tls-cert and --tls-key";
  }
  if (!tls.enabled() && !options.insecure_listen &&
      !IsLoopback(options.listen)) {
    return absl::StrCat("--listen ", options.listen,
                        " would serve other machines in clear: give --tls-cert "
                        "and --tls-key, or --insecure-listen if that is meant");
  }
  if (!options.web_listen.empty() && !tls.client_authorities.empty()) {
    return "--web cannot ask browsers for certificates, so it does not go with "
           "--tls-client-ca";
  }
  if (!options.web_listen.empty() && !tls.enabled() &&
      !options.insecure_listen && !IsLoopback(options.web_listen)) {
    return absl::StrCat("--web ", options.web_listen,
                        " would serve other machines in clear: give --tls-cert "
                        "and --tls-key, put a proxy with TLS in front of a "
                        "loopback address, or give --insecure-listen if that "
                        "is meant");
  }
  const Limits& limits = options.limits;
  struct Pair {
    const char* part;
    uint64_t bytes;
    const char* whole;
    uint64_t room;
  };
  for (const auto& [part, bytes, whole, room] :
       {Pair{"--max-message-bytes", options.max_message_bytes,
             "--receive-memory", options.receive_memory_bytes},
        Pair{"--max-message-bytes", options.max_message_bytes,
             "--request-memory", options.request_memory_bytes},
        Pair{"--max-upload-bytes", limits.max_upload_bytes, "--upload-memory",
             limits.upload_memory_bytes}}) {
    if (bytes <= room) continue;
    return absl::StrCat(part, " (", InUnits(bytes), ") must not exceed ", whole,
                        " (", InUnits(room), ")");
  }
  return "";
}

// Gives `app` all settings, which write into `options`.
void AddAll(const std::string& version, CLI::App& app, ServerOptions& options) {
  app.name("geodesicd");
  app.description(
      "Serves exact geodesic distances on triangle meshes over gRPC.");
  app.set_version_flag("--version", "geodesicd " + version);
  app.set_config("--config", "", "Read settings from this TOML or INI file")
      ->type_name("FILE");
  app.config_formatter(std::make_shared<FileBelowEnvironment>());
  app.allow_config_extras(CLI::config_extras_mode::error);
  AddOptions(app, options);
  for (CLI::Option* option : app.get_options()) {
    const std::string name = option->get_single_name();
    if (name == "help" || name == "version") continue;
    option->envname(EnvironmentName(name));
  }
  app.footer(
      "BYTES take a unit: B, KiB, MiB, GiB, or KB, MB, GB. A setting comes\n"
      "from its flag, else from its environment variable, else from the file,\n"
      "where it has the flag's name without dashes in front:\n"
      "  listen = \"0.0.0.0:50051\"\n"
      "  field-cache = \"2GiB\"\n\n"
      "Exit codes: 0 stopped in order; 1 could not start; 2 wrong usage;\n"
      "3 stopped, but requests had to be cancelled.");
}

}  // namespace

CommandLine ParseCommandLine(int argc, const char* const* argv,
                             const std::string& version) {
  CommandLine result;
  ServerOptions& options = result.options;

  CLI::App app;
  AddAll(version, app, options);

  try {
    app.parse(ArgumentsInReverse(argc, argv));
    if (const std::string error = CheckTogether(options); !error.empty()) {
      throw CLI::ValidationError(error);
    }
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    result.exit_code = code == 0 ? 0 : kUsageError;
  }
  if (options.data_dir.empty()) {
    options.limits.mesh_disk_bytes = 0;
    options.limits.field_disk_bytes = 0;
  }
  return result;
}

manual::Page ProgramPage() {
  ServerOptions options;
  CLI::App app;
  AddAll("", app, options);
  return manual::Describe(app);
}

}  // namespace geodesic::server
