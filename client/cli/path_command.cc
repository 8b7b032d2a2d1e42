// path: shortest paths to points.

#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/cli/commands.h"
#include "client/cli/field_outputs.h"
#include "client/cli/line_outputs.h"
#include "client/output/number_text.h"
#include "client/output/place_text.h"

namespace geodesic::client {
namespace {

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

void PrintText(const Session& session, const Question& question,
               const PathAnswer& answer, const std::vector<WrittenFile>& files,
               double seconds) {
  std::vector<std::vector<std::string>> rows;
  for (size_t target = 0; target < answer.paths.size(); ++target) {
    const GeodesicPath& path = answer.paths[target];
    rows.push_back({PointText(question.targets[target]),
                    path.source.has_value()
                        ? SourceText(question.sources.at(*path.source))
                        : "not reached",
                    NumberText(path.distance), NumberText(path.length),
                    GroupedNumber(path.line.points.size())});
  }
  PrintTable({"target", "source", "distance", "length", "points"}, rows,
             &session.out);
  std::vector<Fact> facts = {{"mesh", answer.info.mesh_digest},
                             {"algorithm", answer.info.algorithm}};
  AddClosingFacts(answer.info, seconds, files, &facts);
  session.out << '\n';
  PrintFacts(facts, &session.out);
}

Json AnswerJson(const Question& question, const PathAnswer& answer,
                const std::vector<WrittenFile>& files, double seconds) {
  Json json = AnswerJson(question, answer.info, seconds);
  Json paths = Json::array();
  for (size_t target = 0; target < answer.paths.size(); ++target) {
    const GeodesicPath& path = answer.paths[target];
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
  json["paths"] = std::move(paths);
  json["outputs"] = ToJson(files);
  return json;
}

}  // namespace

absl::Status RunPath(const Session& session) {
  absl::StatusOr<Question> question = Prepare(session);
  if (!question.ok()) return question.status();
  Stopwatch watch(session);
  absl::StatusOr<PathAnswer> answer =
      session.client.ComputePaths({.mesh_digest = question->mesh_digest,
                                   .sources = question->sources,
                                   .targets = question->targets,
                                   .algorithm = session.arguments.algorithm,
                                   .max_distance = session.arguments.radius,
                                   .priority = session.arguments.priority},
                                  session.call, watch.OnSolve());
  if (!answer.ok()) return answer.status();
  for (const GeodesicPath& path : answer->paths) {
    if (path.source.value_or(0) >= question->sources.size()) {
      return absl::DataLossError(
          "the server sent a path from a source that was not asked for");
    }
  }
  const double seconds = watch.seconds();
  MeshOnDemand mesh(session, question->mesh_digest);
  const auto write_picture =
      [&](const std::string& path) -> absl::StatusOr<uint64_t> {
    absl::StatusOr<const MeshArrays*> arrays =
        mesh.Get(answer->info.vertex_count);
    if (!arrays.ok()) return arrays.status();
    return WritePicture(path, **arrays, ContentOf(*question, *answer, **arrays),
                        session.arguments.picture);
  };
  absl::StatusOr<std::vector<WrittenFile>> files =
      WriteLineOutputs(session, LinesOf(*answer), write_picture);
  if (!files.ok()) return files.status();
  if (session.arguments.json) {
    PrintJson(AnswerJson(*question, *answer, *files, seconds), &session.out);
  } else {
    PrintText(session, *question, *answer, *files, seconds);
  }
  return absl::OkStatus();
}

}  // namespace geodesic::client
