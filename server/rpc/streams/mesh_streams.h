// ReadMesh and CreateMesh.

#ifndef GEODESIC_SERVER_RPC_STREAMS_MESH_STREAMS_H_
#define GEODESIC_SERVER_RPC_STREAMS_MESH_STREAMS_H_

#include <grpcpp/server_context.h>

#include <cstdint>
#include <memory>
#include <optional>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/v1/mesh_service.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/calls/call.h"
#include "server/rpc/calls/one_request_call.h"

namespace geodesic::server {

// One ReadMesh call: header, vertices, faces, joined vertices.
class MeshStream final
    : public OneRequestCall<v1::ReadMeshRequest, v1::ReadMeshResponse> {
 public:
  using OneRequestCall::OneRequestCall;

 private:
  absl::Status Ask() override;
  absl::StatusOr<NextMessage> Fill(v1::ReadMeshResponse& message) override;

  MeshHandle mesh_;

  // Guarded by the stream's lock:
  bool has_header_ = false;
  uint64_t next_vertex_ = 0;
  uint64_t next_face_ = 0;
  uint64_t next_joined_ = 0;
};

// One CreateMesh call: a header, chunks, then a job that builds the mesh. The
// next chunk is read only when the last one has been taken, so flow control
// holds a fast sender back.
class UploadStream final : public Call<v1::CreateMeshResponse> {
 public:
  using Request = v1::CreateMeshRequest;

  // REQUIRES: as Call.
  UploadStream(const ServiceContext& service,
               grpc::CallbackServerContext& context)
      : Call(service, "CreateMesh", context) {}

  void OnCancel() override;

 private:
  void OnReceived(bool ok) override;
  // Called when the client has sent everything.
  void Complete();
  void OnBuilt(const absl::StatusOr<UploadResult>& result);

  // Takes the message that was read. Errors: as Intake::Decode, MeshUpload.
  // REQUIRES: mutex_ held.
  absl::Status TakeMessage();

  // Guarded by mutex_:
  std::unique_ptr<MeshUpload> upload_;  // from the header to the end
  UploadJobs::Ticket job_;              // from then on
  v1::CreateMeshResponse response_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_MESH_STREAMS_H_
