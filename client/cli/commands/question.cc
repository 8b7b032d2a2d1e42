#include "client/cli/commands/question.h"

#include <algorithm>
#include <filesystem>
#include <type_traits>
#include <utility>

#include "absl/strings/str_cat.h"
#include "client/cli/commands/mesh_argument.h"
#include "client/output/extended_ply.h"
#include "client/output/place_text.h"
#include "client/places/place_finder.h"

namespace geodesic::client {
namespace {

// Appends what the files list to `items`. It is an error if `items` is then
// empty, unless there are no files.
template <typename Item, typename Read>
absl::Status AppendLists(const std::vector<std::string>& files, Read read,
                         std::vector<Item>* items) {
  for (const std::string& file : files) {
    absl::StatusOr<std::vector<Item>> list = read(file);
    if (!list.ok()) return FileError(list.status());
    items->insert(items->end(), list->begin(), list->end());
  }
  if (!items->empty() || files.empty()) return absl::OkStatus();
  return FileError(absl::InvalidArgumentError(absl::StrCat(
      ListName(files[0]), " lists nothing: write one place a line")));
}

// The places of a question, in the order in which the server numbers them.
struct WrittenPlaces {
  std::vector<WrittenSource> sources;
  std::vector<WrittenPoint> targets;
};

// Checks that the outputs can be written, and reads the lists.
absl::StatusOr<WrittenPlaces> Prepare(const QuestionArguments& arguments) {
  const SourceArguments& sources = arguments.sources;
  const TargetArguments& targets = arguments.targets;
  std::vector<std::string> inputs = arguments.other_inputs;
  inputs.insert(inputs.end(), sources.files.begin(), sources.files.end());
  inputs.insert(inputs.end(), targets.files.begin(), targets.files.end());
  std::vector<std::string> inputs_and_mesh = inputs;
  inputs_and_mesh.push_back(arguments.mesh.text);
  for (const OutputArgument& output : arguments.outputs) {
    const bool keeps_mesh =
        arguments.adds_to_ply && output.format == OutputFormat::kPly;
    absl::Status status =
        CheckWritable(output.path, keeps_mesh ? inputs : inputs_and_mesh);
    if (!status.ok()) return FileError(status);
  }
  WrittenPlaces places = {.sources = sources.points, .targets = targets.points};
  places.sources.insert(places.sources.end(), sources.curves.begin(),
                        sources.curves.end());
  absl::Status status =
      AppendLists(sources.files, ReadSources, &places.sources);
  status.Update(AppendLists(targets.files, ReadPoints, &places.targets));
  if (!status.ok()) return status;
  return places;
}

// The question about the mesh with this digest. Reads the mesh if a place has
// to be looked for.
absl::StatusOr<Question> FindPlaces(const Session& session,
                                    const WrittenPlaces& places,
                                    const std::string& digest) {
  PlaceFinder finder(
      [&] { return session.client.ReadMesh(digest, session.call); });
  Question question = {.mesh_digest = digest};
  for (const WrittenSource& written : places.sources) {
    absl::StatusOr<Source> source = finder.Find(written);
    if (!source.ok()) return source.status();
    question.sources.push_back(*std::move(source));
  }
  for (const WrittenPoint& written : places.targets) {
    absl::StatusOr<SurfacePoint> target = finder.Find(written);
    if (!target.ok()) return target.status();
    question.targets.push_back(*target);
  }
  return question;
}

// Where a point lies in space.
Point PositionOf(const SurfacePoint& point, const MeshArrays& mesh) {
  std::vector<std::pair<double, uint64_t>> corners;  // weights and vertices
  if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
    corners = {{1, vertex->vertex}};
  } else if (const auto* edge = std::get_if<EdgePoint>(&point)) {
    corners = {{1 - edge->t, edge->from}, {edge->t, edge->to}};
  } else if (const auto& at = std::get<FacePoint>(point);
             at.face < mesh.triangles.size()) {
    for (size_t i = 0; i < at.weights.size(); ++i) {
      corners.emplace_back(at.weights[i], mesh.triangles[at.face][i]);
    }
  }
  Point sum = {};
  for (const auto& [weight, vertex] : corners) {
    if (vertex >= mesh.positions.size()) continue;
    for (size_t axis = 0; axis < sum.size(); ++axis) {
      sum[axis] += weight * mesh.positions[vertex][axis];
    }
  }
  return sum;
}

Json FilesJson(const std::vector<WrittenFile>& files) {
  Json outputs = Json::array();
  for (const WrittenFile& file : files) {
    outputs.push_back(
        {{"path", file.output.path},
         {"format", std::string(OutputFormatName(file.output.format))},
         {"bytes", file.bytes}});
  }
  return outputs;
}

Json SourcesJson(const std::vector<Source>& sources) {
  Json list = Json::array();
  for (const Source& source : sources) list.push_back(SourceToJson(source));
  return list;
}

double PartReached(const SolveProgress& progress) {
  if (progress.vertex_count == 0) return 0;
  return static_cast<double>(progress.vertices_reached) /
         static_cast<double>(progress.vertex_count);
}

}  // namespace

Json ParametersJson(const Approximation& approximation) {
  Json parameters = Json::object();
  if (approximation.lambda.has_value()) {
    parameters["lambda"] = *approximation.lambda;
  }
  if (approximation.neighbours.has_value()) {
    parameters["k"] = *approximation.neighbours;
  }
  if (approximation.samples.has_value()) {
    parameters["samples"] = *approximation.samples;
  }
  return parameters;
}

absl::Status AskQuestion(
    const Session& session, const QuestionArguments& arguments,
    const std::function<absl::Status(const Question&)>& answer) {
  absl::StatusOr<WrittenPlaces> places = Prepare(arguments);
  if (!places.ok()) return places.status();
  return AskAboutMesh(session, arguments.mesh, [&](const std::string& digest) {
    absl::StatusOr<Question> question = FindPlaces(session, *places, digest);
    if (!question.ok()) return question.status();
    absl::Status status = PrepareMesh(session, digest, arguments.algorithm,
                                      arguments.approximation);
    return status.ok() ? answer(*question) : status;
  });
}

absl::Status PrepareMesh(const Session& session, const std::string& mesh_digest,
                         const std::string& algorithm,
                         const Approximation& approximation) {
  if (!IsApproximate(algorithm)) return absl::OkStatus();
  Stopwatch watch(session);
  return session.client
      .Prepare({.mesh_digest = mesh_digest,
                .algorithm = algorithm,
                .approximation = approximation},
               session.call, watch.OnPrepare("preparing"))
      .status();
}

SolveProgressCallback Stopwatch::OnSolve(bool is_exact) {
  return [this, is_exact](const SolveProgress& progress) {
    const bool waits =
        progress.vertices_reached == 0 && progress.windows_propagated == 0;
    display_.Update(
        Clock::now(), waits ? "waiting" : "solving", PartReached(progress),
        waits ? "for a free thread"
              : absl::StrCat(is_exact ? "exact" : "certified", " up to ",
                             ShortNumber(progress.settled_radius), ", ",
                             GroupedNumber(progress.windows_propagated),
                             " windows"));
  };
}

SolveProgressCallback Stopwatch::OnPrepare(const std::string& what) {
  return [this, what](const SolveProgress& progress) {
    display_.Update(
        Clock::now(), what, PartReached(progress),
        absl::StrCat(GroupedNumber(progress.vertices_reached), " of ",
                     GroupedNumber(progress.vertex_count), " vertices"));
  };
}

std::function<void(uint64_t, uint64_t)> Stopwatch::OnCount(
    const std::string& what) {
  return [this, what](uint64_t finished, uint64_t total) {
    display_.Update(
        Clock::now(), "solving",
        total == 0 ? 0
                   : static_cast<double>(finished) / static_cast<double>(total),
        absl::StrCat(GroupedNumber(finished), " of ", GroupedNumber(total), " ",
                     what));
  };
}

absl::StatusOr<MeshArrays> FetchMesh(const Session& session,
                                     const AnswerInfo& info) {
  absl::StatusOr<MeshArrays> mesh =
      session.client.ReadMesh(info.mesh_digest, session.call);
  if (mesh.ok() && mesh->positions.size() != info.vertex_count) {
    return absl::DataLossError(
        absl::StrCat("the server sent a mesh of ", mesh->positions.size(),
                     " vertices and an answer for ", info.vertex_count));
  }
  return mesh;
}

absl::StatusOr<uint64_t> WriteFile(
    const std::string& path, const std::function<void(AtomicFile*)>& write) {
  absl::StatusOr<AtomicFile> file = AtomicFile::Create(path);
  if (!file.ok()) return FileError(file.status());
  write(&*file);
  if (absl::Status status = file->Commit(); !status.ok()) {
    return FileError(status);
  }
  return file->size();
}

absl::StatusOr<uint64_t> WriteAnswerAsPly(const Session& session,
                                          const MeshArgument& argument,
                                          const AnswerInfo& info,
                                          const MeshArrays& mesh,
                                          std::span<const Column> columns,
                                          const std::string& mark,
                                          const std::string& path) {
  std::optional<std::string> extended;
  if (IsPlyFileOf(session, argument, info.mesh_digest)) {
    extended = ExtendedPlyFile(argument.text, columns, mark);
  }
  if (!extended.has_value() && IsPlyFile(argument)) {
    const std::string lost = absl::StrCat(
        "what else ", argument.text,
        " holds, such as colours, cannot be kept: it has changed meanwhile, or "
        "values cannot be added to it");
    std::error_code error;
    if (std::filesystem::equivalent(path, argument.text, error)) {
      return FileError(absl::FailedPreconditionError(
          absl::StrCat(lost, "; write to another file")));
    }
    session.err << "geodesic: " << Printable(lost) << '\n';
  }
  return WriteFile(path, [&](AtomicFile* file) {
    if (extended.has_value()) return file->Append(*extended);
    WritePly(mesh, columns, file, mark);
  });
}

void ShowSources(const std::vector<Source>& sources, const MeshArrays& mesh,
                 PictureContent* content) {
  const auto show = [&](const auto& place) {
    if constexpr (std::is_same_v<decltype(place), const Curve&>) {
      PictureLine& line = content->bold_lines.emplace_back();
      for (const SurfacePoint& point : place.points) {
        line.points.push_back(PositionOf(point, mesh));
      }
    } else {
      content->sources.push_back(PositionOf(place, mesh));
    }
  };
  for (const Source& source : sources) std::visit(show, source.place);
}

void ShowTargets(const std::vector<SurfacePoint>& targets,
                 const MeshArrays& mesh, PictureContent* content) {
  for (const SurfacePoint& target : targets) {
    content->targets.push_back(PositionOf(target, mesh));
  }
}

absl::StatusOr<uint64_t> WritePicture(const std::string& path,
                                      const MeshArrays& mesh,
                                      const PictureContent& content,
                                      const PictureOptions& options) {
  absl::StatusOr<std::string> png = Render(mesh, content, options).EncodePng();
  if (!png.ok()) return png.status();
  return WriteFile(path, [&png](AtomicFile* file) { file->Append(*png); });
}

absl::StatusOr<std::vector<WrittenFile>> WriteOutputs(
    const Session& session, const std::vector<OutputArgument>& outputs,
    const AnswerInfo& info, std::initializer_list<OutputFormat> with_mesh,
    const std::function<absl::StatusOr<uint64_t>(
        const OutputArgument&, const MeshArrays& mesh)>& write) {
  std::vector<WrittenFile> written;
  const MeshArrays none;
  std::optional<MeshArrays> mesh;
  for (const OutputArgument& output : outputs) {
    if (session.call.stop.stop_requested()) {
      return absl::CancelledError("stopped before all files were written");
    }
    const bool needs_mesh = std::ranges::count(with_mesh, output.format) > 0;
    if (needs_mesh && !mesh.has_value()) {
      absl::StatusOr<MeshArrays> fetched = FetchMesh(session, info);
      if (!fetched.ok()) return fetched.status();
      mesh = *std::move(fetched);
    }
    const MeshArrays& wanted = needs_mesh ? *mesh : none;
    absl::StatusOr<uint64_t> bytes = write(output, wanted);
    if (!bytes.ok()) return bytes.status();
    written.push_back({output, *bytes});
  }
  return written;
}

absl::Status PrintReport(const Session& session, const Question& question,
                         const AnswerInfo& info, double call_seconds,
                         const absl::StatusOr<std::vector<WrittenFile>>& files,
                         const Report& report) {
  if (!files.ok()) return files.status();
  if (session.json) {
    *session.json = {{"mesh", info.mesh_digest}, {"algorithm", info.algorithm}};
    if (!question.sources.empty()) {
      (*session.json)["sources"] = SourcesJson(question.sources);
    }
    session.json->update(Json{{"approximate", info.approximation.has_value()}});
    if (info.approximation.has_value()) {
      (*session.json)["parameters"] = ParametersJson(*info.approximation);
    }
    // Null where distances are exact, or nothing is certified.
    (*session.json)["certified_error"] =
        info.certified_error.has_value() ? Json(*info.certified_error) : Json();
    // Infinity, where no bound is known, is null.
    session.json->update(Json{{"relative_tolerance", info.relative_tolerance},
                              {"windows_propagated", info.windows_propagated},
                              {"compute_seconds", info.compute_seconds},
                              {"call_seconds", call_seconds},
                              {"server_version", info.server_version}});
    session.json->update(report.json);
    (*session.json)["outputs"] = FilesJson(*files);
    return absl::OkStatus();
  }
  if (session.quiet && !files->empty()) return absl::OkStatus();
  // Nothing else goes where an answer went.
  const bool is_taken = std::ranges::any_of(*files, [](const auto& file) {
    return file.output.path == kStandardOutput;
  });
  std::ostream& out = is_taken ? session.err : session.out;
  if (!report.header.empty()) {
    PrintTable(report.header, report.rows, &out);
    if (!session.quiet) out << '\n';
  }
  std::optional<Fact> inexact;
  if (info.approximation.has_value()) {
    inexact = {"distances", "approximate: no bound on their error"};
  } else if (info.certified_error.has_value()) {
    inexact = {"distances", absl::StrCat("certified within ",
                                         ShortNumber(*info.certified_error),
                                         " (relative error)")};
  }
  if (session.quiet) {
    std::vector<Fact> facts = report.facts;
    if (inexact.has_value() && !facts.empty()) {
      facts.insert(facts.begin(), *inexact);
    }
    PrintFacts(facts, &out);
    return absl::OkStatus();
  }
  std::vector<Fact> facts = {{"mesh", info.mesh_digest},
                             {"algorithm", info.algorithm}};
  if (info.approximation.has_value()) {
    facts.back().second = AlgorithmText(info.algorithm, *info.approximation);
  }
  if (inexact.has_value()) facts.push_back(*inexact);
  facts.insert(facts.end(), report.facts.begin(), report.facts.end());
  // Rows of a matrix are computed at the same time.
  facts.push_back({"solver", absl::StrCat(Seconds(info.compute_seconds),
                                          info.compute_seconds > call_seconds
                                              ? " over all threads"
                                              : "")});
  facts.push_back({"this call", Seconds(call_seconds)});
  for (const WrittenFile& file : *files) {
    facts.push_back({"wrote", absl::StrCat(file.output.path == kStandardOutput
                                               ? "standard output"
                                               : file.output.path,
                                           " (", ByteCount(file.bytes), ")")});
  }
  PrintFacts(facts, &out);
  return absl::OkStatus();
}

absl::Status OutputFailed() {
  return absl::AbortedError("the output cannot be written");
}

}  // namespace geodesic::client
