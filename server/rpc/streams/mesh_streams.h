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
  absl::StatusOr<NextMessage> Fill(v1::ReadMeshResponse& message) override
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);

  MeshHandle mesh_;

  bool has_header_ ABSL_GUARDED_BY(mutex_) = false;
  uint64_t next_vertex_ ABSL_GUARDED_BY(mutex_) = 0;
  uint64_t next_face_ ABSL_GUARDED_BY(mutex_) = 0;
  uint64_t next_joined_ ABSL_GUARDED_BY(mutex_) = 0;
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
  absl::Status TakeMessage() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_);

  // From the header to the end.
  std::unique_ptr<MeshUpload> upload_ ABSL_GUARDED_BY(mutex_);
  UploadJobs::Ticket job_ ABSL_GUARDED_BY(mutex_);  // from then on
  v1::CreateMeshResponse response_ ABSL_GUARDED_BY(mutex_);
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_MESH_STREAMS_H_
