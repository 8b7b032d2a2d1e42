// One ReadMesh call: header, vertices, faces.

#ifndef GEODESIC_SERVER_RPC_MESH_STREAM_H_
#define GEODESIC_SERVER_RPC_MESH_STREAM_H_

#include <cstdint>
#include <string>

#include "geodesic/v1/mesh_service.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/answer_stream.h"
#include "server/rpc/request_log.h"

namespace geodesic::server {

class MeshStream final : public AnswerStream<v1::ReadMeshResponse> {
 public:
  // REQUIRES: `engine` and `log` outlive the call; `context` lives until gRPC
  // is done with it.
  static grpc::ServerWriteReactor<v1::ReadMeshResponse>* Start(
      QueryEngine& engine, RequestLog& log,
      grpc::CallbackServerContext& context, const v1::ReadMeshRequest& request);

 private:
  MeshStream(QueryEngine& engine, RequestLog& log,
             grpc::CallbackServerContext& context, const std::string& digest)
      : AnswerStream(engine, log, "ReadMesh", digest, context),
        digest_(digest) {}

  absl::Status Ask() override;
  void Cancel() override {}  // nothing is computed
  absl::StatusOr<NextMessage> Fill(v1::ReadMeshResponse& message) override;

  const std::string digest_;
  MeshHandle mesh_;

  // Guarded by the stream's lock:
  bool has_header_ = false;
  uint64_t next_vertex_ = 0;
  uint64_t next_face_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_MESH_STREAM_H_
