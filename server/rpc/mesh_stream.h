// One ReadMesh call: header, vertices, faces.

#ifndef GEODESIC_SERVER_RPC_MESH_STREAM_H_
#define GEODESIC_SERVER_RPC_MESH_STREAM_H_

#include <grpcpp/support/server_callback.h>

#include <cstdint>

#include "geodesic/v1/mesh_service.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/request_log.h"

namespace geodesic::server {

// Only gRPC calls it, and of OnWriteDone and OnCancel only the former acts, so
// there is nothing to lock. Deletes itself when done.
class MeshStream final : public grpc::ServerWriteReactor<v1::ReadMeshResponse> {
 public:
  // REQUIRES: `engine` and `log` outlive the call.
  MeshStream(QueryEngine& engine, RequestLog& log,
             const v1::ReadMeshRequest& request);

  void OnWriteDone(bool ok) override;
  void OnDone() override;

 private:
  void WriteVertices();
  void WriteFaces();
  void End(absl::Status status);

  RequestLog::Entry entry_;
  MeshHandle mesh_;
  uint64_t next_vertex_ = 0;
  uint64_t next_face_ = 0;
  v1::ReadMeshResponse message_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_MESH_STREAM_H_
