// capabilities, and the choice among all commands.

#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "client/cli/commands.h"
#include "client/cli/text.h"
#include "geodesic_client/errors.h"

namespace geodesic::client {

absl::Status RunCapabilities(const Session& session) {
  absl::StatusOr<Capabilities> capabilities =
      session.client.GetCapabilities(session.call);
  if (!capabilities.ok()) return capabilities.status();
  if (session.arguments.json) {
    PrintJson(ToJson(*capabilities), &session.out);
    return absl::OkStatus();
  }
  const ServerLimits& limits = capabilities->limits;
  std::vector<Fact> facts = {
      {"server", session.arguments.server},
      {"version", capabilities->version},
      {"formats", absl::StrJoin(capabilities->formats, ", ")}};
  for (const AlgorithmCapability& algorithm : capabilities->algorithms) {
    facts.push_back({absl::StrCat("algorithm ", algorithm.name),
                     absl::StrCat(algorithm.summary,
                                  algorithm.is_default ? " (default)" : "")});
  }
  const std::vector<Fact> limit_facts = {
      {"largest upload", ByteCount(limits.max_upload_bytes)},
      {"most vertices", GroupedNumber(limits.max_vertices)},
      {"most faces", GroupedNumber(limits.max_faces)},
      {"most sources", GroupedNumber(limits.max_sources)},
      {"most curve points", GroupedNumber(limits.max_curve_points)},
      {"most targets", GroupedNumber(limits.max_targets)},
      {"most levels", GroupedNumber(limits.max_levels)},
      {"most samples", GroupedNumber(limits.max_samples)},
      {"most matrix rows", GroupedNumber(limits.max_matrix_rows)},
      {"most matrix values", GroupedNumber(limits.max_matrix_values)},
      {"largest message", ByteCount(limits.max_message_bytes)},
      {"concurrent jobs", GroupedNumber(limits.max_concurrent_jobs)},
      {"queued jobs", GroupedNumber(limits.max_queued_jobs)},
      {"queued jobs a client",
       GroupedNumber(limits.max_queued_jobs_per_client)},
      {"mesh store", ByteCount(limits.mesh_store_bytes)},
      {"field cache", ByteCount(limits.field_cache_bytes)},
      {"computation store", ByteCount(limits.computation_store_bytes)},
      {"mesh disk", ByteCount(limits.mesh_disk_bytes)},
      {"field disk", ByteCount(limits.field_disk_bytes)}};
  facts.insert(facts.end(), limit_facts.begin(), limit_facts.end());
  PrintFacts(facts, &session.out);
  return absl::OkStatus();
}

namespace {

absl::Status RunOnce(const Session& session) {
  switch (session.arguments.command) {
    case Command::kUpload:
      return RunUpload(session);
    case Command::kMeshes:
      return RunMeshes(session);
    case Command::kInfo:
      return RunInfo(session);
    case Command::kDelete:
      return RunDelete(session);
    case Command::kField:
      return RunField(session);
    case Command::kPath:
      return RunPath(session);
    case Command::kIsolines:
      return RunIsolines(session);
    case Command::kMatrix:
      return RunMatrix(session);
    case Command::kNearest:
      return RunNearest(session);
    case Command::kSample:
      return RunSample(session);
    case Command::kLogMap:
      return RunLogMap(session);
    case Command::kCapabilities:
      return RunCapabilities(session);
  }
  return absl::InternalError("unknown command");
}

}  // namespace

absl::Status RunCommand(const Session& session) {
  absl::Status status = RunOnce(session);
  // A file that was found resident, or was uploaded, may have been evicted
  // before the question came; asking anew uploads it again.
  std::error_code error;
  if (ErrorReason(status) == "MESH_NOT_RESIDENT" &&
      std::filesystem::exists(session.arguments.mesh, error)) {
    status = RunOnce(session);
  }
  return status;
}

}  // namespace geodesic::client
