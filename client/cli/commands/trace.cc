// trace: lines that run straight on.

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_split.h"
#include "client/cli/commands/command.h"
#include "client/cli/commands/outputs.h"
#include "client/cli/commands/question.h"
#include "client/cli/commands/report.h"
#include "client/cli/commands/stopwatch.h"
#include "client/output/line_writers.h"
#include "client/output/number_text.h"
#include "client/output/place_text.h"

namespace geodesic::client {
namespace {

struct TraceArguments : QuestionArguments {
  std::vector<double> angles;
  std::vector<Point> vectors;
  std::optional<double> length;
};

// "X,Y,Z".
absl::StatusOr<Point> ParseVector(const std::string& text) {
  const std::vector<std::string> words = absl::StrSplit(text, ',');
  Point vector{};
  bool is_vector = words.size() == vector.size();
  for (size_t i = 0; is_vector && i < vector.size(); ++i) {
    is_vector =
        absl::SimpleAtod(words[i], &vector[i]) && std::isfinite(vector[i]);
  }
  if (is_vector) return vector;
  return absl::InvalidArgumentError(
      absl::StrCat("'", text, "' is no direction: three numbers X,Y,Z"));
}

absl::StatusOr<double> ParseAngle(const std::string& text) {
  double degrees = 0;
  if (absl::SimpleAtod(text, &degrees) && std::isfinite(degrees)) {
    return degrees;
  }
  return absl::InvalidArgumentError(
      absl::StrCat("'", text, "' is no angle in degrees"));
}

void AddOptions(CLI::App* app, TraceArguments* arguments) {
  arguments->has_algorithm = false;
  AddMesh(app, kMeshHelp, &arguments->mesh);
  AddSource(app, "Where the lines start", &arguments->sources);
  AddValue(
      app,
      {"-d,--direction",
       "Follow the line in the direction of the surface that is nearest to "
       "this one in space; may be repeated",
       "X,Y,Z"},
      ParseVector, &arguments->vectors);
  AddValue(app,
           {"--angle",
            "Or at this angle in the map that logmap makes, counterclockwise "
            "from its zero; may be repeated",
            "DEGREES"},
           ParseAngle, &arguments->angles);
  AddValue(app,
           {"--towards",
            "Or towards this POINT, as in --source; may be repeated", "POINT"},
           ParsePoint, &arguments->targets.points);
  AddValue(
      app,
      {"-l,--length",
       "End the lines when they are so long. Default: at a boundary", "LENGTH"},
      ParseLevel, &arguments->length);
  const auto check = [arguments] {
    if (arguments->sources.points.size() != 1) {
      Refuse("--source", "lines start at one source");
    }
    const int kinds = (arguments->vectors.empty() ? 0 : 1) +
                      (arguments->angles.empty() ? 0 : 1) +
                      (arguments->targets.points.empty() ? 0 : 1);
    if (kinds != 1) {
      Refuse("--direction",
             "say where to with --direction, with --angle or with --towards");
    }
  };
  AddQuestion(app, "Write the lines here", kLineFormats, arguments, check);
  AddPicture(app, &arguments->picture);
}

Lines LinesOf(const LineAnswer& answer) {
  Lines lines = {.attributes = {{"length"}}};
  for (const StraightLine& line : answer.lines) {
    lines.lines.push_back({.polyline = line.line, .values = {line.length}});
  }
  return lines;
}

Report ReportOf(const LineAnswer& answer) {
  Report report = {.header = {"line", "length", "points", "end"}};
  Json lines = Json::array();
  for (size_t i = 0; i < answer.lines.size(); ++i) {
    const StraightLine& line = answer.lines[i];
    report.rows.push_back({absl::StrCat(i), NumberText(line.length),
                           GroupedNumber(line.line.points.size()),
                           std::string(TraceEndName(line.end))});
    Json points = Json::array();
    for (const SurfacePoint& point : line.line.points) {
      points.push_back(PointToJson(point));
    }
    lines.push_back({{"length", line.length},
                     {"end", std::string(TraceEndName(line.end))},
                     {"points", std::move(points)},
                     {"positions", line.line.positions}});
  }
  report.json["lines"] = std::move(lines);
  return report;
}

absl::Status Answer(const TraceArguments& arguments, const Session& session,
                    const Question& question) {
  LineQuery query{.mesh_digest = question.mesh_digest,
                  .sources = {FirstPoint(question.sources.at(0))},
                  .lengths = {arguments.length.value_or(
                      std::numeric_limits<double>::infinity())},
                  .priority = arguments.priority};
  if (!arguments.angles.empty()) {
    std::vector<double> radians = arguments.angles;
    for (double& angle : radians) angle *= std::acos(-1.0) / 180;
    query.directions = std::move(radians);
  } else if (!arguments.vectors.empty()) {
    query.directions = arguments.vectors;
  } else {
    query.directions = question.targets;
  }
  Stopwatch watch(session);
  const absl::StatusOr<LineAnswer> answer =
      session.client.TraceLines(query, session.call, watch.OnCount("lines"));
  if (!answer.ok()) return answer.status();
  const double seconds = watch.seconds();
  const auto write = [&](const OutputArgument& output,
                         const MeshArrays& mesh) -> absl::StatusOr<uint64_t> {
    if (output.format == OutputFormat::kPng) {
      PictureContent content;
      for (const StraightLine& line : answer->lines) {
        content.bold_lines.push_back({.points = line.line.positions});
      }
      ShowSources(question.sources, mesh, &content);
      return WritePicture(output.path, mesh, content, arguments.picture);
    }
    return WriteFile(output.path, [&](AtomicFile* file) {
      WriteLines(LinesOf(*answer), output.format, file);
    });
  };
  return PrintReport(session, question, answer->info, seconds,
                     WriteOutputs(session, arguments.outputs, answer->info,
                                  {OutputFormat::kPng}, write),
                     ReportOf(*answer));
}

}  // namespace

Command TraceCommand() {
  return MakeQuestion(
      "trace", "Lines that run straight on",
      "  geodesic trace horse.ply --source 0 --direction 1,0,0 --length 0.1 "
      "-o line.obj\n"
      "  geodesic trace horse.ply --source 0 --angle 0 --angle 90 --length 0.1 "
      "-o lines.png",
      AddOptions, Answer);
}

}  // namespace geodesic::client
