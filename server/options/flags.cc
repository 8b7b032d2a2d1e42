#include "server/options/flags.h"

#include <algorithm>
#include <string>
#include <thread>
#include <utility>

#include "server/options/flag_types.h"
#include "server/options/memory.h"

namespace geodesic::server {
namespace {

void AddNetwork(CLI::App& app, ServerOptions& options) {
  app.option_defaults()->group("Network");
  AddText(app, "--listen", options.listen, "HOST:PORT",
          "Address and port to serve on; port 0 takes a free port; or "
          "unix:PATH, a socket that only this user can open")
      .check(&CheckListen)
      ->capture_default_str();
  AddText(app, "--port-file", options.port_file, "PATH",
          "Write the port that is served on, or the socket's path, to this "
          "file, for scripts");
}

void AddBrowsers(CLI::App& app, ServerOptions& options) {
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
}

void AddSecurity(CLI::App& app, ServerOptions& options) {
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
}

void AddReplicas(CLI::App& app, ServerOptions& options) {
  app.option_defaults()->group("Replicas");
  AddText(app, "--shared-tier", options.shared_tier, "HOST:PORT",
          "Share fields, what is prepared of meshes, and meshes with other "
          "servers in the Redis there, or at unix:PATH; servers of one version "
          "alone share fields")
      .check(&CheckShared);
  AddText(app, "--shared-tier-password-file", options.shared_tier_password_file,
          "FILE",
          "The password of --shared-tier; a changed file is taken up with the "
          "next connection");
}

void AddResources(CLI::App& app, ServerOptions& options) {
  app.option_defaults()->group("Resources");
  AddCount(
      app, "--threads", options.limits.max_concurrent_jobs, 4096,
      "Jobs (solves and mesh builds) that run at once, one thread each, beside "
      "those that have run long when another client asks; default: as many as "
      "there are processors")
      .default_str("");
  AddBytes(app, "--memory", options.memory_bytes,
           "Memory for meshes, fields, solvers and requests, all together; "
           "default: three quarters of the machine's, or of what the control "
           "group may have",
           kMaxBytes, kLeastMemory);
  AddText(app, "--data-dir", options.data_dir, "DIR",
          "Keep meshes and fields in this folder, across restarts and "
          "crashes; made if need be; one server a folder");
  AddBytes(app, "--disk", options.disk_bytes,
           "Disk for meshes and fields in --data-dir; the least recently used "
           "are evicted");
  app.add_option("--limit", options.chosen_limits,
                 "Set one of the limits below; may be given several times, or "
                 "with several behind each other, with commas")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE");
}

void AddOperation(CLI::App& app, ServerOptions& options) {
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
  AddText(app, "--log-level", options.log_level, "LEVEL",
          "Least level that is logged; requests are logged at info")
      .check(CLI::IsMember(
          {"trace", "debug", "info", "warn", "error", "critical", "off"}))
      ->capture_default_str();
}

}  // namespace

void AddFlags(CLI::App& app, ServerOptions& options) {
  options.memory_bytes = UsualMemory();
  options.limits.max_concurrent_jobs =
      std::max<uint64_t>(1, std::thread::hardware_concurrency());
  AddNetwork(app, options);
  AddBrowsers(app, options);
  AddSecurity(app, options);
  AddReplicas(app, options);
  AddResources(app, options);
  AddOperation(app, options);
  for (const auto& [option, needed] :
       {std::pair{"--web-allow-origin", "--web"},
        {"--web-token-file", "--web"},
        {"--web-port-file", "--web"},
        {"--shared-tier-password-file", "--shared-tier"}}) {
    app.get_option(option)->needs(needed);
  }
}

}  // namespace geodesic::server
