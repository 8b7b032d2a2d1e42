// field: computes a distance field and writes it to files.

#include <chrono>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/cli/commands.h"
#include "client/cli/mesh_argument.h"
#include "client/cli/text.h"
#include "client/output/output_format.h"

namespace geodesic::client {
namespace {

using Clock = std::chrono::steady_clock;

// What the distances have in common.
struct FieldExtremes {
  // 0 if no vertex is reached.
  double largest = 0;
  uint64_t farthest_vertex = 0;
  uint64_t unreachable = 0;
};

FieldExtremes ExtremesOf(const std::vector<double>& distances) {
  FieldExtremes extremes;
  for (size_t vertex = 0; vertex < distances.size(); ++vertex) {
    if (!std::isfinite(distances[vertex])) {
      ++extremes.unreachable;
    } else if (distances[vertex] > extremes.largest) {
      extremes.largest = distances[vertex];
      extremes.farthest_vertex = vertex;
    }
  }
  return extremes;
}

struct WrittenFile {
  OutputArgument output;
  uint64_t bytes = 0;
};

absl::StatusOr<Field> Compute(const Session& session,
                              const std::string& digest) {
  ProgressDisplay display(session.progress_style, session.terminal_width,
                          Clock::now(), &session.err);
  const FieldQuery query = {.mesh_digest = digest,
                            .sources = session.arguments.sources,
                            .algorithm = session.arguments.algorithm};
  return session.client.ComputeField(
      query, session.call, [&display](const FieldProgress& progress) {
        const bool waits =
            progress.vertices_reached == 0 && progress.windows_propagated == 0;
        const double fraction =
            progress.vertex_count == 0
                ? 0
                : static_cast<double>(progress.vertices_reached) /
                      static_cast<double>(progress.vertex_count);
        display.Update(
            Clock::now(), waits ? "waiting" : "solving", fraction,
            waits
                ? "for a free thread"
                : absl::StrCat(
                      "settled to ", ShortNumber(progress.settled_radius), ", ",
                      GroupedNumber(progress.windows_propagated), " windows"));
      });
}

absl::StatusOr<std::vector<WrittenFile>> WriteAll(const Session& session,
                                                  const Field& field) {
  OutputContent content = {.distances = &field.distances,
                           .picture = session.arguments.picture};
  for (const Source& source : session.arguments.sources) {
    content.sources.push_back(source.vertex);
  }
  MeshArrays mesh;
  std::vector<WrittenFile> written;
  for (const OutputArgument& output : session.arguments.outputs) {
    if (session.call.stop.stop_requested()) {
      return absl::CancelledError("stopped before all files were written");
    }
    if (NeedsMesh(output.format) && content.mesh == nullptr) {
      absl::StatusOr<MeshArrays> read =
          session.client.ReadMesh(field.mesh_digest, session.call);
      if (!read.ok()) return read.status();
      if (read->positions.size() != field.distances.size()) {
        return absl::DataLossError(
            absl::StrCat("the server sent a mesh of ", read->positions.size(),
                         " vertices and a field of ", field.distances.size()));
      }
      mesh = *std::move(read);
      content.mesh = &mesh;
    }
    absl::StatusOr<uint64_t> bytes =
        WriteOutput(output.path, output.format, content);
    if (!bytes.ok()) return FileError(bytes.status());
    written.push_back({output, *bytes});
  }
  return written;
}

Json ToJson(const Session& session, const Field& field,
            const std::vector<WrittenFile>& files, double seconds) {
  const FieldExtremes extremes = ExtremesOf(field.distances);
  Json sources = Json::array();
  for (const Source& source : session.arguments.sources) {
    sources.push_back({{"vertex", source.vertex}, {"offset", source.offset}});
  }
  Json outputs = Json::array();
  for (const WrittenFile& file : files) {
    outputs.push_back(
        {{"path", file.output.path},
         {"format", std::string(OutputFormatName(file.output.format))},
         {"bytes", file.bytes}});
  }
  return {{"mesh", field.mesh_digest},
          {"algorithm", field.algorithm},
          {"sources", sources},
          {"origin", std::string(FieldOriginName(field.origin))},
          {"vertices", field.distances.size()},
          {"unreachable_vertices", extremes.unreachable},
          {"max_distance", extremes.largest},
          {"farthest_vertex", extremes.farthest_vertex},
          {"relative_tolerance", field.relative_tolerance},
          {"statistics", client::ToJson(field.statistics)},
          {"call_seconds", seconds},
          {"server_version", field.server_version},
          {"outputs", outputs}};
}

void Print(const Session& session, const Field& field,
           const std::vector<WrittenFile>& files, double seconds) {
  const FieldExtremes extremes = ExtremesOf(field.distances);
  const FieldStatistics& statistics = field.statistics;
  std::vector<Fact> facts = {
      {"mesh", field.mesh_digest},
      {"algorithm", field.algorithm},
      {"origin", std::string(FieldOriginName(field.origin))},
      {"vertices", GroupedNumber(field.distances.size())},
      {"largest distance",
       absl::StrCat(ShortNumber(extremes.largest), " at vertex ",
                    extremes.farthest_vertex)}};
  if (extremes.unreachable != 0) {
    facts.push_back(
        {"unreachable",
         absl::StrCat(GroupedNumber(extremes.unreachable), " vertices")});
  }
  facts.push_back(
      {"windows",
       absl::StrCat(GroupedNumber(statistics.windows_created), " created, ",
                    GroupedNumber(statistics.windows_propagated),
                    " propagated")});
  facts.push_back({"solver", Seconds(statistics.solve_seconds)});
  facts.push_back({"this call", Seconds(seconds)});
  for (const WrittenFile& file : files) {
    facts.push_back({"wrote", absl::StrCat(file.output.path, " (",
                                           ByteCount(file.bytes), ")")});
  }
  PrintFacts(facts, &session.out);
}

}  // namespace

absl::Status RunField(const Session& session) {
  for (const OutputArgument& output : session.arguments.outputs) {
    absl::Status status = CheckWritable(output.path);
    if (!status.ok()) return FileError(status);
  }
  absl::StatusOr<std::string> digest = ResolveMesh(session);
  if (!digest.ok()) return digest.status();
  const Clock::time_point start = Clock::now();
  absl::StatusOr<Field> field = Compute(session, *digest);
  if (!field.ok()) return field.status();
  const std::chrono::duration<double> elapsed = Clock::now() - start;
  absl::StatusOr<std::vector<WrittenFile>> files = WriteAll(session, *field);
  if (!files.ok()) return files.status();
  if (session.arguments.json) {
    PrintJson(ToJson(session, *field, *files, elapsed.count()), &session.out);
  } else {
    Print(session, *field, *files, elapsed.count());
  }
  return absl::OkStatus();
}

}  // namespace geodesic::client
