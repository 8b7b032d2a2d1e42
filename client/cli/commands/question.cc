#include "client/cli/commands/question.h"

#include <cmath>
#include <optional>
#include <variant>

#include "absl/strings/str_cat.h"
#include "client/cli/commands/mesh_argument.h"
#include "client/cli/commands/notes.h"
#include "client/cli/commands/outputs.h"
#include "client/cli/terminal/exit_code.h"
#include "client/output/atomic_file.h"
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
  for (const OutputArgument& output : arguments.outputs) {
    const bool keeps_mesh =
        arguments.adds_to_ply && output.format == OutputFormat::kPly;
    absl::Status status = CheckWritable(output.path, inputs);
    if (status.ok() && !(keeps_mesh && arguments.in_place)) {
      status = CheckWritable(
          output.path, {&arguments.mesh.text, 1},
          keeps_mesh && IsPlyFile(arguments.mesh)
              ? "write to another file, or --in-place to add to this one"
              : "write to another file");
    }
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

double LengthOf(const Curve& curve, const MeshArrays& mesh) {
  double length = 0;
  for (size_t i = 1; i < curve.points.size(); ++i) {
    const Point a = PositionOf(curve.points[i - 1], mesh);
    const Point b = PositionOf(curve.points[i], mesh);
    length += std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  }
  return length;
}

// Measures the curves, for which it reads the mesh. Where only the shared tier
// has that, from which the question fetches it, they have no length.
absl::Status MeasureCurves(const Session& session, Question* question) {
  std::optional<MeshArrays> mesh;
  for (size_t i = 0; i < question->sources.size(); ++i) {
    const auto* curve = std::get_if<Curve>(&question->sources[i].place);
    if (curve == nullptr) continue;
    if (!mesh.has_value()) {
      absl::StatusOr<MeshArrays> read =
          session.client.ReadMesh(question->mesh_digest, session.call);
      if (absl::IsNotFound(read.status())) return absl::OkStatus();
      if (!read.ok()) return read.status();
      mesh = *std::move(read);
    }
    question->curve_lengths[i] = LengthOf(*curve, *mesh);
  }
  return absl::OkStatus();
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

}  // namespace

absl::Status AskQuestion(
    const Session& session, const QuestionArguments& arguments,
    const std::function<absl::Status(const Question&)>& answer) {
  absl::StatusOr<WrittenPlaces> places = Prepare(arguments);
  if (!places.ok()) return places.status();
  return AskAboutMesh(session, arguments.mesh, [&](const std::string& digest) {
    absl::StatusOr<Question> question = FindPlaces(session, *places, digest);
    if (!question.ok()) return question.status();
    if (absl::Status status = MeasureCurves(session, &*question);
        !status.ok()) {
      return status;
    }
    absl::StatusOr<std::vector<std::string>> notes =
        NotesOnSources(session, digest, question->sources);
    if (!notes.ok()) return notes.status();
    question->notes = *std::move(notes);
    return answer(*question);
  });
}

}  // namespace geodesic::client
