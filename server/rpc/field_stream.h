// One ComputeField call: accepted, progress, chunks, trailer.

#ifndef GEODESIC_SERVER_RPC_FIELD_STREAM_H_
#define GEODESIC_SERVER_RPC_FIELD_STREAM_H_

#include <grpcpp/server_context.h>
#include <grpcpp/support/server_callback.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/v1/field_service.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/request_log.h"

namespace geodesic::server {

// At any time at most one message is on its way to the client; the next is made
// when gRPC has taken that one. So a slow reader costs one message and the pin
// on its field, and progress that nobody took is overwritten by newer.
//
// Reactions and the engine's calls come from different threads, so everything
// happens under one lock. Two parties hold the object, gRPC until OnDone and
// the engine as long as it may call; the last to let go destroys it.
class FieldStream final
    : public grpc::ServerWriteReactor<v1::ComputeFieldResponse>,
      public FieldObserver,
      public std::enable_shared_from_this<FieldStream> {
 public:
  // Starts the call; the reactor keeps itself alive until gRPC is done with it.
  // REQUIRES: `engine`, `log` and `version` outlive the call.
  static grpc::ServerWriteReactor<v1::ComputeFieldResponse>* Start(
      QueryEngine& engine, RequestLog& log, const std::string& version,
      const grpc::CallbackServerContext& context,
      const v1::ComputeFieldRequest& request);

  void OnWriteDone(bool ok) override;
  void OnCancel() override;
  void OnDone() override;

  void OnProgress(const Progress& progress) override;
  void OnField(const absl::StatusOr<FieldHandle>& field) override;

 private:
  FieldStream(QueryEngine& engine, RequestLog& log, const std::string& version);

  absl::StatusOr<FieldCall> Ask(const RequestLog& log,
                                const grpc::CallbackServerContext& context,
                                const v1::ComputeFieldRequest& request);
  void Begin(const RequestLog& log, const grpc::CallbackServerContext& context,
             const v1::ComputeFieldRequest& request);

  // The rest REQUIRES: mutex_ held.

  // Sends what is next, if anything is and gRPC is free to take it.
  void Advance();
  void WriteChunk();
  void WriteTrailer();
  void Write();
  void End(absl::Status status);

  QueryEngine& engine_;
  const std::string& version_;

  std::mutex mutex_;
  // Guarded by mutex_:
  std::shared_ptr<FieldStream> self_;  // what gRPC holds
  std::optional<RequestLog::Entry> entry_;
  FieldCall call_;
  bool begun_ = false;                // `accepted` is, or has been, on its way
  bool writing_ = false;              // a message is on its way
  bool finished_ = false;             // Finish was called
  std::optional<Progress> progress_;  // newer than what was sent
  std::optional<absl::StatusOr<FieldHandle>> field_;
  uint64_t offset_ = 0;  // of the next chunk
  v1::ComputeFieldResponse message_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_FIELD_STREAM_H_
