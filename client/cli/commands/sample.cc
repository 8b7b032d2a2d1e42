// sample: vertices far from each other.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/cli/commands/command.h"
#include "client/cli/commands/outputs.h"
#include "client/cli/commands/question.h"
#include "client/cli/commands/report.h"
#include "client/cli/commands/stopwatch.h"
#include "client/output/field_writers.h"
#include "client/output/number_text.h"
#include "client/places/surface_faces.h"

namespace geodesic::client {
namespace {

struct SampleArguments : QuestionArguments {
  uint64_t count = 10;
};

void AddOptions(CLI::App* app, SampleArguments* arguments) {
  arguments->may_have_tolerance = true;
  AddMesh(app, kMeshHelp, &arguments->mesh);
  AddValue(app, {"-n,--count", "How many samples to take; default: 10", "N"},
           ParseCount, &arguments->count);
  AddSources(app, Need::kOptional, &arguments->sources);
  AddQuestion(app, "Write the samples here", kSampleFormats, arguments);
}

// A sample with its place in space.
struct PlacedSample {
  FarthestSample sample;
  Point position = {};
};

absl::StatusOr<std::vector<PlacedSample>> Place(const Session& session,
                                                const SampleAnswer& answer) {
  absl::StatusOr<MeshArrays> mesh = FetchMesh(session, answer.info);
  if (!mesh.ok()) return mesh.status();
  std::vector<PlacedSample> placed;
  for (const FarthestSample& sample : answer.samples) {
    if (sample.vertex >= mesh->positions.size()) {
      return absl::DataLossError("the server sent a vertex the mesh has not");
    }
    placed.push_back({sample, mesh->positions[sample.vertex]});
  }
  return placed;
}

// `name` is that of distances.
Json SamplesJson(const std::vector<PlacedSample>& samples,
                 const std::string& name) {
  Json list = Json::array();
  for (const PlacedSample& sample : samples) {
    list.push_back({{"vertex", sample.sample.vertex},
                    {name, sample.sample.distance},
                    {"position", sample.position}});
  }
  return list;
}

void WriteCsv(const std::vector<PlacedSample>& samples, const std::string& name,
              AtomicFile* file) {
  file->Append(absl::StrCat("vertex,", name, ",x,y,z\n"));
  CsvLine line;
  for (const PlacedSample& sample : samples) {
    line.Number(sample.sample.vertex).Number(sample.sample.distance);
    for (const double coordinate : sample.position) line.Number(coordinate);
    file->Append(line.End());
  }
}

// Writes the samples as points, without faces.
void WritePly(const std::vector<PlacedSample>& samples, const std::string& mark,
              AtomicFile* file) {
  MeshArrays points;
  std::vector<Column> columns = {{.name = "vertex", .type = NumberType::kInt32},
                                 {.name = DistanceName(kDistanceColumn, mark)}};
  for (const PlacedSample& sample : samples) {
    points.positions.push_back(sample.position);
    columns[0].values.push_back(static_cast<double>(sample.sample.vertex));
    columns[1].values.push_back(sample.sample.distance);
  }
  WritePly(points, columns, file, mark);
}

Report ReportOf(const Session& session, const SampleAnswer& answer,
                uint64_t asked, const std::vector<PlacedSample>& samples,
                const std::string& name) {
  Report report = {.header = {"vertex", name}};
  for (const FarthestSample& sample : answer.samples) {
    report.rows.push_back(
        {NumberText(sample.vertex), NumberText(sample.distance)});
  }
  if (answer.samples.size() < asked) {
    report.notes.push_back(absl::StrCat(
        GroupedNumber(asked), " samples were asked for and ",
        GroupedNumber(answer.samples.size()),
        " are there: then every vertex of a face is a source or a sample, or "
        "in the same place as one"));
  }
  if (session.json) report.json["samples"] = SamplesJson(samples, name);
  return report;
}

// The first vertex of the surface: from others nothing is reached.
absl::StatusOr<uint32_t> FirstOnSurface(const Session& session,
                                        const std::string& mesh_digest) {
  const absl::StatusOr<MeshInfo> info =
      session.client.GetMesh(mesh_digest, session.call);
  // The shared tier may have it, from which the question fetches it.
  if (absl::IsNotFound(info.status())) return 0;
  if (!info.ok()) return info.status();
  if (info->isolated_vertices == 0) return 0;
  const absl::StatusOr<MeshArrays> mesh =
      session.client.ReadMesh(mesh_digest, session.call);
  if (!mesh.ok()) return mesh.status();
  uint32_t first = std::numeric_limits<uint32_t>::max();
  ForEachSurfaceFace(*mesh, [&first](uint32_t, const Triangle& corners) {
    first = std::min(first, std::ranges::min(corners));
  });
  return first;
}

absl::Status Answer(const SampleArguments& arguments, const Session& session,
                    const Question& asked) {
  Question question = asked;
  if (question.sources.empty()) {
    const absl::StatusOr<uint32_t> first =
        FirstOnSurface(session, question.mesh_digest);
    if (!first.ok()) return first.status();
    question.sources.push_back({.place = VertexPoint{*first}});
  }
  auto query = MakeQuery<SampleQuery>(arguments, question);
  query.count = arguments.count;
  Stopwatch watch(session);
  absl::StatusOr<SampleAnswer> answer = session.client.SampleFarthestPoints(
      query, session.call, watch.OnSolve(query.tolerance == 0));
  if (!answer.ok()) return answer.status();
  const double seconds = watch.seconds();
  std::vector<PlacedSample> samples;
  if (session.json || !arguments.outputs.empty()) {
    absl::StatusOr<std::vector<PlacedSample>> placed = Place(session, *answer);
    if (!placed.ok()) return placed.status();
    samples = *std::move(placed);
  }
  const std::string mark = arguments.mark();
  const std::string name = DistanceName("distance", mark);
  const auto write = [&](const OutputArgument& output, const MeshArrays&) {
    return WriteFile(output.path, [&](AtomicFile* file) {
      if (output.format == OutputFormat::kCsv) {
        WriteCsv(samples, name, file);
      } else if (output.format == OutputFormat::kPly) {
        WritePly(samples, mark, file);
      } else {
        file->Append(SamplesJson(samples, name).dump(2) + "\n");
      }
    });
  };
  return PrintReport(
      session, question, answer->info, seconds,
      WriteOutputs(session, arguments.outputs, answer->info, {}, write),
      ReportOf(session, *answer, arguments.count, samples, name));
}

}  // namespace

Command SampleCommand() {
  return MakeQuestion("sample", "Vertices far from each other",
                      "  geodesic sample horse.ply --count 100 -o samples.ply",
                      AddOptions, Answer);
}

}  // namespace geodesic::client
