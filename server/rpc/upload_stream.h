// One CreateMesh call: a header, chunks, then a job that builds the mesh.

#ifndef GEODESIC_SERVER_RPC_UPLOAD_STREAM_H_
#define GEODESIC_SERVER_RPC_UPLOAD_STREAM_H_

#include <grpcpp/server_context.h>
#include <grpcpp/support/server_callback.h>

#include <memory>
#include <mutex>
#include <optional>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/v1/mesh_service.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/request_log.h"

namespace geodesic::server {

// The next chunk is read only when the one before has been taken, so a fast
// sender is held back by flow control. Locks and lifetime: as FieldStream.
class UploadStream final
    : public grpc::ServerReadReactor<v1::CreateMeshRequest>,
      public std::enable_shared_from_this<UploadStream> {
 public:
  // REQUIRES: `engine` and `log` outlive the call.
  static grpc::ServerReadReactor<v1::CreateMeshRequest>* Start(
      QueryEngine& engine, RequestLog& log,
      grpc::CallbackServerContext& context, v1::CreateMeshResponse& response);

  void OnReadDone(bool ok) override;
  void OnCancel() override;
  void OnDone() override;

 private:
  UploadStream(QueryEngine& engine, RequestLog& log,
               grpc::CallbackServerContext& context,
               v1::CreateMeshResponse& response);

  void Begin();
  // The client has sent everything.
  void Complete();
  void OnBuilt(const absl::StatusOr<UploadResult>& result);

  // The rest REQUIRES: mutex_ held.
  absl::Status TakeMessage();
  void End(absl::Status status);

  QueryEngine& engine_;
  const grpc::CallbackServerContext& context_;
  v1::CreateMeshResponse& response_;  // lives until OnDone

  std::mutex mutex_;
  // Guarded by mutex_:
  std::shared_ptr<UploadStream> self_;  // what gRPC holds
  std::optional<RequestLog::Entry> entry_;
  std::unique_ptr<MeshUpload> upload_;   // from the header to the end
  std::optional<Scheduler::JobId> job_;  // from then on
  bool finished_ = false;                // Finish was called
  v1::CreateMeshRequest message_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_UPLOAD_STREAM_H_
