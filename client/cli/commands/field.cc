// field: computes a distance field and writes it to files, whole or row by row.

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <list>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/cli/commands/command.h"
#include "client/cli/commands/notes.h"
#include "client/cli/commands/outputs.h"
#include "client/cli/commands/question.h"
#include "client/cli/commands/report.h"
#include "client/cli/commands/stopwatch.h"
#include "client/cli/terminal/exit_code.h"
#include "client/output/binary_numbers.h"
#include "client/output/field_writers.h"
#include "client/output/number_text.h"
#include "client/output/place_text.h"
#include "client/output/viewer_page.h"
#include "client/output/zip_archive.h"

namespace geodesic::client {
namespace {

struct FieldArguments : QuestionArguments {
  std::optional<uint64_t> stop_at_targets;
  bool nearest_sources = false;
  bool gradients = false;
  bool certified_errors = false;
  bool progressive = false;
};

// What --stop-at-targets means without a count.
constexpr int64_t kAllTargets = 0x7fffffffffffffff;

// Refuses to leave out of all files what was asked for beside distances.
void CheckQuantities(const FieldArguments& arguments) {
  using enum OutputFormat;
  const auto check = [&](bool is_asked, const char* option, bool png_holds) {
    const auto holds = [png_holds](const OutputArgument& output) {
      return output.format == kNpz || output.format == kCsv ||
             output.format == kPly || output.format == kVtk ||
             (png_holds && output.format == kPng);
    };
    if (!is_asked || arguments.outputs.empty() ||
        std::ranges::any_of(arguments.outputs, holds)) {
      return;
    }
    Refuse(option, absl::StrCat("no -o FILE holds that: write .npz, .csv, .ply",
                                png_holds ? ", .vtk or .png" : " or .vtk"));
  };
  check(arguments.nearest_sources, "--nearest-sources", true);
  check(arguments.gradients, "--gradients", false);
  check(arguments.certified_errors, "--certified-errors", false);
}

void Check(const CLI::App& app, const FieldArguments& arguments) {
  const TargetArguments& targets = arguments.targets;
  if (arguments.stop_at_targets.has_value() && targets.points.empty() &&
      targets.files.empty()) {
    Refuse("--stop-at-targets", "needs --target or --targets");
  }
  for (const OutputArgument& output : arguments.outputs) {
    const bool is_raw = output.format == OutputFormat::kF64 ||
                        output.format == OutputFormat::kF32;
    if (is_raw && !arguments.mark().empty()) {
      Refuse("--output",
             absl::StrCat(
                 output.path, " has no place to say that its distances are ",
                 IsApproximate(arguments.algorithm) ? "approximate"
                                                    : "within a tolerance",
                 "; write .npy"));
    }
    if (arguments.float32 && output.format == OutputFormat::kF64) {
      Refuse("--float32",
             output.path + " holds numbers of 64 bits: write .f32");
    }
  }
  if (arguments.tolerance != 0 &&
      (arguments.progressive || arguments.nearest_sources ||
       arguments.gradients)) {
    Refuse("--tolerance",
           "is for distances that are sent when all are known: leave it out "
           "with --progressive, --nearest-sources and --gradients");
  }
  if (!arguments.progressive) return CheckQuantities(arguments);
  if (arguments.nearest_sources || arguments.gradients ||
      arguments.certified_errors) {
    Refuse("--progressive",
           "gives distances only: leave --nearest-sources, --gradients and "
           "--certified-errors to a run without it");
  }
  for (const OutputArgument& output : arguments.outputs) {
    if (output.path == kStandardOutput) {
      Refuse("--progressive", "prints to standard output without -o -");
    }
    if (output.format != OutputFormat::kCsv || IsCompressed(output.path)) {
      Refuse("--progressive",
             "writes .csv only, as it comes, not " + output.path);
    }
  }
  if (arguments.outputs.empty() && WantsJson(app)) {
    Refuse("--progressive", "with --json needs -o FILE.csv for the distances");
  }
}

void AddOptions(CLI::App* app, FieldArguments* arguments) {
  arguments->may_be_approximate = true;
  arguments->may_have_tolerance = true;
  arguments->adds_to_ply = true;
  AddMesh(app, kMeshHelp, &arguments->mesh);
  AddSources(app, Need::kRequired, &arguments->sources);
  AddTargets(app, Need::kOptional, "Print the distance to this point too",
             &arguments->targets);
  AddFlagOrCount(
      app,
      {.name = "--stop-at-targets",
       .help = "Stop once all targets, or the nearest N of them, are known",
       .group = "Targets"},
      kAllTargets, &arguments->stop_at_targets);
  AddRadius(app, "Stop at this distance; what is beyond is at infinity",
            &arguments->radius);
  AddFlag(app,
          {"--nearest-sources",
           "Also which source is nearest to each vertex, by number from "
           "0; -1 where none is. A picture shows the cells"},
          &arguments->nearest_sources);
  AddFlag(app,
          {"--gradients",
           "Also the unit vector in which distance grows at each vertex"},
          &arguments->gradients);
  AddFlag(app,
          {"--certified-errors",
           "Also by how much each distance may be off, as a part of it (with "
           "--tolerance; 0 where it is exact)"},
          &arguments->certified_errors);
  AddFloat32(app, &arguments->float32);
  AddFlag(app,
          {"--progressive",
           "Print vertices and their distances as they become final, in "
           "order of distance; or write them to -o FILE.csv"},
          &arguments->progressive);
  AddQuestion(app,
              "Write the field here (nearest sources, gradients and certified "
              "errors too in .npz, .csv, .ply and .vtk)",
              kFieldFormats, arguments,
              [app, arguments] { Check(*app, *arguments); });
  AddPicture(app, &arguments->picture);
}

FieldQuery ToQuery(const FieldArguments& arguments, const Question& question) {
  auto query = MakeQuery<FieldQuery>(arguments, question);
  query.nearest_sources = arguments.nearest_sources;
  query.gradients = arguments.gradients;
  query.certified_errors = arguments.certified_errors;
  if (arguments.stop_at_targets.has_value()) {
    query.stop_after_targets = *arguments.stop_at_targets == kAllTargets
                                   ? question.targets.size()
                                   : *arguments.stop_at_targets;
  }
  return query;
}

// The largest of the finite distances, and how many are finite.
struct FieldExtremes {
  // These are 0 if no vertex is reached.
  double largest = 0;
  uint64_t farthest_vertex = 0;
  uint64_t reached = 0;

  void Add(uint64_t vertex, double distance) {
    if (!std::isfinite(distance)) return;
    if (reached++ == 0 || distance > largest) {
      largest = distance;
      farthest_vertex = vertex;
    }
  }
};

// The field's columns: distances first, then other quantities that were asked
// for.
std::vector<Column> ColumnsOf(const FieldArguments& arguments,
                              const Field& field) {
  const NumberType real = NumberTypeOf(arguments.float32);
  std::vector<Column> columns = {
      {.name = DistanceName(kDistanceColumn, arguments.mark()),
       .values = field.distances,
       .type = real}};
  if (arguments.nearest_sources) {
    Column nearest = {.name = kNearestSourceColumn, .type = NumberType::kInt32};
    for (const uint32_t source : field.nearest_sources) {
      nearest.values.push_back(source == kNoSource ? -1.0 : source);
    }
    columns.push_back(std::move(nearest));
  }
  if (arguments.gradients) {
    Column gradients = {.name = kGradientColumn, .components = 3, .type = real};
    for (const auto& gradient : field.gradients) {
      gradients.values.insert(gradients.values.end(), gradient.begin(),
                              gradient.end());
    }
    columns.push_back(std::move(gradients));
  }
  if (arguments.certified_errors) {
    columns.push_back({.name = kErrorColumn,
                       .values = {field.certified_errors.begin(),
                                  field.certified_errors.end()},
                       .type = NumberType::kFloat32});
  }
  return columns;
}

// Writes the member distances, and nearest_sources, gradients, certified_errors
// and target_distances where there are any. Distances under a mark have its
// name.
absl::StatusOr<uint64_t> WriteNpz(const std::string& path,
                                  const std::vector<Column>& columns,
                                  const std::vector<double>& target_distances,
                                  const std::string& mark) {
  absl::StatusOr<ZipArchive> archive = ZipArchive::Create(path);
  if (!archive.ok()) return FileError(archive.status());
  for (const Column& column : columns) {
    const std::string name =
        column.name == kNearestSourceColumn ? "nearest_sources.npy"
        : column.name == kGradientColumn    ? "gradients.npy"
        : column.name == kErrorColumn       ? "certified_errors.npy"
                                      : MarkedName("distances", mark) + ".npy";
    archive->Add(name,
                 NpyArray(column.values, column.type, column.shape(), mark));
  }
  if (!target_distances.empty()) {
    archive->Add(MarkedName("target_distances", mark) + ".npy",
                 NpyArray(target_distances, columns[0].type,
                          {target_distances.size()}, mark));
  }
  absl::StatusOr<uint64_t> size = archive->Commit();
  if (!size.ok()) return FileError(size.status());
  return size;
}

PictureContent ContentOf(const Question& question, const Field& field,
                         const std::string& mark, const MeshArrays& mesh) {
  PictureContent content = {.approximation = mark,
                            .distances = field.distances,
                            .nearest_sources = field.nearest_sources,
                            .isolines = true};
  for (const Source& source : question.sources) {
    content.source_names.push_back(SourceText(source));
  }
  ShowSources(question.sources, mesh, &content);
  ShowTargets(question.targets, mesh, &content);
  return content;
}

// Where the viewer measures from: nothing unless all sources are points without
// an offset.
std::vector<Point> SourcePoints(const Question& question,
                                const MeshArrays& mesh) {
  PictureContent content;
  ShowSources(question.sources, mesh, &content);
  const bool only_points =
      std::ranges::all_of(question.sources, [](const Source& source) {
        return source.offset == 0 && !IsCurve(source);
      });
  return only_points ? content.sources : std::vector<Point>();
}

// Writes to the files of the outputs, or to the terminal if there are none.
class Rows {
 public:
  Rows(const Session& session, const std::vector<OutputArgument>& outputs)
      : outputs_(outputs) {
    for (const OutputArgument& output : outputs) {
      places_.push_back(&files_.emplace_back(output.path));
    }
    if (outputs.empty()) places_.push_back(&session.out);
  }

  void Write(const std::string& text) {
    for (std::ostream* place : places_) *place << text;
  }

  // Returns whether everything so far could be written.
  bool Flush() {
    bool good = true;
    for (std::ostream* place : places_) good &= !place->flush().fail();
    if (!good && error_ == 0) error_ = errno;
    return good;
  }

  absl::Status Close(std::vector<WrittenFile>* written) {
    if (!Flush()) {
      return outputs_.empty() ? OutputFailed()
                              : FileError(absl::ErrnoToStatus(
                                    error_, absl::StrCat("cannot write ",
                                                         outputs_[0].path)));
    }
    auto file = files_.begin();
    for (const OutputArgument& output : outputs_) {
      written->push_back({output, static_cast<uint64_t>((file++)->tellp())});
    }
    return absl::OkStatus();
  }

 private:
  const std::vector<OutputArgument>& outputs_;
  std::list<std::ofstream> files_;
  std::vector<std::ostream*> places_;
  int error_ = 0;
};

// What a page is called: the file, and that its distances are not exact.
std::string PageName(const std::string& mesh, const std::string& mark) {
  const std::string name = std::filesystem::path(mesh).filename();
  return mark.empty() ? name : absl::StrCat(name, ", ", mark);
}

absl::StatusOr<std::vector<WrittenFile>> WriteFieldOutputs(
    const Session& session, const FieldArguments& arguments,
    const Question& question, const Field& field) {
  const std::vector<Column> columns = ColumnsOf(arguments, field);
  // With the parameters that were used.
  const std::string mark =
      field.approximation.has_value()
          ? ApproximationMark(field.algorithm, *field.approximation)
          : arguments.mark();
  const auto write = [&](const OutputArgument& output,
                         const MeshArrays& mesh) -> absl::StatusOr<uint64_t> {
    if (output.format == OutputFormat::kNpz) {
      return WriteNpz(output.path, columns, field.target_distances, mark);
    }
    if (output.format == OutputFormat::kPng) {
      return WritePicture(output.path, mesh,
                          ContentOf(question, field, mark, mesh),
                          arguments.picture);
    }
    if (output.format == OutputFormat::kPly) {
      return WriteAnswerAsPly(session, arguments.mesh, field, mesh, columns,
                              mark, output.path);
    }
    return WriteFile(output.path, [&](AtomicFile* file) {
      switch (output.format) {
        case OutputFormat::kNpy:
          return WriteNpy(columns[0], file, mark);
        case OutputFormat::kCsv:
          return WriteCsv(columns, file);
        case OutputFormat::kF64:
          return AppendNumbers(columns[0].values, NumberType::kFloat64, file);
        case OutputFormat::kF32:
          return AppendNumbers(columns[0].values, NumberType::kFloat32, file);
        case OutputFormat::kHtml:
          return WriteViewerPage(mesh,
                                 {.name = PageName(arguments.mesh.text, mark),
                                  .mesh_digest = field.mesh_digest,
                                  .distances = field.distances,
                                  .sources = SourcePoints(question, mesh)},
                                 file);
        default:
          return WriteVtk(mesh, columns, file, mark);
      }
    });
  };
  return WriteOutputs(session, arguments.outputs, field,
                      {OutputFormat::kPly, OutputFormat::kVtk,
                       OutputFormat::kPng, OutputFormat::kHtml},
                      write);
}

// Writes lines "vertex,distance" as they come, to the outputs, or to the
// terminal if there are none. They stay even if the command is interrupted.
// Ends the call when nothing more can be written.
absl::StatusOr<Field> StreamRows(const Session& session,
                                 const FieldQuery& query,
                                 const FieldArguments& arguments,
                                 Stopwatch* watch, FieldExtremes* extremes,
                                 std::vector<WrittenFile>* written) {
  // The user can request a stop, and so does a failed write.
  std::stop_source stop;
  const std::stop_callback pass_on(session.call.stop,
                                   [&stop] { stop.request_stop(); });
  CallOptions call = session.call;
  call.stop = stop.get_token();

  Rows rows(session, arguments.outputs);
  rows.Write(absl::StrCat("vertex,", kDistanceColumn, "\n"));
  if (!rows.Flush()) stop.request_stop();
  CsvLine line;
  const NumberType type = NumberTypeOf(arguments.float32);
  const auto on_settled = [&](std::span<const SettledVertex> settled) {
    for (const SettledVertex& vertex : settled) {
      extremes->Add(vertex.vertex, vertex.distance);
      line.Number(vertex.vertex).Text(TextOf(vertex.distance, type));
      rows.Write(line.End());
    }
    if (!rows.Flush()) stop.request_stop();
  };
  absl::StatusOr<Field> field =
      session.client.StreamField(query, on_settled, call, watch->OnSolve());
  if (absl::Status status = rows.Close(written); !status.ok()) return status;
  return field;
}

Json ToJson(const FieldStatistics& statistics) {
  return {{"iterations", statistics.iterations},
          {"windows_created", statistics.windows_created},
          {"windows_propagated", statistics.windows_propagated},
          {"peak_wavefront", statistics.peak_wavefront},
          {"mean_wavefront", statistics.mean_wavefront},
          {"peak_windows", statistics.peak_windows},
          {"peak_solver_bytes", statistics.peak_solver_bytes},
          {"solve_seconds", statistics.solve_seconds}};
}

Report ReportOf(const FieldArguments& arguments, const Session& session,
                const Question& question, const Field& field,
                const FieldExtremes& extremes) {
  const bool is_limited =
      arguments.radius.has_value() || arguments.stop_at_targets.has_value();
  const uint64_t missing = field.vertex_count - extremes.reached;
  Report report;
  report.facts = {
      {"origin", std::string(FieldOriginName(field.origin))},
      {"vertices", GroupedNumber(field.vertex_count)},
      {"largest distance",
       extremes.reached == 0
           ? "none"
           : absl::StrCat(ShortNumber(extremes.largest), " at vertex ",
                          extremes.farthest_vertex)}};
  if (missing != 0) {
    report.facts.push_back({is_limited ? "not reached" : "unreachable",
                            absl::StrCat(GroupedNumber(missing), " vertices")});
  }
  if (is_limited && !field.approximation.has_value()) {
    report.facts.push_back(
        {field.certified_error.has_value() ? "certified up to" : "exact up to",
         ShortNumber(field.settled_radius)});
  }
  const std::vector<std::string> reasons =
      WhyUnreached(session, question.mesh_digest, question.sources,
                   question.targets, field.target_distances,
                   arguments.stop_at_targets.has_value()
                       ? "the search ended before it came there"
                       : BeyondRadius(arguments.radius));
  Json targets = Json::array();
  for (size_t i = 0; i < field.target_distances.size(); ++i) {
    const double distance = field.target_distances[i];
    report.facts.push_back(
        {absl::StrCat("to ", PointText(question.targets[i])),
         absl::StrCat(TextOf(distance, NumberTypeOf(arguments.float32)),
                      reasons[i].empty() ? "" : ": ", reasons[i])});
    Json target = PointToJson(question.targets[i]);
    target["distance"] = distance;
    target["unreached"] = reasons[i].empty() ? Json() : Json(reasons[i]);
    targets.push_back(std::move(target));
  }
  if (!field.approximation.has_value()) {
    report.facts.push_back(
        {"windows",
         absl::StrCat(GroupedNumber(field.statistics.windows_created),
                      " created, ",
                      GroupedNumber(field.statistics.windows_propagated),
                      " propagated")});
  }
  report.json = {
      {"origin", std::string(FieldOriginName(field.origin))},
      {"vertices", field.vertex_count},
      {"unreachable_vertices", missing},
      {"largest_distance",
       extremes.reached == 0 ? Json() : Json(extremes.largest)},
      {"farthest_vertex",
       extremes.reached == 0 ? Json() : Json(extremes.farthest_vertex)},
      {"settled_radius", field.settled_radius},
      {"targets", targets},
      {"statistics", ToJson(field.statistics)}};
  return report;
}

absl::Status Answer(const FieldArguments& arguments, const Session& session,
                    const Question& question) {
  const FieldQuery query = ToQuery(arguments, question);
  const std::vector<OutputArgument>& outputs = arguments.outputs;
  Stopwatch watch(session);
  FieldExtremes extremes;
  absl::StatusOr<std::vector<WrittenFile>> files = std::vector<WrittenFile>();
  absl::StatusOr<Field> field =
      arguments.progressive
          ? StreamRows(session, query, arguments, &watch, &extremes, &*files)
          : session.client.ComputeField(query, session.call,
                                        watch.OnSolve(query.tolerance == 0));
  if (!field.ok()) return field.status();
  const double seconds = watch.seconds();
  if (!arguments.progressive) {
    for (size_t v = 0; v < field->distances.size(); ++v) {
      extremes.Add(v, field->distances[v]);
    }
    files = WriteFieldOutputs(session, arguments, question, *field);
  }
  // If the rows went to the terminal, nothing else does.
  if (arguments.progressive && outputs.empty()) {
    PrintNotes(session, field->mesh_notes);
    PrintNotes(session, question.notes);
    return absl::OkStatus();
  }
  return PrintReport(session, question, *field, seconds, files,
                     ReportOf(arguments, session, question, *field, extremes));
}

}  // namespace

Command FieldCommand() {
  return MakeQuestion(
      "field", "Distances to every vertex, and to any point",
      "  geodesic field horse.ply --source 0 --source 77:0.02 -o horse.png\n"
      "  geodesic field horse.ply --source max:z --target nearest:0.1,-0.2,0\n"
      "  geodesic field horse.ply --source face:9@0.2,0.3,0.5 --radius 0.1 "
      "-o d.npy\n"
      "  geodesic field horse.ply --curve '0;edge:0-3@0.5' --source 9 "
      "-o f.npz\n"
      "  geodesic field horse.ply --source 0 --target 9 --stop-at-targets",
      AddOptions, Answer);
}

}  // namespace geodesic::client
