// field: computes a distance field and writes it to files.

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/cli/commands.h"
#include "client/cli/field_outputs.h"
#include "client/cli/question.h"
#include "client/output/columns.h"
#include "client/output/csv.h"
#include "client/output/number_text.h"
#include "client/output/place_text.h"

namespace geodesic::client {
namespace {

// What the distances have in common.
struct FieldExtremes {
  // 0 if no vertex is reached.
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

FieldQuery ToQuery(const Arguments& arguments, const Question& question) {
  FieldQuery query = {.mesh_digest = question.mesh_digest,
                      .sources = question.sources,
                      .algorithm = arguments.algorithm,
                      .targets = question.targets,
                      .max_distance = arguments.radius,
                      .nearest_sources = arguments.labels,
                      .gradients = arguments.gradients,
                      .value_type = arguments.float32 ? ValueType::kFloat32
                                                      : ValueType::kFloat64,
                      .priority = arguments.priority};
  if (arguments.stop_at_targets.has_value()) {
    query.stop_after_targets = *arguments.stop_at_targets == kAllTargets
                                   ? question.targets.size()
                                   : *arguments.stop_at_targets;
  }
  return query;
}

// A field and what became of it here.
struct Outcome {
  Field field;
  FieldExtremes extremes;
  std::vector<WrittenFile> files;
  double call_seconds = 0;
};

absl::StatusOr<Outcome> Compute(const Session& session,
                                const Question& question,
                                const FieldQuery& query) {
  Stopwatch watch(session);
  absl::StatusOr<Field> field =
      session.client.ComputeField(query, session.call, watch.OnSolve());
  if (!field.ok()) return field.status();
  Outcome outcome = {.call_seconds = watch.seconds()};
  for (size_t v = 0; v < field->distances.size(); ++v) {
    outcome.extremes.Add(v, field->distances[v]);
  }
  absl::StatusOr<std::vector<WrittenFile>> files =
      WriteFieldOutputs(session, question, *field);
  if (!files.ok()) return files.status();
  outcome.files = *std::move(files);
  outcome.field = *std::move(field);
  return outcome;
}

// Lines "vertex,distance" to the outputs, or to the terminal, as they come.
// What has come is there even if the command is interrupted.
absl::StatusOr<Outcome> Stream(const Session& session,
                               const FieldQuery& query) {
  std::vector<std::FILE*> files;
  const auto close_all = [&files] {
    int failures = 0;
    for (std::FILE* file : files) failures += std::fclose(file) == 0 ? 0 : 1;
    files.clear();
    return failures;
  };
  const auto cannot_write = [&session] {
    return FileError(absl::ErrnoToStatus(
        errno,
        absl::StrCat("cannot write ", session.arguments.outputs[0].path)));
  };
  for (const OutputArgument& output : session.arguments.outputs) {
    std::FILE* file = std::fopen(output.path.c_str(), "w");
    if (file == nullptr) {
      close_all();
      return cannot_write();
    }
    files.push_back(file);
  }
  const auto write = [&](const std::string& text) {
    for (std::FILE* file : files) std::fputs(text.c_str(), file);
    if (files.empty()) session.out << text;
  };
  const auto flush = [&] {
    for (std::FILE* file : files) std::fflush(file);
    if (files.empty()) session.out.flush();
  };
  write(absl::StrCat("vertex,", kDistanceColumn, "\n"));

  Outcome outcome;
  Stopwatch watch(session);
  CsvLine line;
  const auto on_settled = [&](std::span<const SettledVertex> settled) {
    for (const SettledVertex& vertex : settled) {
      outcome.extremes.Add(vertex.vertex, vertex.distance);
      line.Integer(vertex.vertex).Number(vertex.distance);
      write(line.End());
    }
    flush();
  };
  absl::StatusOr<Field> field = session.client.StreamField(
      query, on_settled, session.call, watch.OnSolve());
  outcome.call_seconds = watch.seconds();
  for (size_t i = 0; i < files.size(); ++i) {
    outcome.files.push_back({session.arguments.outputs[i],
                             static_cast<uint64_t>(std::ftell(files[i]))});
  }
  const bool failed =
      std::ranges::any_of(files, [](std::FILE* f) { return ferror(f) != 0; });
  if (close_all() != 0 || failed) return cannot_write();
  if (!field.ok()) return field.status();
  outcome.field = *std::move(field);
  return outcome;
}

Json OutcomeJson(const Question& question, const Outcome& outcome) {
  const Field& field = outcome.field;
  Json targets = Json::array();
  for (size_t i = 0; i < field.target_distances.size(); ++i) {
    Json target = PointToJson(question.targets[i]);
    target["distance"] = field.target_distances[i];
    targets.push_back(std::move(target));
  }
  return {
      {"mesh", field.mesh_digest},
      {"algorithm", field.algorithm},
      {"sources", ToJson(question.sources)},
      {"origin", std::string(FieldOriginName(field.origin))},
      {"vertices", field.vertex_count},
      {"unreachable_vertices", field.vertex_count - outcome.extremes.reached},
      {"max_distance", outcome.extremes.largest},
      {"farthest_vertex", outcome.extremes.farthest_vertex},
      {"settled_radius", field.settled_radius},
      {"targets", targets},
      {"relative_tolerance", field.relative_tolerance},
      {"statistics", ToJson(field.statistics)},
      {"call_seconds", outcome.call_seconds},
      {"server_version", field.server_version},
      {"outputs", ToJson(outcome.files)}};
}

void Print(const Session& session, const Question& question,
           const Outcome& outcome) {
  const Field& field = outcome.field;
  const FieldStatistics& statistics = field.statistics;
  const bool is_limited = session.arguments.radius.has_value() ||
                          session.arguments.stop_at_targets.has_value();
  std::vector<Fact> facts = {
      {"mesh", field.mesh_digest},
      {"algorithm", field.algorithm},
      {"origin", std::string(FieldOriginName(field.origin))},
      {"vertices", GroupedNumber(field.vertex_count)},
      {"largest distance",
       absl::StrCat(ShortNumber(outcome.extremes.largest), " at vertex ",
                    outcome.extremes.farthest_vertex)}};
  const uint64_t missing = field.vertex_count - outcome.extremes.reached;
  if (missing != 0) {
    facts.push_back({is_limited ? "not reached" : "unreachable",
                     absl::StrCat(GroupedNumber(missing), " vertices")});
  }
  if (is_limited) {
    facts.push_back({"exact up to", ShortNumber(field.settled_radius)});
  }
  for (size_t i = 0; i < field.target_distances.size(); ++i) {
    facts.push_back({absl::StrCat("to ", PointText(question.targets[i])),
                     NumberText(field.target_distances[i])});
  }
  facts.push_back(
      {"windows",
       absl::StrCat(GroupedNumber(statistics.windows_created), " created, ",
                    GroupedNumber(statistics.windows_propagated),
                    " propagated")});
  facts.push_back({"solver", Seconds(statistics.solve_seconds)});
  facts.push_back({"this call", Seconds(outcome.call_seconds)});
  AddFileFacts(outcome.files, &facts);
  PrintFacts(facts, &session.out);
}

}  // namespace

absl::Status RunField(const Session& session) {
  absl::StatusOr<Question> question = Prepare(session);
  if (!question.ok()) return question.status();
  const FieldQuery query = ToQuery(session.arguments, *question);
  const bool is_stream = session.arguments.progressive;
  absl::StatusOr<Outcome> outcome =
      is_stream ? Stream(session, query) : Compute(session, *question, query);
  if (!outcome.ok()) return outcome.status();
  if (session.arguments.json) {
    PrintJson(OutcomeJson(*question, *outcome), &session.out);
  } else if (!is_stream || !outcome->files.empty()) {
    Print(session, *question, *outcome);
  }
  return absl::OkStatus();
}

}  // namespace geodesic::client
