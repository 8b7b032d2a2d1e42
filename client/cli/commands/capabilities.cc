// capabilities: the server's version, algorithms, formats and limits.

#include <array>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "client/cli/commands/command.h"
#include "client/cli/terminal/text.h"

namespace geodesic::client {
namespace {

struct Limit {
  const char* key;
  const char* label;
  uint64_t ServerLimits::*value;
  std::string (*text)(uint64_t) = GroupedNumber;
};

constexpr std::array kLimits = {
    Limit{"max_upload_bytes", "largest upload", &ServerLimits::max_upload_bytes,
          ByteCount},
    Limit{"max_vertices", "most vertices", &ServerLimits::max_vertices},
    Limit{"max_faces", "most faces", &ServerLimits::max_faces},
    Limit{"max_sources", "most sources", &ServerLimits::max_sources},
    Limit{"max_curve_points", "most curve points",
          &ServerLimits::max_curve_points},
    Limit{"max_targets", "most targets", &ServerLimits::max_targets},
    Limit{"max_levels", "most levels", &ServerLimits::max_levels},
    Limit{"max_samples", "most samples", &ServerLimits::max_samples},
    Limit{"max_pairs", "most pairs", &ServerLimits::max_pairs},
    Limit{"max_matrix_rows", "most matrix rows",
          &ServerLimits::max_matrix_rows},
    Limit{"max_matrix_values", "most matrix values",
          &ServerLimits::max_matrix_values},
    Limit{"max_message_bytes", "largest message",
          &ServerLimits::max_message_bytes, ByteCount},
    Limit{"max_concurrent_jobs", "concurrent jobs",
          &ServerLimits::max_concurrent_jobs},
    Limit{"max_queued_jobs", "queued jobs", &ServerLimits::max_queued_jobs},
    Limit{"max_queued_jobs_per_client", "queued jobs a client",
          &ServerLimits::max_queued_jobs_per_client},
    Limit{"mesh_store_bytes", "mesh store", &ServerLimits::mesh_store_bytes,
          ByteCount},
    Limit{"field_cache_bytes", "field cache", &ServerLimits::field_cache_bytes,
          ByteCount},
    Limit{"landmark_memory_bytes", "landmark memory",
          &ServerLimits::landmark_memory_bytes, ByteCount},
    Limit{"prepared_memory_bytes", "prepared memory",
          &ServerLimits::prepared_memory_bytes, ByteCount},
    Limit{"mesh_disk_bytes", "mesh disk", &ServerLimits::mesh_disk_bytes,
          ByteCount},
    Limit{"field_disk_bytes", "field disk", &ServerLimits::field_disk_bytes,
          ByteCount}};

Json ToJson(const Capabilities& capabilities) {
  Json algorithms = Json::array();
  for (const AlgorithmCapability& algorithm : capabilities.algorithms) {
    algorithms.push_back({{"name", algorithm.name},
                          {"summary", algorithm.summary},
                          {"is_default", algorithm.is_default}});
  }
  Json approximate = Json::array();
  for (const auto& algorithm : capabilities.approximate_algorithms) {
    approximate.push_back(
        {{"name", algorithm.name}, {"summary", algorithm.summary}});
  }
  Json limits = Json::object();
  for (const Limit& limit : kLimits) {
    limits[limit.key] = capabilities.limits.*limit.value;
  }
  return {{"version", capabilities.version},
          {"algorithms", algorithms},
          {"approximate_algorithms", approximate},
          {"formats", capabilities.formats},
          {"limits", limits}};
}

absl::Status ShowCapabilities(const NoArguments&, const Session& session) {
  absl::StatusOr<Capabilities> capabilities =
      session.client.GetCapabilities(session.call);
  if (!capabilities.ok()) return capabilities.status();
  if (session.json) {
    *session.json = ToJson(*capabilities);
    return absl::OkStatus();
  }
  std::vector<Fact> facts = {
      {"server", session.server},
      {"version", capabilities->version},
      {"formats", absl::StrJoin(capabilities->formats, ", ")}};
  for (const AlgorithmCapability& algorithm : capabilities->algorithms) {
    facts.push_back({absl::StrCat("algorithm ", algorithm.name),
                     absl::StrCat(algorithm.summary,
                                  algorithm.is_default ? " (default)" : "")});
  }
  for (const auto& algorithm : capabilities->approximate_algorithms) {
    facts.push_back(
        {absl::StrCat("approximate ", algorithm.name), algorithm.summary});
  }
  for (const Limit& limit : kLimits) {
    facts.push_back(
        {limit.label, limit.text(capabilities->limits.*limit.value)});
  }
  PrintFacts(facts, &session.out);
  return absl::OkStatus();
}

}  // namespace

Command CapabilitiesCommand() {
  return MakeCommand<NoArguments>(
      "capabilities", "Show the server's version, algorithms and limits",
      "  geodesic capabilities --json", AddNoOptions, ShowCapabilities);
}

}  // namespace geodesic::client
