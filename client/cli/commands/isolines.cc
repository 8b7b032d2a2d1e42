// isolines: lines of equal distance.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "client/cli/commands/command.h"
#include "client/cli/commands/outputs.h"
#include "client/cli/commands/question.h"
#include "client/cli/commands/report.h"
#include "client/cli/commands/stopwatch.h"
#include "client/output/line_writers.h"
#include "client/output/number_text.h"

namespace geodesic::client {
namespace {

struct IsolinesArguments : QuestionArguments {
  std::vector<double> levels;
  // Given instead of levels.
  std::optional<uint64_t> count;
  std::optional<double> chord_error;
};

void AddOptions(CLI::App* app, IsolinesArguments* arguments) {
  arguments->may_have_tolerance = true;
  AddMesh(app, kMeshHelp, &arguments->mesh);
  AddSources(app, Need::kRequired, &arguments->sources);
  AddValue(app,
           {"-l,--level",
            "Draw the line at this distance; may be repeated. Lines come in "
            "order of distance, equal distances once",
            "DISTANCE"},
           ParseLevel, &arguments->levels);
  AddValue(app,
           {"-n,--count",
            "Draw lines at this many distances instead, evenly spread up to "
            "the largest",
            "N"},
           ParseCount, &arguments->count);
  AddValue(app,
           {"--chord-error",
            "Let no chord be farther from its line than this; inf: points on "
            "edges alone, but for lines inside a face. Default: a thousandth "
            "of each distance",
            "LENGTH"},
           ParseChordError, &arguments->chord_error);
  const auto check = [arguments] {
    if (arguments->levels.empty() != arguments->count.has_value()) {
      Refuse("--level",
             "give distances with --level, or their number with --count");
    }
  };
  AddQuestion(app, "Write the lines here", kLineFormats, arguments, check);
  AddPicture(app, &arguments->picture);
}

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

Lines LinesOf(const IsolineAnswer& answer, const std::string& mark) {
  Lines lines = {.attributes = {{MarkedName("level", mark)}}};
  for (const Isoline& isoline : answer.isolines) {
    lines.lines.push_back({.polyline = isoline.line,
                           .is_closed = isoline.is_closed,
                           .values = {isoline.level}});
  }
  return lines;
}

// `count` levels that cut the range of distances into equal parts.
absl::StatusOr<std::vector<double>> SpreadLevels(const Question& question,
                                                 const Field& field,
                                                 uint64_t count) {
  const double largest = LargestFinite(field.distances);
  if (!(largest > 0)) {
    return absl::InvalidArgumentError(absl::StrCat(
        "no vertex is farther than 0 from the sources: there are no isolines",
        question.notes.empty() ? "" : "; ",
        absl::StrJoin(question.notes, "; ")));
  }
  std::vector<double> levels;
  for (uint64_t i = 1; i <= count; ++i) {
    levels.push_back(largest * static_cast<double>(i) /
                     static_cast<double>(count + 1));
  }
  return levels;
}

// Refuses more levels than the server allows, before the field that the levels
// come from is computed.
absl::Status CheckCount(const Session& session, uint64_t count) {
  absl::StatusOr<Capabilities> capabilities =
      session.client.GetCapabilities(session.call);
  if (!capabilities.ok()) return capabilities.status();
  const uint64_t most = capabilities->limits.max_levels;
  if (count <= most) return absl::OkStatus();
  return absl::ResourceExhaustedError(
      absl::StrCat("--count ", count, " is more than the ", most,
                   " levels that this server takes (max_levels)"));
}

PictureContent ContentOf(const Question& question, const Field& field,
                         const std::vector<double>& levels,
                         const IsolineAnswer& answer, const std::string& mark,
                         const MeshArrays& mesh) {
  PictureContent content = {
      .approximation = mark, .distances = field.distances, .levels = levels};
  for (const Isoline& isoline : answer.isolines) {
    content.thin_lines.push_back(
        {.points = isoline.line.positions, .is_closed = isoline.is_closed});
  }
  ShowSources(question.sources, mesh, &content);
  return content;
}

// A row for the lines of each level, with their length in space.
Report ReportOf(std::vector<double> levels, const IsolineAnswer& answer) {
  Report report = {.header = {"level", "lines", "closed", "points", "length"}};
  Json list = Json::array();
  std::ranges::sort(levels);
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  for (const double level : levels) {
    uint64_t lines = 0, closed = 0, points = 0;
    double length = 0;
    for (const Isoline& isoline : answer.isolines) {
      if (isoline.level != level) continue;
      ++lines;
      closed += isoline.is_closed ? 1 : 0;
      points += isoline.line.points.size();
      length += LengthOf(isoline);
    }
    report.rows.push_back({NumberText(level), GroupedNumber(lines),
                           GroupedNumber(closed), GroupedNumber(points),
                           ShortNumber(length)});
    if (lines == 0) {
      report.notes.push_back(absl::StrCat("no line is ", NumberText(level),
                                          " away from the sources"));
    }
    list.push_back({{"level", level},
                    {"lines", lines},
                    {"closed", closed},
                    {"points", points},
                    {"length", length}});
  }
  report.json["levels"] = std::move(list);
  return report;
}

absl::Status Answer(const IsolinesArguments& arguments, const Session& session,
                    const Question& question) {
  if (arguments.count.has_value()) {
    absl::Status status = CheckCount(session, *arguments.count);
    if (!status.ok()) return status;
  }
  Stopwatch watch(session);
  const bool is_exact = arguments.tolerance == 0;
  // The distances, which the picture and --count need.
  std::optional<Field> field;
  const auto need_field = [&]() -> absl::Status {
    if (field.has_value()) return absl::OkStatus();
    absl::StatusOr<Field> computed =
        session.client.ComputeField(MakeQuery<FieldQuery>(arguments, question),
                                    session.call, watch.OnSolve(is_exact));
    if (computed.ok()) field = *std::move(computed);
    return computed.status();
  };
  auto query = MakeQuery<IsolineQuery>(arguments, question);
  query.levels = arguments.levels;
  query.chord_error = arguments.chord_error.value_or(0);
  if (arguments.count.has_value()) {
    if (absl::Status status = need_field(); !status.ok()) return status;
    absl::StatusOr<std::vector<double>> spread =
        SpreadLevels(question, *field, *arguments.count);
    if (!spread.ok()) return spread.status();
    query.levels = *std::move(spread);
  }
  absl::StatusOr<IsolineAnswer> answer = session.client.ComputeIsolines(
      query, session.call, watch.OnSolve(is_exact));
  if (!answer.ok()) return answer.status();
  const double seconds = watch.seconds();
  const std::string mark = arguments.mark();
  const Lines lines = LinesOf(*answer, mark);
  const auto write = [&](const OutputArgument& output,
                         const MeshArrays& mesh) -> absl::StatusOr<uint64_t> {
    if (output.format != OutputFormat::kPng) {
      return WriteFile(output.path, [&](AtomicFile* file) {
        WriteLines(lines, output.format, file);
      });
    }
    if (absl::Status status = need_field(); !status.ok()) return status;
    if (field->vertex_count != mesh.positions.size()) {
      return absl::DataLossError("the server sent answers for two meshes");
    }
    return WritePicture(
        output.path, mesh,
        ContentOf(question, *field, query.levels, *answer, mark, mesh),
        arguments.picture);
  };
  return PrintReport(session, question, answer->info, seconds,
                     WriteOutputs(session, arguments.outputs, answer->info,
                                  {OutputFormat::kPng}, write),
                     ReportOf(query.levels, *answer));
}

}  // namespace

Command IsolinesCommand() {
  return MakeQuestion(
      "isolines", "Lines of equal distance",
      "  geodesic isolines horse.ply --source 0 --level 0.05 --level 0.1 "
      "-o l.obj\n"
      "  geodesic isolines horse.ply --source 0 --count 20 -o l.png",
      AddOptions, Answer);
}

}  // namespace geodesic::client
