// field: computes a distance field and writes it to files.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/cli/commands/command.h"
#include "client/cli/commands/field_outputs.h"
#include "client/output/number_text.h"
#include "client/output/place_text.h"

namespace geodesic::client {
namespace {

// What --stop-at-targets means without a count.
constexpr int64_t kAllTargets = 0x7fffffffffffffff;

void Check(const CLI::App& app, const FieldArguments& arguments) {
  const TargetArguments& targets = arguments.targets;
  if (arguments.stop_at_targets.has_value() && targets.points.empty() &&
      targets.files.empty()) {
    Refuse("--stop-at-targets", "needs --target or --targets");
  }
  if (!arguments.progressive) return;
  if (arguments.nearest_sources || arguments.gradients) {
    Refuse("--progressive",
           "gives distances only: leave --nearest-sources "
           "and --gradients to a run without it");
  }
  for (const OutputArgument& output : arguments.outputs) {
    if (output.format != OutputFormat::kCsv) {
      Refuse("--progressive", "writes .csv only, not " + output.path);
    }
  }
  if (arguments.outputs.empty() && WantsJson(app)) {
    Refuse("--progressive", "with --json needs -o FILE.csv for the distances");
  }
}

void AddOptions(CLI::App* app, FieldArguments* arguments) {
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
  AddFloat32(app, &arguments->float32);
  AddFlag(app,
          {"--progressive",
           "Print vertices and their distances as they become final, in "
           "order of distance; or write them to -o FILE.csv"},
          &arguments->progressive);
  AddQuestion(app,
              "Write the field here (nearest sources and gradients too in "
              ".npz, .csv, .ply and .vtk)",
              kFieldFormats, arguments,
              [app, arguments] { Check(*app, *arguments); });
  AddPicture(app, &arguments->picture);
}

FieldQuery ToQuery(const FieldArguments& arguments, const Question& question) {
  auto query = MakeQuery<FieldQuery>(arguments, question);
  query.nearest_sources = arguments.nearest_sources;
  query.gradients = arguments.gradients;
  if (arguments.stop_at_targets.has_value()) {
    query.stop_after_targets = *arguments.stop_at_targets == kAllTargets
                                   ? question.targets.size()
                                   : *arguments.stop_at_targets;
  }
  return query;
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

Report ReportOf(const FieldArguments& arguments, const Question& question,
                const Field& field, const FieldExtremes& extremes) {
  const bool is_limited =
      arguments.radius.has_value() || arguments.stop_at_targets.has_value();
  const uint64_t missing = field.vertex_count - extremes.reached;
  Report report;
  report.facts = {{"origin", std::string(FieldOriginName(field.origin))},
                  {"vertices", GroupedNumber(field.vertex_count)},
                  {"largest distance",
                   absl::StrCat(ShortNumber(extremes.largest), " at vertex ",
                                extremes.farthest_vertex)}};
  if (missing != 0) {
    report.facts.push_back({is_limited ? "not reached" : "unreachable",
                            absl::StrCat(GroupedNumber(missing), " vertices")});
  }
  if (is_limited) {
    report.facts.push_back({"exact up to", ShortNumber(field.settled_radius)});
  }
  Json targets = Json::array();
  for (size_t i = 0; i < field.target_distances.size(); ++i) {
    const double distance = field.target_distances[i];
    report.facts.push_back({absl::StrCat("to ", PointText(question.targets[i])),
                            NumberText(distance)});
    Json target = PointToJson(question.targets[i]);
    target["distance"] = distance;
    targets.push_back(std::move(target));
  }
  report.facts.push_back(
      {"windows",
       absl::StrCat(
           GroupedNumber(field.statistics.windows_created), " created, ",
           GroupedNumber(field.statistics.windows_propagated), " propagated")});
  report.json = {{"origin", std::string(FieldOriginName(field.origin))},
                 {"vertices", field.vertex_count},
                 {"unreachable_vertices", missing},
                 {"largest_distance", extremes.largest},
                 {"farthest_vertex", extremes.farthest_vertex},
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
          ? StreamRows(session, query, outputs, &watch, &extremes, &*files)
          : session.client.ComputeField(query, session.call, watch.OnSolve());
  if (!field.ok()) return field.status();
  const double seconds = watch.seconds();
  if (!arguments.progressive) {
    for (size_t v = 0; v < field->distances.size(); ++v) {
      extremes.Add(v, field->distances[v]);
    }
    files = WriteFieldOutputs(session, arguments, question, *field);
  }
  // Rows that went to the terminal are all that it gets.
  if (arguments.progressive && outputs.empty()) return absl::OkStatus();
  const bool is_cached = field->origin == FieldOrigin::kCached;
  const FieldStatistics& statistics = field->statistics;
  return PrintReport(
      session, question,
      {.mesh_digest = field->mesh_digest,
       .vertex_count = field->vertex_count,
       .algorithm = field->algorithm,
       .relative_tolerance = field->relative_tolerance,
       .server_version = field->server_version,
       .compute_seconds = is_cached ? 0 : statistics.solve_seconds,
       .windows_propagated = is_cached ? 0 : statistics.windows_propagated},
      seconds, files, ReportOf(arguments, question, *field, extremes));
}

}  // namespace

Command FieldCommand() {
  return MakeQuestion(
      "field", "Distances to every vertex, and to any point",
      "  geodesic field horse.ply --source 0 --source 77:0.02 -o horse.png\n"
      "  geodesic field horse.ply --source face:9@0.2,0.3,0.5 --radius 0.1 "
      "-o d.npy\n"
      "  geodesic field horse.ply --curve '0;edge:0-3@0.5' --source 9 "
      "-o f.npz\n"
      "  geodesic field horse.ply --source 0 --target 9 --stop-at-targets",
      AddOptions, Answer);
}

}  // namespace geodesic::client
