// isolines: lines of equal distance.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/cli/commands.h"
#include "client/cli/field_outputs.h"
#include "client/cli/line_outputs.h"
#include "client/output/number_text.h"

namespace geodesic::client {
namespace {

// What is said about the lines of one level.
struct LevelSummary {
  double level = 0;
  uint64_t lines = 0;
  uint64_t closed = 0;
  uint64_t points = 0;
  double length = 0;  // of the polylines, in space
};

double LengthOf(const Isoline& isoline) {
  const std::vector<Point>& points = isoline.line.positions;
  const auto piece = [&points](size_t a, size_t b) {
    return std::hypot(points[b][0] - points[a][0], points[b][1] - points[a][1],
                      points[b][2] - points[a][2]);
  };
  double length = 0;
  for (size_t i = 1; i < points.size(); ++i) length += piece(i - 1, i);
  if (isoline.is_closed && points.size() > 1) {
    length += piece(points.size() - 1, 0);
  }
  return length;
}

std::vector<LevelSummary> Summarize(std::vector<double> levels,
                                    const IsolineAnswer& answer) {
  std::ranges::sort(levels);
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  std::vector<LevelSummary> summaries;
  for (const double level : levels) {
    LevelSummary summary = {.level = level};
    for (const Isoline& isoline : answer.isolines) {
      if (isoline.level != level) continue;
      ++summary.lines;
      summary.closed += isoline.is_closed ? 1 : 0;
      summary.points += isoline.line.points.size();
      summary.length += LengthOf(isoline);
    }
    summaries.push_back(summary);
  }
  return summaries;
}

Lines LinesOf(const IsolineAnswer& answer) {
  Lines lines = {.attributes = {{"level"}}};
  for (const Isoline& isoline : answer.isolines) {
    lines.lines.push_back({.polyline = isoline.line,
                           .is_closed = isoline.is_closed,
                           .values = {isoline.level}});
  }
  return lines;
}

// The field below the lines, for the picture and for what --count means.
absl::StatusOr<Field> ComputeField(const Session& session,
                                   const Question& question, Stopwatch* watch) {
  return session.client.ComputeField({.mesh_digest = question.mesh_digest,
                                      .sources = question.sources,
                                      .algorithm = session.arguments.algorithm,
                                      .priority = session.arguments.priority},
                                     session.call, watch->OnSolve());
}

// `count` levels that cut the range of distances into equal parts.
absl::StatusOr<std::vector<double>> SpreadLevels(const Field& field,
                                                 uint64_t count) {
  double largest = 0;
  for (const double distance : field.distances) {
    if (std::isfinite(distance)) largest = std::max(largest, distance);
  }
  if (!(largest > 0)) {
    return absl::InvalidArgumentError(
        "no vertex is farther than 0 from the sources: there are no isolines");
  }
  std::vector<double> levels;
  for (uint64_t i = 1; i <= count; ++i) {
    levels.push_back(largest * static_cast<double>(i) /
                     static_cast<double>(count + 1));
  }
  return levels;
}

PictureContent ContentOf(const Question& question, const Field& field,
                         const std::vector<double>& levels,
                         const IsolineAnswer& answer, const MeshArrays& mesh) {
  PictureContent content = {.distances = field.distances, .levels = levels};
  for (const Isoline& isoline : answer.isolines) {
    content.thin_lines.push_back(
        {.points = isoline.line.positions, .is_closed = isoline.is_closed});
  }
  ShowSources(question.sources, mesh, &content);
  return content;
}

void PrintText(const Session& session, const std::vector<LevelSummary>& levels,
               const IsolineAnswer& answer,
               const std::vector<WrittenFile>& files, double seconds) {
  std::vector<std::vector<std::string>> rows;
  for (const LevelSummary& level : levels) {
    rows.push_back({NumberText(level.level), GroupedNumber(level.lines),
                    GroupedNumber(level.closed), GroupedNumber(level.points),
                    ShortNumber(level.length)});
  }
  PrintTable({"level", "lines", "closed", "points", "length"}, rows,
             &session.out);
  std::vector<Fact> facts = {{"mesh", answer.info.mesh_digest},
                             {"algorithm", answer.info.algorithm}};
  AddClosingFacts(answer.info, seconds, files, &facts);
  session.out << '\n';
  PrintFacts(facts, &session.out);
}

Json AnswerJson(const Question& question,
                const std::vector<LevelSummary>& levels,
                const IsolineAnswer& answer,
                const std::vector<WrittenFile>& files, double seconds) {
  Json json = AnswerJson(question, answer.info, seconds);
  Json list = Json::array();
  for (const LevelSummary& level : levels) {
    list.push_back({{"level", level.level},
                    {"lines", level.lines},
                    {"closed", level.closed},
                    {"points", level.points},
                    {"length", level.length}});
  }
  json["levels"] = std::move(list);
  json["outputs"] = ToJson(files);
  return json;
}

}  // namespace

absl::Status RunIsolines(const Session& session) {
  const Arguments& arguments = session.arguments;
  absl::StatusOr<Question> question = Prepare(session);
  if (!question.ok()) return question.status();
  Stopwatch watch(session);
  std::optional<Field> field;
  const auto need_field = [&]() -> absl::Status {
    if (field.has_value()) return absl::OkStatus();
    absl::StatusOr<Field> computed = ComputeField(session, *question, &watch);
    if (computed.ok()) field = *std::move(computed);
    return computed.status();
  };
  std::vector<double> levels = arguments.levels;
  if (arguments.count.has_value()) {
    if (absl::Status status = need_field(); !status.ok()) return status;
    absl::StatusOr<std::vector<double>> spread =
        SpreadLevels(*field, *arguments.count);
    if (!spread.ok()) return spread.status();
    levels = *std::move(spread);
  }
  absl::StatusOr<IsolineAnswer> answer =
      session.client.ComputeIsolines({.mesh_digest = question->mesh_digest,
                                      .sources = question->sources,
                                      .levels = levels,
                                      .algorithm = arguments.algorithm,
                                      .priority = arguments.priority},
                                     session.call, watch.OnSolve());
  if (!answer.ok()) return answer.status();
  const double seconds = watch.seconds();
  MeshOnDemand mesh(session, question->mesh_digest);
  const auto write_picture =
      [&](const std::string& path) -> absl::StatusOr<uint64_t> {
    if (absl::Status status = need_field(); !status.ok()) return status;
    absl::StatusOr<const MeshArrays*> arrays = mesh.Get(field->vertex_count);
    if (!arrays.ok()) return arrays.status();
    return WritePicture(path, **arrays,
                        ContentOf(*question, *field, levels, *answer, **arrays),
                        arguments.picture);
  };
  absl::StatusOr<std::vector<WrittenFile>> files =
      WriteLineOutputs(session, LinesOf(*answer), write_picture);
  if (!files.ok()) return files.status();
  const std::vector<LevelSummary> summaries = Summarize(levels, *answer);
  if (arguments.json) {
    PrintJson(AnswerJson(*question, summaries, *answer, *files, seconds),
              &session.out);
  } else {
    PrintText(session, summaries, *answer, *files, seconds);
  }
  return absl::OkStatus();
}

}  // namespace geodesic::client
