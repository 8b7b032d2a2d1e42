// One ReadMesh call: header, vertices, faces.

#ifndef GEODESIC_SERVER_RPC_STREAMS_MESH_STREAM_H_
#define GEODESIC_SERVER_RPC_STREAMS_MESH_STREAM_H_

#include <cstdint>

#include "geodesic/v1/mesh_service.pb.h"
#include "server/rpc/calls/answer_stream.h"

namespace geodesic::server {

class MeshStream final
    : public AnswerStream<v1::ReadMeshRequest, v1::ReadMeshResponse> {
 public:
  using AnswerStream::AnswerStream;

 private:
  absl::Status Ask() override;
  void Cancel() override {}  // nothing is computed
  absl::StatusOr<NextMessage> Fill(v1::ReadMeshResponse& message) override;

  MeshHandle mesh_;

  // Guarded by the stream's lock:
  bool has_header_ = false;
  uint64_t next_vertex_ = 0;
  uint64_t next_face_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_MESH_STREAM_H_
