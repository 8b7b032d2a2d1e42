// A connection to a geodesic server.
//
//   geodesic::client::Client client("127.0.0.1:50051");
//   auto upload = client.UploadFile("horse.ply");
//   if (!upload.ok()) return upload.status();
//   auto field = client.ComputeField({.mesh_digest = upload->mesh.digest,
//                                     .sources = {{VertexPoint{0}}}});
//   if (!field.ok()) return field.status();
//   double distance_to_vertex_7 = field->distances[7];

#ifndef GEODESIC_CLIENT_CLIENT_H_
#define GEODESIC_CLIENT_CLIENT_H_

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <type_traits>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic_client/answer.h"
#include "geodesic_client/capabilities.h"
#include "geodesic_client/connection_options.h"
#include "geodesic_client/errors.h"
#include "geodesic_client/field.h"
#include "geodesic_client/mesh.h"
#include "geodesic_client/pairs.h"
#include "geodesic_client/questions.h"
#include "geodesic_types/mesh_format.h"

namespace geodesic::client {

// How long a call may take, and a way to end it from another thread.
struct CallOptions {
  // Limit for each RPC of the call. DEFAULT: none.
  std::optional<std::chrono::duration<double>> timeout;
  // A request to stop ends the call with CANCELLED, and the work on the server,
  // too. DEFAULT: a token that never stops anything.
  std::stop_token stop;
};

// Calls block until the server has answered. Callbacks run on the calling
// thread. Thread-safe: calls of several threads share one connection.
//
// The client repeats uploads and calls that change nothing, up to three times,
// if no server is there or if a full server says that waiting helps. If the
// stream of an answer breaks, it reads on from there, or asks again if the
// server no longer has the answer and no callback has received parts of it.
// StreamField is not read on. ConnectionOptions::retry turns all that off.
//
// Errors have the server's code and message, and name the field of the request
// that the server points at; errors.h reads the rest. Besides the errors listed
// with each method, any call may fail with
//   UNAVAILABLE: no server there, or it is shutting down, or TLS failed;
//   UNAUTHENTICATED, PERMISSION_DENIED: the token is missing, is wrong, or does
//     not allow the call;
//   DEADLINE_EXCEEDED, CANCELLED: by CallOptions;
//   DATA_LOSS: the server's answer contradicts itself;
//   INTERNAL: a defect of the server.
class Client {
 public:
  // Connects to "HOST:PORT" at the first call.
  explicit Client(const std::string& server,
                  const ConnectionOptions& options = {});
  ~Client();
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  // Makes a mesh file resident. The file is hashed first and sent only if the
  // server does not know it.
  // Errors: those of CreateMesh in mesh_service.proto; NOT_FOUND or
  // PERMISSION_DENIED if the file cannot be opened; INVALID_ARGUMENT if it is
  // no regular file; DATA_LOSS if it changes while it is read. Messages about
  // the file begin with its path.
  absl::StatusOr<UploadOutcome> UploadFile(
      const std::string& path, MeshFormat format, const Welding& welding = {},
      const CallOptions& options = {},
      const CountProgressCallback& progress = nullptr);

  // The same, with the format that the path's ending names.
  // Errors: also INVALID_ARGUMENT if it names none.
  absl::StatusOr<UploadOutcome> UploadFile(
      const std::string& path, const CallOptions& options = {},
      const CountProgressCallback& progress = nullptr);

  // Makes a mesh in memory resident, as it is. It is sent only if the server
  // lacks it.
  absl::StatusOr<UploadOutcome> UploadArrays(
      const MeshArrays& mesh, const CallOptions& options = {},
      const CountProgressCallback& progress = nullptr);

  // The digest of the resident mesh that was uploaded from a file with these
  // very bytes and this welding; nothing if the server does not know the file.
  // Errors: as UploadFile.
  absl::StatusOr<std::optional<std::string>> FindFile(
      const std::string& path, MeshFormat format, const Welding& welding = {},
      const CallOptions& options = {});

  // Errors: INVALID_ARGUMENT for a malformed digest; NOT_FOUND if the mesh is
  // not resident and must be uploaded again. ReadMesh and DeleteMesh have the
  // same errors.
  absl::StatusOr<MeshInfo> GetMesh(const std::string& digest,
                                   const CallOptions& options = {});

  // The mesh's vertices and faces, as the server holds them.
  absl::StatusOr<MeshArrays> ReadMesh(const std::string& digest,
                                      const CallOptions& options = {});

  // All resident meshes, ordered by digest.
  absl::StatusOr<std::vector<MeshInfo>> ListMeshes(
      const CallOptions& options = {});

  // Drops a mesh and the fields computed on it.
  absl::Status DeleteMesh(const std::string& digest,
                          const CallOptions& options = {});

  // The questions. Each is one server stream. The server keeps what it computes
  // while memory allows. docs/questions.md says what each question costs and
  // guarantees, and the .proto files what may be refused. Errors of all of
  // them:
  //   INVALID_ARGUMENT: an unknown algorithm (naming the known ones), a place
  //     off the mesh, a value out of range;
  //   NOT_FOUND: the mesh is not resident, upload it again;
  //   RESOURCE_EXHAUSTED: a limit of the server is passed, or it is busy and
  //     says when to try again.

  // A distance field, or part of one.
  absl::StatusOr<Field> ComputeField(
      const FieldQuery& query, const CallOptions& options = {},
      const SolveProgressCallback& progress = nullptr);

  // The same, but hands out finished distances while the solver runs. They are
  // final even if the call ends early. `distances` of the result is empty.
  // Errors: INVALID_ARGUMENT also for a query that asks for nearest sources or
  // gradients.
  absl::StatusOr<Field> StreamField(
      const FieldQuery& query, const SettledCallback& on_settled,
      const CallOptions& options = {},
      const SolveProgressCallback& progress = nullptr);

  // Shortest paths from the nearest source to each target.
  absl::StatusOr<PathAnswer> ComputePaths(
      const PathQuery& query, const CallOptions& options = {},
      const SolveProgressCallback& progress = nullptr);

  // Lines of equal distance.
  absl::StatusOr<IsolineAnswer> ComputeIsolines(
      const IsolineQuery& query, const CallOptions& options = {},
      const SolveProgressCallback& progress = nullptr);

  // Errors: also whatever the receiver returns.
  absl::StatusOr<AnswerInfo> ComputeMatrix(const MatrixQuery& query,
                                           const MatrixReceiver& receiver,
                                           const CallOptions& options = {});

  // The targets that are nearest to each source.
  absl::StatusOr<NearestAnswer> FindNearest(
      const NearestQuery& query, const CallOptions& options = {},
      const CountProgressCallback& progress = nullptr);

  // Single distances, of any number of pairs. A list that is longer than the
  // server's max_pairs takes several calls, one after the other; errors name a
  // pair by its number in the query. Errors: also whatever the receiver
  // returns.
  absl::StatusOr<PairSummary> ComputePairs(const PairQuery& query,
                                           const PairReceiver& receiver,
                                           const CallOptions& options = {});

  // The same for distances that fit into memory.
  absl::StatusOr<PairAnswer> ComputePairs(
      const PairQuery& query, const CallOptions& options = {},
      const CountProgressCallback& progress = nullptr);

  // Vertices, each the farthest from the sources and all before it.
  absl::StatusOr<SampleAnswer> SampleFarthestPoints(
      const SampleQuery& query, const CallOptions& options = {},
      const SolveProgressCallback& progress = nullptr);

  // The surface around a point, laid into the plane.
  absl::StatusOr<LogMap> ComputeLogMap(
      const LogMapQuery& query, const CallOptions& options = {},
      const SolveProgressCallback& progress = nullptr);

  // Lines that run straight on from places in directions.
  absl::StatusOr<LineAnswer> TraceLines(
      const LineQuery& query, const CallOptions& options = {},
      const CountProgressCallback& progress = nullptr);

  // What the server can do and where its limits are.
  absl::StatusOr<Capabilities> GetCapabilities(const CallOptions& options = {});

 private:
  struct Connection;
  std::unique_ptr<Connection> connection_;
};

// Uploads the file unless the server has it, and calls `ask` with the mesh's
// digest. A server short of memory may evict the mesh in between. Then this
// uploads it again and calls `ask` once more.
//
//   absl::StatusOr<Field> field =
//       AskAboutFile(client, "horse.ply", [&](const std::string& digest) {
//         return client.ComputeField({.mesh_digest = digest,
//                                     .sources = {{VertexPoint{0}}}});
//       });
//
// `ask` returns an absl::StatusOr, and this returns the last one.
// Errors: those of Client::UploadFile and `ask`.
template <typename Ask>
std::invoke_result_t<Ask, const std::string&> AskAboutFile(
    Client& client, const std::string& path, Ask ask,
    const CallOptions& options = {}) {
  for (bool is_again = false;; is_again = true) {
    absl::StatusOr<UploadOutcome> upload = client.UploadFile(path, options);
    if (!upload.ok()) return upload.status();
    auto answer = ask(upload->mesh.digest);
    if (is_again || ErrorReason(answer.status()) != "MESH_NOT_RESIDENT") {
      return answer;
    }
  }
}

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLIENT_H_
