// path: shortest paths to points.

#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/cli/commands/command.h"
#include "client/cli/commands/field_outputs.h"
#include "client/cli/commands/line_outputs.h"
#include "client/output/number_text.h"
#include "client/output/place_text.h"

namespace geodesic::client {
namespace {

struct PathArguments {
  QuestionArguments question;
  std::optional<double> radius;
  PictureOptions picture;
};

void AddOptions(CLI::App* app, PathArguments* arguments) {
  AddMesh(app, kMeshHelp, &arguments->question.mesh);
  AddSources(app, Need::kRequired, &arguments->question.sources);
  AddTargets(app, Need::kRequired, "Find the path here from the nearest source",
             &arguments->question.targets);
  AddRadius(app, "Give up targets that are farther", &arguments->radius);
  AddQuestion(app, "Write the paths here", kLineFormats, &arguments->question);
  AddPicture(app, &arguments->picture);
  AddCheck(app, [arguments] {
    RequireSources(arguments->question.sources);
    RequireTargets(arguments->question.targets);
  });
}

Lines LinesOf(const PathAnswer& answer) {
  Lines lines = {
      .attributes = {
          {"target", true}, {"source", true}, {"distance"}, {"length"}}};
  for (size_t target = 0; target < answer.paths.size(); ++target) {
    const GeodesicPath& path = answer.paths[target];
    lines.lines.push_back(
        {.polyline = path.line,
         .values = {
             static_cast<double>(target),
             path.source.has_value() ? static_cast<double>(*path.source) : -1.0,
             path.distance, path.length}});
  }
  return lines;
}

PictureContent ContentOf(const Question& question, const PathAnswer& answer,
                         const MeshArrays& mesh) {
  PictureContent content;
  for (const GeodesicPath& path : answer.paths) {
    content.bold_lines.push_back({.points = path.line.positions});
  }
  ShowSources(question.sources, mesh, &content);
  for (const SurfacePoint& target : question.targets) {
    content.targets.push_back(PositionOf(target, mesh));
  }
  return content;
}

Report ReportOf(const Question& question, const PathAnswer& answer) {
  Report report = {
      .header = {"target", "source", "distance", "length", "points"}};
  Json paths = Json::array();
  for (size_t target = 0; target < answer.paths.size(); ++target) {
    const GeodesicPath& path = answer.paths[target];
    report.rows.push_back({PointText(question.targets[target]),
                           path.source.has_value()
                               ? SourceText(question.sources.at(*path.source))
                               : "not reached",
                           NumberText(path.distance), NumberText(path.length),
                           GroupedNumber(path.line.points.size())});
    Json points = Json::array();
    for (const SurfacePoint& point : path.line.points) {
      points.push_back(PointToJson(point));
    }
    paths.push_back({{"target", PointToJson(question.targets[target])},
                     {"source", path.source.has_value() ? Json(*path.source)
                                                        : Json(nullptr)},
                     {"distance", path.distance},
                     {"length", path.length},
                     {"points", std::move(points)},
                     {"positions", path.line.positions}});
  }
  report.json["paths"] = std::move(paths);
  return report;
}

absl::Status Answer(const PathArguments& arguments, const Session& session,
                    const Question& question) {
  Stopwatch watch(session);
  absl::StatusOr<PathAnswer> answer =
      session.client.ComputePaths({.mesh_digest = question.mesh_digest,
                                   .sources = question.sources,
                                   .targets = question.targets,
                                   .algorithm = arguments.question.algorithm,
                                   .radius = arguments.radius,
                                   .priority = arguments.question.priority},
                                  session.call, watch.OnSolve());
  if (!answer.ok()) return answer.status();
  for (const GeodesicPath& path : answer->paths) {
    if (path.source.value_or(0) >= question.sources.size()) {
      return absl::DataLossError(
          "the server sent a path from a source that was not asked for");
    }
  }
  const double seconds = watch.seconds();
  MeshOnDemand mesh(session, question.mesh_digest);
  const auto write_picture =
      [&](const std::string& path) -> absl::StatusOr<uint64_t> {
    absl::StatusOr<const MeshArrays*> arrays =
        mesh.Get(answer->info.vertex_count);
    if (!arrays.ok()) return arrays.status();
    return WritePicture(path, **arrays, ContentOf(question, *answer, **arrays),
                        arguments.picture);
  };
  absl::StatusOr<std::vector<WrittenFile>> files = WriteLineOutputs(
      session, arguments.question.outputs, LinesOf(*answer), write_picture);
  if (!files.ok()) return files.status();
  PrintReport(session, question, answer->info, seconds, *files,
              ReportOf(question, *answer));
  return absl::OkStatus();
}

}  // namespace

Command PathCommand() {
  return MakeQuestion(
      "path", "Shortest paths to points",
      "  geodesic path horse.ply --source 0 --target 99 -o path.obj "
      "-o path.png\n"
      "  geodesic path horse.ply --source 0 --source 7 --targets points.txt "
      "-o p.json",
      AddOptions, Answer);
}

}  // namespace geodesic::client
