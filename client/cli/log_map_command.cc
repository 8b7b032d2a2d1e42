// logmap: directions and distances around a point.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/cli/commands.h"
#include "client/cli/question.h"
#include "client/output/field_writers.h"
#include "client/output/place_text.h"

namespace geodesic::client {
namespace {

// The source as a point; curves are not among what logmap takes.
SurfacePoint PointOf(const Source& source) {
  SurfacePoint point;
  std::visit(
      [&point](const auto& place) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(place)>, Curve>) {
          point = place;
        }
      },
      source.place);
  return point;
}

// u and v; in one column of pairs, or one each.
Column Pairs(const LogMap& map, NumberType type) {
  Column pairs = {.name = "uv", .components = 2, .type = type};
  for (const auto& uv : map.coordinates) {
    pairs.values.insert(pairs.values.end(), uv.begin(), uv.end());
  }
  return pairs;
}
std::vector<Column> UAndV(const LogMap& map, NumberType type) {
  std::vector<Column> columns = {{.name = "u", .type = type},
                                 {.name = "v", .type = type}};
  for (const auto& uv : map.coordinates) {
    columns[0].values.push_back(uv[0]);
    columns[1].values.push_back(uv[1]);
  }
  return columns;
}

absl::StatusOr<std::vector<WrittenFile>> Write(const Session& session,
                                               const LogMap& map) {
  const NumberType type =
      session.arguments.float32 ? NumberType::kFloat32 : NumberType::kFloat64;
  MeshOnDemand mesh(session, map.info.mesh_digest);
  return WriteOutputs(
      session, [&](const OutputArgument& output) -> absl::StatusOr<uint64_t> {
        const MeshArrays* arrays = nullptr;
        if (output.format == OutputFormat::kPly) {
          absl::StatusOr<const MeshArrays*> got =
              mesh.Get(map.coordinates.size());
          if (!got.ok()) return got.status();
          arrays = *got;
        }
        return WriteFile(output.path, [&](AtomicFile* file) {
          if (output.format == OutputFormat::kNpy) {
            WriteNpy(Pairs(map, type), file);
          } else if (output.format == OutputFormat::kCsv) {
            WriteCsv(UAndV(map, type), file);
          } else {
            WritePly(*arrays, UAndV(map, type), file);
          }
          return absl::OkStatus();
        });
      });
}

}  // namespace

absl::Status RunLogMap(const Session& session) {
  const Arguments& arguments = session.arguments;
  absl::StatusOr<Question> question = Prepare(session);
  if (!question.ok()) return question.status();
  Stopwatch watch(session);
  absl::StatusOr<LogMap> map = session.client.ComputeLogMap(
      {.mesh_digest = question->mesh_digest,
       .source = PointOf(question->sources[0]),
       .algorithm = arguments.algorithm,
       .value_type =
           arguments.float32 ? ValueType::kFloat32 : ValueType::kFloat64,
       .max_distance = arguments.radius,
       .priority = arguments.priority},
      session.call, watch.OnSolve());
  if (!map.ok()) return map.status();
  const double seconds = watch.seconds();
  absl::StatusOr<std::vector<WrittenFile>> files = Write(session, *map);
  if (!files.ok()) return files.status();

  uint64_t mapped = 0;
  double largest = 0;
  for (const auto& [u, v] : map->coordinates) {
    if (std::isnan(u)) continue;
    ++mapped;
    largest = std::max(largest, std::hypot(u, v));
  }
  const Point& zero = map->zero_direction;
  if (arguments.json) {
    Json json = AnswerJson(*question, map->info, seconds);
    json["vertices"] = map->coordinates.size();
    json["mapped_vertices"] = mapped;
    json["max_distance"] = largest;
    json["zero_direction"] = zero;
    json["outputs"] = ToJson(*files);
    PrintJson(json, &session.out);
    return absl::OkStatus();
  }
  std::vector<Fact> facts = {
      {"mesh", map->info.mesh_digest},
      {"algorithm", map->info.algorithm},
      {"source", SourceText(question->sources[0])},
      {"angle 0", absl::StrCat(ShortNumber(zero[0]), " ", ShortNumber(zero[1]),
                               " ", ShortNumber(zero[2]))},
      {"mapped",
       absl::StrCat(GroupedNumber(mapped), " of ",
                    GroupedNumber(map->coordinates.size()), " vertices")},
      {"largest distance", ShortNumber(largest)}};
  AddClosingFacts(map->info, seconds, *files, &facts);
  PrintFacts(facts, &session.out);
  return absl::OkStatus();
}

}  // namespace geodesic::client
