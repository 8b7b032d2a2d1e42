#include "client/cli/commands/question.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "client/cli/commands/mesh_argument.h"
#include "client/output/place_text.h"

namespace geodesic::client {
namespace {

// Appends what the files list to `items`, which then must hold something.
template <typename Item, typename Read>
absl::Status AppendLists(const std::vector<std::string>& files, Read read,
                         std::vector<Item>* items) {
  for (const std::string& file : files) {
    absl::StatusOr<std::vector<Item>> list = read(file);
    if (!list.ok()) return FileError(list.status());
    items->insert(items->end(), list->begin(), list->end());
  }
  if (!items->empty() || files.empty()) return absl::OkStatus();
  return FileError(absl::InvalidArgumentError(
      absl::StrCat(files[0], " lists nothing: write one place a line")));
}

// All but the mesh.
absl::StatusOr<Question> Prepare(const QuestionArguments& arguments) {
  for (const OutputArgument& output : arguments.outputs) {
    absl::Status status = CheckWritable(output.path);
    if (!status.ok()) return FileError(status);
  }
  const SourceArguments& sources = arguments.sources;
  const TargetArguments& targets = arguments.targets;
  Question question = {.sources = sources.points, .targets = targets.points};
  question.sources.insert(question.sources.end(), sources.curves.begin(),
                          sources.curves.end());
  absl::Status status =
      AppendLists(sources.files, ReadSources, &question.sources);
  status.Update(AppendLists(targets.files, ReadPoints, &question.targets));
  if (!status.ok()) return status;
  return question;
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

}  // namespace

absl::Status AskQuestion(
    const Session& session, const QuestionArguments& arguments,
    const std::function<absl::Status(const Question&)>& answer) {
  absl::StatusOr<Question> question = Prepare(arguments);
  if (!question.ok()) return question.status();
  return AskAboutMesh(session, arguments.mesh, [&](const std::string& digest) {
    question->mesh_digest = digest;
    return answer(*question);
  });
}

SolveProgressCallback Stopwatch::OnSolve() {
  return [this](const SolveProgress& progress) {
    const bool waits =
        progress.vertices_reached == 0 && progress.windows_propagated == 0;
    const double fraction =
        progress.vertex_count == 0
            ? 0
            : static_cast<double>(progress.vertices_reached) /
                  static_cast<double>(progress.vertex_count);
    display_.Update(
        Clock::now(), waits ? "waiting" : "solving", fraction,
        waits ? "for a free thread"
              : absl::StrCat(
                    "exact up to ", ShortNumber(progress.settled_radius), ", ",
                    GroupedNumber(progress.windows_propagated), " windows"));
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

absl::StatusOr<const MeshArrays*> MeshOnDemand::Get(uint64_t vertex_count) {
  if (!mesh_.has_value()) {
    absl::StatusOr<MeshArrays> read =
        session_.client.ReadMesh(digest_, session_.call);
    if (!read.ok()) return read.status();
    mesh_ = *std::move(read);
  }
  if (mesh_->positions.size() != vertex_count) {
    return absl::DataLossError(
        absl::StrCat("the server sent a mesh of ", mesh_->positions.size(),
                     " vertices and an answer for ", vertex_count));
  }
  return &*mesh_;
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

absl::StatusOr<std::vector<WrittenFile>> WriteOutputs(
    const Session& session, const std::vector<OutputArgument>& outputs,
    const std::function<absl::StatusOr<uint64_t>(const OutputArgument&)>&
        write) {
  std::vector<WrittenFile> written;
  for (const OutputArgument& output : outputs) {
    if (session.call.stop.stop_requested()) {
      return absl::CancelledError("stopped before all files were written");
    }
    absl::StatusOr<uint64_t> bytes = write(output);
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
    *session.json = {{"mesh", info.mesh_digest},
                     {"algorithm", info.algorithm},
                     {"sources", SourcesJson(question.sources)},
                     {"relative_tolerance", info.relative_tolerance},
                     {"windows_propagated", info.windows_propagated},
                     {"compute_seconds", info.compute_seconds},
                     {"call_seconds", call_seconds},
                     {"server_version", info.server_version}};
    session.json->update(report.json);
    (*session.json)["outputs"] = FilesJson(*files);
    return absl::OkStatus();
  }
  if (session.quiet && !files->empty()) return absl::OkStatus();
  if (!report.header.empty()) {
    PrintTable(report.header, report.rows, &session.out);
    if (!session.quiet) session.out << '\n';
  }
  if (session.quiet) {
    PrintFacts(report.facts, &session.out);
    return absl::OkStatus();
  }
  std::vector<Fact> facts = {{"mesh", info.mesh_digest},
                             {"algorithm", info.algorithm}};
  facts.insert(facts.end(), report.facts.begin(), report.facts.end());
  // Rows of a matrix are computed side by side.
  facts.push_back({"solver", absl::StrCat(Seconds(info.compute_seconds),
                                          info.compute_seconds > call_seconds
                                              ? " over all threads"
                                              : "")});
  facts.push_back({"this call", Seconds(call_seconds)});
  for (const WrittenFile& file : *files) {
    facts.push_back({"wrote", absl::StrCat(file.output.path, " (",
                                           ByteCount(file.bytes), ")")});
  }
  PrintFacts(facts, &session.out);
  return absl::OkStatus();
}

absl::Status OutputFailed() {
  return absl::AbortedError("the output cannot be written");
}

}  // namespace geodesic::client
