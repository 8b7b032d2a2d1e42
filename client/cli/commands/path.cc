// path: shortest paths to points.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/cli/commands/command.h"
#include "client/cli/commands/notes.h"
#include "client/cli/commands/outputs.h"
#include "client/cli/commands/question.h"
#include "client/cli/commands/report.h"
#include "client/cli/commands/stopwatch.h"
#include "client/cli/terminal/exit_code.h"
#include "client/output/line_writers.h"
#include "client/output/number_text.h"
#include "client/output/place_text.h"

namespace geodesic::client {
namespace {

void AddOptions(CLI::App* app, QuestionArguments* arguments) {
  AddMesh(app, kMeshHelp, &arguments->mesh);
  AddSources(app, Need::kRequired, &arguments->sources);
  AddTargets(app, Need::kRequired, "Find the path here from the nearest source",
             &arguments->targets);
  AddRadius(app, "Give up targets that are farther", &arguments->radius);
  AddQuestion(app, "Write the paths here", kLineFormats, arguments);
  AddPicture(app, &arguments->picture);
}

Lines LinesOf(const PathAnswer& answer) {
  Lines lines = {.attributes = {{"target", NumberType::kInt32},
                                {"source", NumberType::kInt32},
                                {"distance"},
                                {"length"}}};
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
  ShowTargets(question.targets, mesh, &content);
  return content;
}

// NoPath if there is a reason why a target is not reached.
absl::Status AllReached(const Question& question,
                        const std::vector<std::string>& reasons) {
  const auto has_one = [](const std::string& reason) {
    return !reason.empty();
  };
  const auto first = std::ranges::find_if(reasons, has_one);
  if (first == reasons.end()) return absl::OkStatus();
  const auto others = std::count_if(first + 1, reasons.end(), has_one);
  const size_t target = first - reasons.begin();
  return NoPath(absl::StrCat(
      "no path leads to ", PointText(question.targets[target]), ": ", *first,
      others == 0
          ? ""
          : absl::StrCat("; nor to ", others,
                         others == 1 ? " other target" : " other targets")));
}

Report ReportOf(const Question& question, const PathAnswer& answer,
                const std::vector<std::string>& reasons) {
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
    paths.push_back(
        {{"target", PointToJson(question.targets[target])},
         {"source",
          path.source.has_value() ? Json(*path.source) : Json(nullptr)},
         {"distance", path.distance},
         {"length", path.length},
         {"unreached",
          reasons[target].empty() ? Json(nullptr) : Json(reasons[target])},
         {"points", std::move(points)},
         {"positions", path.line.positions}});
  }
  report.json["paths"] = std::move(paths);
  return report;
}

absl::Status Answer(const QuestionArguments& arguments, const Session& session,
                    const Question& question) {
  Stopwatch watch(session);
  absl::StatusOr<PathAnswer> answer = session.client.ComputePaths(
      MakeQuery<PathQuery>(arguments, question), session.call, watch.OnSolve());
  if (!answer.ok()) return answer.status();
  for (const GeodesicPath& path : answer->paths) {
    if (path.source.value_or(0) >= question.sources.size()) {
      return absl::DataLossError(
          "the server sent a path from a source that was not asked for");
    }
  }
  const double seconds = watch.seconds();
  std::vector<double> distances;
  for (const GeodesicPath& path : answer->paths) {
    distances.push_back(path.distance);
  }
  const std::vector<std::string> reasons =
      WhyUnreached(session, question.mesh_digest, question.sources,
                   question.targets, distances, BeyondRadius(arguments.radius));
  const bool has_paths =
      std::ranges::any_of(reasons, [](const auto& r) { return r.empty(); });
  const Lines lines = LinesOf(*answer);
  const auto write = [&](const OutputArgument& output,
                         const MeshArrays& mesh) -> absl::StatusOr<uint64_t> {
    if (output.format == OutputFormat::kPng) {
      return WritePicture(output.path, mesh, ContentOf(question, *answer, mesh),
                          arguments.picture);
    }
    return WriteFile(output.path, [&](AtomicFile* file) {
      WriteLines(lines, output.format, file);
    });
  };
  // Without any path there is nothing to write.
  const std::vector<OutputArgument> outputs =
      has_paths ? arguments.outputs : std::vector<OutputArgument>();
  absl::Status status = PrintReport(
      session, question, answer->info, seconds,
      WriteOutputs(session, outputs, answer->info, {OutputFormat::kPng}, write),
      ReportOf(question, *answer, reasons));
  status.Update(AllReached(question, reasons));
  return status;
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
