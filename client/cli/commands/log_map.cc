// logmap: directions and distances around a point.

#include <cmath>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/cli/commands/command.h"
#include "client/cli/commands/outputs.h"
#include "client/cli/commands/question.h"
#include "client/cli/commands/report.h"
#include "client/cli/commands/stopwatch.h"
#include "client/output/field_writers.h"
#include "client/output/place_text.h"

namespace geodesic::client {
namespace {

void AddOptions(CLI::App* app, QuestionArguments* arguments) {
  arguments->adds_to_ply = true;
  AddMesh(app, kMeshHelp, &arguments->mesh);
  AddSource(app, "The middle of the map", &arguments->sources);
  AddRadius(app, "End the map at this distance", &arguments->radius);
  AddFloat32(app, &arguments->float32);
  const auto check = [arguments] {
    if (arguments->sources.points.size() != 1) {
      Refuse("--source", "a log map has one source");
    }
  };
  AddQuestion(app, "Write u and v of every vertex here", kLogMapFormats,
              arguments, check);
}

// The coordinates u and v, as one column of pairs.
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

Report ReportOf(const Source& source, const LogMap& map) {
  uint64_t mapped = 0;
  double largest = 0;
  for (const auto& [u, v] : map.coordinates) {
    if (std::isnan(u)) continue;
    ++mapped;
    largest = std::max(largest, std::hypot(u, v));
  }
  return {
      .facts = {{"source", SourceText(source)},
                {"angle 0", ShortNumbers(map.zero_direction)},
                {"mapped", absl::StrCat(GroupedNumber(mapped), " of ",
                                        GroupedNumber(map.coordinates.size()),
                                        " vertices")},
                {"largest distance",
                 mapped == 0 ? "none" : ShortNumber(largest)}},
      .json = {{"vertices", map.coordinates.size()},
               {"mapped_vertices", mapped},
               {"largest_distance", mapped == 0 ? Json() : Json(largest)},
               {"zero_direction", map.zero_direction}}};
}

absl::Status Answer(const QuestionArguments& arguments, const Session& session,
                    const Question& question) {
  auto query = MakeQuery<LogMapQuery>(arguments, question);
  // The command line takes no curve.
  query.source = FirstPoint(question.sources.at(0));
  Stopwatch watch(session);
  absl::StatusOr<LogMap> map =
      session.client.ComputeLogMap(query, session.call, watch.OnSolve());
  if (!map.ok()) return map.status();
  const double seconds = watch.seconds();
  const NumberType type = NumberTypeOf(arguments.float32);
  const auto write = [&](const OutputArgument& output, const MeshArrays& mesh) {
    if (output.format == OutputFormat::kPly) {
      return WriteAnswerAsPly(session, arguments.mesh, map->info, mesh,
                              UAndV(*map, type), /*mark=*/"", output.path);
    }
    return WriteFile(output.path, [&](AtomicFile* file) {
      if (output.format == OutputFormat::kNpy) {
        WriteNpy(Pairs(*map, type), file);
      } else {
        WriteCsv(UAndV(*map, type), file);
      }
    });
  };
  return PrintReport(session, question, map->info, seconds,
                     WriteOutputs(session, arguments.outputs, map->info,
                                  {OutputFormat::kPly}, write),
                     ReportOf(question.sources[0], *map));
}

}  // namespace

Command LogMapCommand() {
  return MakeQuestion(
      "logmap", "Directions and distances around a point",
      "  geodesic logmap horse.ply --source 0 --radius 0.05 -o uv.npy",
      AddOptions, Answer);
}

}  // namespace geodesic::client
