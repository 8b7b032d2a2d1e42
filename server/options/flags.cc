#include "server/options/flags.h"

#include <algorithm>
#include <string>
#include <thread>
#include <utility>

#include "geodesic/solve_options.h"
#include "server/options/flag_types.h"

namespace geodesic::server {
namespace {

// gRPC counts a message's bytes in an int.
constexpr uint64_t kMaxMessageBytes = uint64_t{1} << 30;

// The bound of core's 32-bit half-edge numbers.
constexpr uint64_t kMaxFaces = (uint64_t{1} << 32) / 3 - 1;
constexpr uint64_t kMaxVertices = uint64_t{1} << 31;

constexpr uint64_t kMillion = 1'000'000;
constexpr uint64_t kMost = 100 * kMillion;

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
  AddCount(app, "--max-requests", options.max_requests, kMillion,
           "Requests at once; each may hold a few messages in memory");
  AddCount(app, "--max-connection-streams", options.max_connection_streams,
           kMillion, "Requests at once on one connection; more wait");
  AddSeconds(app, "--receive-seconds", options.receive_patience, 1,
             "How long a message of a request may take to come in");
  AddSeconds(app, "--send-seconds", options.send_patience, 1,
             "How long a client may take nothing of its answer");
  AddBytes(app, "--max-message-bytes", options.max_message_bytes,
           "Largest gRPC message taken from a client", kMaxMessageBytes);
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
}

void AddWork(CLI::App& app, Limits& limits) {
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
}

void AddQuestions(CLI::App& app, Limits& limits) {
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
}

void AddMemory(CLI::App& app, ServerOptions& options) {
  app.option_defaults()->group("Memory");
  AddBytes(app, "--receive-memory", options.receive_memory_bytes,
           "Memory for messages that are still coming in, all together");
  AddBytes(app, "--request-memory", options.request_memory_bytes,
           "Memory for requests in hand: decoded, and as questions");
  AddBytes(app, "--mesh-store", options.limits.mesh_store_bytes,
           "Memory for resident meshes; the least recently used are evicted");
  AddBytes(app, "--field-cache", options.limits.field_cache_bytes,
           "Memory for finished fields; the least recently used are evicted");
  AddBytes(app, "--upload-memory", options.limits.upload_memory_bytes,
           "Memory for uploads on their way to become meshes, all together");
  AddBytes(app, "--solver-memory", options.limits.solver_memory_bytes,
           "Memory for running solvers, all together");
  AddBytes(app, "--landmark-memory", options.limits.landmark_memory_bytes,
           "Memory for landmarks, 128 bytes a vertex of meshes whose distances "
           "between points are asked for; the least recently used are evicted; "
           "0 makes none",
           kMaxBytes, /*least=*/0);
  AddBytes(
      app, "--prepared-memory", options.limits.prepared_memory_bytes,
      "Memory for what approximate algorithms prepare of meshes; the least "
      "recently used is evicted");
}

void AddDisk(CLI::App& app, ServerOptions& options) {
  app.option_defaults()->group("Disk");
  AddText(app, "--data-dir", options.data_dir, "DIR",
          "Keep meshes and fields in this folder, across restarts and "
          "crashes; made if need be; one server a folder");
  AddBytes(app, "--mesh-disk", options.limits.mesh_disk_bytes,
           "Disk for meshes in --data-dir; the least recently used are "
           "evicted");
  AddBytes(app, "--field-disk", options.limits.field_disk_bytes,
           "Disk for fields in --data-dir; the least recently used are "
           "evicted");
}

void AddMeshes(CLI::App& app, Limits& limits) {
  app.option_defaults()->group("Meshes");
  AddBytes(app, "--max-upload-bytes", limits.max_upload_bytes,
           "Largest mesh file or pair of arrays a client may upload");
  AddCount(app, "--max-vertices", limits.max_vertices, kMaxVertices,
           "Vertices of one mesh");
  AddCount(app, "--max-faces", limits.max_faces, kMaxFaces,
           "Triangles of one mesh");
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
  app.add_flag("--channelz", options.channelz,
               "Show connections and calls to everybody, by gRPC's channelz");
  AddText(app, "--log-level", options.log_level, "LEVEL",
          "Least level that is logged; requests are logged at info")
      .check(CLI::IsMember(
          {"trace", "debug", "info", "warn", "error", "critical", "off"}))
      ->capture_default_str();
}

}  // namespace

void AddFlags(CLI::App& app, ServerOptions& options) {
  Limits& limits = options.limits;
  limits.max_concurrent_jobs =
      std::max<uint64_t>(1, std::thread::hardware_concurrency());
  limits.mesh_disk_bytes = uint64_t{64} << 30;
  limits.field_disk_bytes = uint64_t{16} << 30;
  AddNetwork(app, options);
  AddBrowsers(app, options);
  AddSecurity(app, options);
  AddReplicas(app, options);
  AddWork(app, limits);
  AddQuestions(app, limits);
  AddMemory(app, options);
  AddDisk(app, options);
  AddMeshes(app, limits);
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
