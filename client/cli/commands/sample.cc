// sample: vertices far from each other.

#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/cli/arguments/values.h"
#include "client/cli/commands/command.h"
#include "client/cli/commands/question.h"
#include "client/output/csv.h"
#include "client/output/field_writers.h"
#include "client/output/number_text.h"

namespace geodesic::client {
namespace {

struct SampleArguments {
  QuestionArguments question;
  uint64_t count = 10;
};

void AddOptions(CLI::App* app, SampleArguments* arguments) {
  AddMesh(app, kMeshHelp, &arguments->question.mesh);
  AddValue(app, {"-n,--count", "How many samples to take; default: 10", "N"},
           ParseCount, &arguments->count);
  AddSources(app, Need::kOptional, &arguments->question.sources);
  AddQuestion(app, "Write the samples here", kSampleFormats,
              &arguments->question);
}

// A sample with its place in space.
struct PlacedSample {
  FarthestSample sample;
  Point position = {};
};

absl::StatusOr<std::vector<PlacedSample>> Place(const SampleAnswer& answer,
                                                MeshOnDemand* mesh) {
  absl::StatusOr<const MeshArrays*> arrays =
      mesh->Get(answer.info.vertex_count);
  if (!arrays.ok()) return arrays.status();
  std::vector<PlacedSample> placed;
  for (const FarthestSample& sample : answer.samples) {
    if (sample.vertex >= (*arrays)->positions.size()) {
      return absl::DataLossError("the server sent a vertex the mesh has not");
    }
    placed.push_back({sample, (*arrays)->positions[sample.vertex]});
  }
  return placed;
}

Json SamplesJson(const std::vector<PlacedSample>& samples) {
  Json list = Json::array();
  for (const PlacedSample& sample : samples) {
    list.push_back({{"vertex", sample.sample.vertex},
                    {"distance", sample.sample.distance},
                    {"position", sample.position}});
  }
  return list;
}

void WriteCsv(const std::vector<PlacedSample>& samples, AtomicFile* file) {
  file->Append("vertex,distance,x,y,z\n");
  CsvLine line;
  for (const PlacedSample& sample : samples) {
    line.Integer(static_cast<int64_t>(sample.sample.vertex))
        .Number(sample.sample.distance);
    for (const double coordinate : sample.position) line.Number(coordinate);
    file->Append(line.End());
  }
}

// Points without faces.
void WritePly(const std::vector<PlacedSample>& samples, AtomicFile* file) {
  MeshArrays points;
  std::vector<Column> columns = {{.name = "vertex", .type = NumberType::kInt32},
                                 {.name = kDistanceColumn}};
  for (const PlacedSample& sample : samples) {
    points.positions.push_back(sample.position);
    columns[0].values.push_back(static_cast<double>(sample.sample.vertex));
    columns[1].values.push_back(sample.sample.distance);
  }
  WritePly(points, columns, file);
}

Report ReportOf(const Session& session, const SampleAnswer& answer,
                const std::vector<PlacedSample>& samples) {
  Report report = {.header = {"vertex", "distance"}};
  for (const FarthestSample& sample : answer.samples) {
    report.rows.push_back(
        {NumberText(sample.vertex), NumberText(sample.distance)});
  }
  if (session.json) report.json["samples"] = SamplesJson(samples);
  return report;
}

absl::Status Answer(const SampleArguments& arguments, const Session& session,
                    const Question& asked) {
  Question question = asked;
  if (question.sources.empty()) {
    question.sources.push_back({.place = VertexPoint{0}});
  }
  Stopwatch watch(session);
  absl::StatusOr<SampleAnswer> answer = session.client.SampleFarthestPoints(
      {.mesh_digest = question.mesh_digest,
       .sources = question.sources,
       .count = arguments.count,
       .algorithm = arguments.question.algorithm,
       .priority = arguments.question.priority},
      session.call, watch.OnSolve());
  if (!answer.ok()) return answer.status();
  const double seconds = watch.seconds();
  const std::vector<OutputArgument>& outputs = arguments.question.outputs;
  std::vector<PlacedSample> samples;
  if (session.json || !outputs.empty()) {
    MeshOnDemand mesh(session, question.mesh_digest);
    absl::StatusOr<std::vector<PlacedSample>> placed = Place(*answer, &mesh);
    if (!placed.ok()) return placed.status();
    samples = *std::move(placed);
  }
  absl::StatusOr<std::vector<WrittenFile>> files =
      WriteOutputs(session, outputs, [&](const OutputArgument& output) {
        return WriteFile(output.path, [&](AtomicFile* file) {
          if (output.format == OutputFormat::kCsv) {
            WriteCsv(samples, file);
          } else if (output.format == OutputFormat::kPly) {
            WritePly(samples, file);
          } else {
            file->Append(SamplesJson(samples).dump(2) + "\n");
          }
          return absl::OkStatus();
        });
      });
  if (!files.ok()) return files.status();
  PrintReport(session, question, answer->info, seconds, *files,
              ReportOf(session, *answer, samples));
  return absl::OkStatus();
}

}  // namespace

Command SampleCommand() {
  return MakeQuestion("sample", "Vertices far from each other",
                      "  geodesic sample horse.ply --count 100 -o samples.ply",
                      AddOptions, Answer);
}

}  // namespace geodesic::client
