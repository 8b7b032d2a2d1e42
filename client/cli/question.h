// What the commands that ask a question have in common.

#ifndef GEODESIC_CLIENT_CLI_QUESTION_H_
#define GEODESIC_CLIENT_CLI_QUESTION_H_

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "client/cli/progress_display.h"
#include "client/cli/session.h"
#include "client/cli/text.h"
#include "client/output/atomic_file.h"
#include "geodesic_client/answer.h"

namespace geodesic::client {

// A question about a mesh, before it is sent.
struct Question {
  std::string mesh_digest;
  // Numbered as the server will number them.
  std::vector<Source> sources;
  std::vector<SurfacePoint> targets;
};

// Reads the lists of --sources and --targets, sees whether the outputs can be
// written, and makes the mesh resident.
absl::StatusOr<Question> Prepare(const Session& session);

// Shows how far a computation has come, and measures how long it takes.
class Stopwatch {
 public:
  explicit Stopwatch(const Session& session)
      : start_(Clock::now()),
        display_(session.progress_style, session.terminal_width, start_,
                 &session.err) {}

  // Valid as long as this is.
  SolveProgressCallback OnSolve();
  // `what` is counted, in the plural.
  std::function<void(uint64_t, uint64_t)> OnCount(const std::string& what);

  double seconds() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point start_;
  ProgressDisplay display_;
};

// The mesh itself, for outputs that hold or show it; fetched at most once.
class MeshOnDemand {
 public:
  MeshOnDemand(const Session& session, const std::string& digest)
      : session_(session), digest_(digest) {}

  // Errors: those of the server; DATA_LOSS if it has not `vertex_count`
  // vertices.
  absl::StatusOr<const MeshArrays*> Get(uint64_t vertex_count);

 private:
  const Session& session_;
  const std::string digest_;
  std::optional<MeshArrays> mesh_;
};

struct WrittenFile {
  OutputArgument output;
  uint64_t bytes = 0;
};

// Writes the whole file or nothing; its size.
absl::StatusOr<uint64_t> WriteFile(
    const std::string& path,
    const std::function<absl::Status(AtomicFile*)>& write);

// Calls `write` for every output of the command line.
absl::StatusOr<std::vector<WrittenFile>> WriteOutputs(
    const Session& session,
    const std::function<absl::StatusOr<uint64_t>(const OutputArgument&)>&
        write);

// {"path": ..., "format": ..., "bytes": ...} of each.
Json ToJson(const std::vector<WrittenFile>& files);
Json ToJson(const std::vector<Source>& sources);

// What all answers but a field's begin with: mesh, algorithm, sources.
Json AnswerJson(const Question& question, const AnswerInfo& info,
                double call_seconds);
// Adds what all answers end with: times and files.
void AddClosingFacts(const AnswerInfo& info, double call_seconds,
                     const std::vector<WrittenFile>& files,
                     std::vector<Fact>* facts);
void AddFileFacts(const std::vector<WrittenFile>& files,
                  std::vector<Fact>* facts);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_QUESTION_H_
