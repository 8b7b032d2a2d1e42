// One CreateMesh call: a header, chunks, then a job that builds the mesh.

#ifndef GEODESIC_SERVER_RPC_STREAMS_UPLOAD_STREAM_H_
#define GEODESIC_SERVER_RPC_STREAMS_UPLOAD_STREAM_H_

#include <grpcpp/server_context.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/server_callback.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/v1/mesh_service.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/calls/intake.h"
#include "server/rpc/calls/request_log.h"
#include "server/rpc/calls/service_context.h"

namespace geodesic::server {

// The next chunk is read only when the one before has been taken, so a fast
// sender is held back by flow control. Locks and lifetime: as FieldStream.
class UploadStream final
    : public grpc::ServerBidiReactor<grpc::ByteBuffer, v1::CreateMeshResponse>,
      public Receiver,
      public std::enable_shared_from_this<UploadStream> {
 public:
  using Request = v1::CreateMeshRequest;
  using Response = v1::CreateMeshResponse;

  // REQUIRES: `service` outlives the call; `context` lives until gRPC is done
  // with it.
  UploadStream(const ServiceContext& service,
               grpc::CallbackServerContext& context);

  // Begins; `self` is this, kept alive until gRPC is done with it.
  void Launch(std::shared_ptr<UploadStream> self);

  void OnSlot() override;
  void OnBrokenOff() override;
  void OnReadDone(bool ok) override;
  void OnCancel() override;
  void OnDone() override;

 private:
  // The client has sent everything.
  void Complete();
  void OnBuilt(const absl::StatusOr<UploadResult>& result);

  void ReadNext();
  void OnLate(uint64_t message);

  // The rest REQUIRES: mutex_ held.
  // Takes the message that was read. Errors: as Intake::Decode, MeshUpload.
  absl::Status TakeMessage();
  void End(absl::Status status);

  const ServiceContext& service_;
  QueryEngine& engine_;
  grpc::CallbackServerContext& context_;
  const std::string peer_;

  std::mutex mutex_;
  // Guarded by mutex_:
  std::shared_ptr<UploadStream> self_;  // what gRPC holds
  std::optional<RequestLog::Entry> entry_;
  std::unique_ptr<MeshUpload> upload_;     // from the header to the end
  std::optional<UploadJobs::Ticket> job_;  // from then on
  bool finished_ = false;                  // Finish was called
  uint64_t messages_ = 0;                  // that were waited for
  Arrival arrival_;                        // of the latest
  bool is_receiving_ = false;              // a read is under way
  grpc::ByteBuffer bytes_;
  v1::CreateMeshResponse response_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_UPLOAD_STREAM_H_
