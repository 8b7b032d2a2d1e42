// logmap: directions and distances around a point.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/cli/arguments/surface_text.h"
#include "client/cli/commands/command.h"
#include "client/cli/commands/question.h"
#include "client/output/field_writers.h"
#include "client/output/place_text.h"

namespace geodesic::client {
namespace {

struct LogMapArguments {
  // The source is a point without an offset.
  QuestionArguments question;
  SurfacePoint source;
  std::optional<double> radius;
  bool float32 = false;
};

void AddOptions(CLI::App* app, LogMapArguments* arguments) {
  AddMesh(app, kMeshHelp, &arguments->question.mesh);
  AddText(app,
          {.name = "-s,--source",
           .help = "The middle of the map, a POINT: VERTEX, edge:A-B@T or "
                   "face:F@W0,W1,W2",
           .type = "POINT",
           .required = true},
          [arguments](const std::string& text) {
            absl::StatusOr<SurfacePoint> point = ParsePoint(text);
            if (!point.ok()) return point.status();
            arguments->source = *point;
            Source& source = arguments->question.sources.points.emplace_back();
            std::visit([&source](const auto& at) { source.place = at; },
                       *point);
            return absl::OkStatus();
          });
  AddRadius(app, "End the map at this distance", &arguments->radius);
  AddFloat32(app, &arguments->float32);
  AddQuestion(app, "Write u and v of every vertex here", kLogMapFormats,
              &arguments->question);
  AddCheck(app, [arguments] {
    if (arguments->question.sources.points.size() != 1) {
      Refuse("--source", "a log map has one source");
    }
  });
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
                                               const LogMapArguments& arguments,
                                               const LogMap& map) {
  const NumberType type = NumberTypeOf(arguments.float32);
  MeshOnDemand mesh(session, map.info.mesh_digest);
  return WriteOutputs(
      session, arguments.question.outputs,
      [&](const OutputArgument& output) -> absl::StatusOr<uint64_t> {
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

Report ReportOf(const SurfacePoint& source, const LogMap& map) {
  uint64_t mapped = 0;
  double largest = 0;
  for (const auto& [u, v] : map.coordinates) {
    if (std::isnan(u)) continue;
    ++mapped;
    largest = std::max(largest, std::hypot(u, v));
  }
  const Point& zero = map.zero_direction;
  return {
      .facts = {{"source", PointText(source)},
                {"angle 0",
                 absl::StrCat(ShortNumber(zero[0]), " ", ShortNumber(zero[1]),
                              " ", ShortNumber(zero[2]))},
                {"mapped", absl::StrCat(GroupedNumber(mapped), " of ",
                                        GroupedNumber(map.coordinates.size()),
                                        " vertices")},
                {"largest distance", ShortNumber(largest)}},
      .json = {{"vertices", map.coordinates.size()},
               {"mapped_vertices", mapped},
               {"largest_distance", largest},
               {"zero_direction", zero}}};
}

absl::Status Answer(const LogMapArguments& arguments, const Session& session,
                    const Question& question) {
  Stopwatch watch(session);
  absl::StatusOr<LogMap> map = session.client.ComputeLogMap(
      {.mesh_digest = question.mesh_digest,
       .source = arguments.source,
       .algorithm = arguments.question.algorithm,
       .value_type = ValueTypeOf(arguments.float32),
       .radius = arguments.radius,
       .priority = arguments.question.priority},
      session.call, watch.OnSolve());
  if (!map.ok()) return map.status();
  const double seconds = watch.seconds();
  absl::StatusOr<std::vector<WrittenFile>> files =
      Write(session, arguments, *map);
  if (!files.ok()) return files.status();
  PrintReport(session, question, map->info, seconds, *files,
              ReportOf(arguments.source, *map));
  return absl::OkStatus();
}

}  // namespace

Command LogMapCommand() {
  return MakeQuestion(
      "logmap", "Directions and distances around a point",
      "  geodesic logmap horse.ply --source 0 --radius 0.05 -o uv.npy",
      AddOptions, Answer);
}

}  // namespace geodesic::client
