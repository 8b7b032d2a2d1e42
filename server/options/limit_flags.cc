#include "server/options/limit_flags.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
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

void AddClients(CLI::App& app, ServerOptions& options) {
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
  AddCount(app, "--max-threads-per-solve", options.limits.max_threads_per_solve,
           kMostSolveThreads,
           "Threads that share one solve while they have no job of their own");
  AddCount(app, "--max-queued-jobs", options.limits.max_queued_jobs, kMillion,
           "Jobs that may wait for a thread; more are refused, to be retried",
           /*least=*/0);
  AddCount(app, "--max-queued-jobs-per-client",
           options.limits.max_queued_jobs_per_client, kMillion,
           "Jobs of one client (the name of its token, or its address) that "
           "may wait");
}

void AddQuestions(CLI::App& app, Limits& limits) {
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

void AddMeshes(CLI::App& app, Limits& limits) {
  AddBytes(app, "--max-upload-bytes", limits.max_upload_bytes,
           "Largest mesh file or pair of arrays a client may upload");
  AddCount(app, "--max-vertices", limits.max_vertices, kMaxVertices,
           "Vertices of one mesh");
  AddCount(app, "--max-faces", limits.max_faces, kMaxFaces,
           "Triangles of one mesh");
}

// Parts of --memory and of --disk.
void AddBudgets(CLI::App& app, ServerOptions& options) {
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
  AddBytes(app, "--mesh-disk", options.limits.mesh_disk_bytes,
           "Disk for meshes in --data-dir; the least recently used are "
           "evicted");
  AddBytes(app, "--field-disk", options.limits.field_disk_bytes,
           "Disk for fields in --data-dir; the least recently used are "
           "evicted");
}

void AddSharedTier(CLI::App& app, ServerOptions& options) {
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

// The limits as options of a program that has no others, so that they are read,
// bounded and explained as flags are.
void AddLimits(CLI::App& app, ServerOptions& options) {
  app.set_help_flag();
  AddClients(app, options);
  AddQuestions(app, options.limits);
  AddMeshes(app, options.limits);
  AddBudgets(app, options);
  AddSharedTier(app, options);
}

}  // namespace

void SetLimits(const std::vector<std::string>& chosen, ServerOptions& options) {
  CLI::App app;
  AddLimits(app, options);
  std::vector<std::string> arguments;
  for (const std::string& text : chosen) {
    const std::string name = text.substr(0, text.find('='));
    if (name.size() == text.size() || name.empty() ||
        app.get_option_no_throw("--" + name) == nullptr) {
      throw CLI::ValidationError(
          absl::StrCat("--limit ", text,
                       ": write NAME=VALUE, with a name that --help lists"));
    }
    arguments.push_back("--" + text);
  }
  try {
    // CLI11 takes them last first.
    std::ranges::reverse(arguments);
    app.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    throw CLI::ValidationError(
        absl::StrCat("--limit ", std::string(error.what()).substr(2)));
  }
}

std::string ExplainLimits(ServerOptions options) {
  CLI::App app;
  AddLimits(app, options);
  std::string text = "Limits, for --limit:\n";
  for (const CLI::Option* option : app.get_options()) {
    absl::StrAppend(&text, "  ", option->get_lnames()[0], "=",
                    option->get_default_str(), "\n      ",
                    option->get_description(), "\n");
  }
  return text;
}

}  // namespace geodesic::server
