// Helpers of the commands that ask a question.

#ifndef GEODESIC_CLIENT_CLI_COMMANDS_QUESTION_H_
#define GEODESIC_CLIENT_CLI_COMMANDS_QUESTION_H_

#include <chrono>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "client/cli/arguments/options.h"
#include "client/cli/commands/command.h"
#include "client/cli/terminal/exit_code.h"
#include "client/cli/terminal/progress_display.h"
#include "client/cli/terminal/text.h"
#include "client/output/atomic_file.h"
#include "client/output/binary_numbers.h"
#include "client/output/field_writers.h"
#include "geodesic_client/answer.h"

namespace geodesic::client {

// Prepares the mesh for an approximate algorithm, with progress. Does nothing
// for an exact one. Errors: those of Client::Prepare.
absl::Status PrepareMesh(const Session& session, const std::string& mesh_digest,
                         const std::string& algorithm,
                         const Approximation& approximation);

// A question about a mesh, before it is sent.
struct Question {
  std::string mesh_digest;
  // In the order in which the server numbers them.
  std::vector<Source> sources;
  std::vector<SurfacePoint> targets;
};

// Reads the lists of --sources and --targets, checks that the outputs can be
// written, makes the mesh resident, finds the places on it that are written by
// what they are near to, prepares it for an approximate algorithm, and calls
// `answer`. If the server has evicted the mesh meanwhile, it uploads the mesh and
// asks once more.
// Errors: FileErrors, those of AskAboutMesh, PlaceFinder and `answer`.
absl::Status AskQuestion(
    const Session& session, const QuestionArguments& arguments,
    const std::function<absl::Status(const Question&)>& answer);

// A command that answers a question; its `Arguments` are QuestionArguments.
template <typename Arguments>
Command MakeQuestion(std::string name, std::string help, std::string examples,
                     void (*add_options)(CLI::App*, Arguments*),
                     absl::Status (*answer)(const Arguments&, const Session&,
                                            const Question&)) {
  return MakeCommand<Arguments>(
      std::move(name), std::move(help), std::move(examples), add_options,
      [answer](const Arguments& arguments, const Session& session) {
        return AskQuestion(session, arguments, [&](const Question& question) {
          return answer(arguments, session, question);
        });
      });
}

// The types of numbers on the wire and in binary files.
inline ValueType ValueTypeOf(bool float32) {
  return float32 ? ValueType::kFloat32 : ValueType::kFloat64;
}
inline NumberType NumberTypeOf(bool float32) {
  return float32 ? NumberType::kFloat32 : NumberType::kFloat64;
}

// A query with the members that several kinds of query have.
template <typename Query>
Query MakeQuery(const QuestionArguments& arguments, const Question& question) {
  Query query;
  query.mesh_digest = question.mesh_digest;
  query.algorithm = arguments.algorithm;
  if constexpr (requires { query.approximation; }) {
    query.approximation = arguments.approximation;
  }
  if constexpr (requires { query.tolerance; }) {
    query.tolerance = arguments.tolerance;
  }
  query.priority = arguments.priority;
  if constexpr (requires { query.sources; }) query.sources = question.sources;
  if constexpr (requires { query.targets; }) query.targets = question.targets;
  if constexpr (requires { query.radius; }) query.radius = arguments.radius;
  if constexpr (requires { query.value_type; }) {
    query.value_type = ValueTypeOf(arguments.float32);
  }
  return query;
}

// Shows the progress of a computation, and measures how long it takes.
class Stopwatch {
 public:
  explicit Stopwatch(const Session& session)
      : start_(Clock::now()),
        display_(session.progress_style, session.terminal_width, start_,
                 &session.err) {}

  // The callbacks must not outlive the Stopwatch. `is_exact`: not within a
  // tolerance.
  SolveProgressCallback OnSolve(bool is_exact = true);
  // The same for what is done before a question: `what`, e.g. "preparing".
  SolveProgressCallback OnPrepare(const std::string& what);
  // `what` names the counted things, in the plural.
  std::function<void(uint64_t, uint64_t)> OnCount(const std::string& what);

  double seconds() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point start_;
  ProgressDisplay display_;
};

// The mesh that was asked about, for outputs that hold or show it.
// Errors: those of Client::ReadMesh; DATA_LOSS if its vertex count is not the
// answer's.
absl::StatusOr<MeshArrays> FetchMesh(const Session& session,
                                     const AnswerInfo& info);

struct WrittenFile {
  OutputArgument output;
  uint64_t bytes = 0;
};

// Writes the whole file or nothing. Returns its size in bytes.
absl::StatusOr<uint64_t> WriteFile(
    const std::string& path, const std::function<void(AtomicFile*)>& write);

// Writes values at the vertices of the mesh that was asked about to `path` as
// .ply, and returns the size in bytes. Where MESH is itself such a file, all
// that it holds stays (extended_ply.h). If it cannot, for the file has changed
// meanwhile perhaps, `mesh` is written, and standard error says so; to write it
// over that file is an error.
absl::StatusOr<uint64_t> WriteAnswerAsPly(const Session& session,
                                          const MeshArgument& argument,
                                          const AnswerInfo& info,
                                          const MeshArrays& mesh,
                                          std::span<const Column> columns,
                                          const std::string& mark,
                                          const std::string& path);

// Draws the picture and writes it. Returns its size in bytes.
absl::StatusOr<uint64_t> WritePicture(const std::string& path,
                                      const MeshArrays& mesh,
                                      const PictureContent& content,
                                      const PictureOptions& options);

// Shows the sources in a picture: points as dots, curves as bold lines. Places
// that the mesh does not have may appear anywhere.
void ShowSources(const std::vector<Source>& sources, const MeshArrays& mesh,
                 PictureContent* content);

// Shows the targets in a picture as dots.
void ShowTargets(const std::vector<SurfacePoint>& targets,
                 const MeshArrays& mesh, PictureContent* content);

// Calls `write` for every output, with the mesh of the answer if the format is
// among `with_mesh`, otherwise with an empty mesh.
absl::StatusOr<std::vector<WrittenFile>> WriteOutputs(
    const Session& session, const std::vector<OutputArgument>& outputs,
    const AnswerInfo& info, std::initializer_list<OutputFormat> with_mesh,
    const std::function<absl::StatusOr<uint64_t>(
        const OutputArgument&, const MeshArrays& mesh)>& write);

// What a command prints about an answer.
struct Report {
  // A table; no header means no table.
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::vector<Fact> facts;
  // Members for the object that --json prints.
  Json json = Json::object();
};

// Prints the table, the facts of `report` and those of all answers, or one JSON
// object. With --quiet it prints only the table and the report's own facts, and
// nothing if the answer went to files. It prints nothing if the files could not
// be written, and to standard error if one of them is standard output.
// Errors: that of `files`.
absl::Status PrintReport(const Session& session, const Question& question,
                         const AnswerInfo& info, double call_seconds,
                         const absl::StatusOr<std::vector<WrittenFile>>& files,
                         const Report& report);

// The parameters that are set, by the names of their options.
Json ParametersJson(const Approximation& approximation);

// The status of a command whose output cannot be written.
absl::Status OutputFailed();

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_COMMANDS_QUESTION_H_
