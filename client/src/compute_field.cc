// Client::ComputeField: one server stream, received into its final buffer.

#include <grpcpp/completion_queue.h>

#include <string>
#include <utility>

#include "call.h"
#include "connection.h"
#include "field_assembler.h"
#include "rpc_status.h"
#include "translate.h"

namespace geodesic::client {
namespace {

constexpr char kMethod[] = "/geodesic.v1.FieldService/ComputeField";

// A stream on a completion queue of its own, one operation at a time: the
// calling thread does the reading itself and nobody has to wake it.
class FieldStream {
 public:
  FieldStream(FieldStub* stub, grpc::ClientContext* context)
      : stream_(stub->PrepareCall(context, kMethod, &queue_)) {}

  ~FieldStream() {
    queue_.Shutdown();
    void* tag = nullptr;
    bool ok = false;
    while (queue_.Next(&tag, &ok)) {
    }
  }

  bool Send(const v1::ComputeFieldRequest& request) {
    stream_->StartCall(this);
    if (!Await()) return false;
    stream_->WriteLast(request, grpc::WriteOptions(), this);
    return Await();
  }

  bool Read(grpc::ByteBuffer* message) {
    stream_->Read(message, this);
    return Await();
  }

  grpc::Status Finish() {
    grpc::Status status;
    stream_->Finish(&status, this);
    Await();
    return status;
  }

 private:
  // Whether the operation that has been started went well.
  bool Await() {
    void* tag = nullptr;
    bool ok = false;
    return queue_.Next(&tag, &ok) && ok;
  }

  grpc::CompletionQueue queue_;
  std::unique_ptr<
      grpc::ClientAsyncReaderWriter<v1::ComputeFieldRequest, grpc::ByteBuffer>>
      stream_;
};

}  // namespace

absl::StatusOr<Field> Client::ComputeField(
    const FieldQuery& query, const CallOptions& options,
    const FieldProgressCallback& progress) {
  v1::ComputeFieldRequest request;
  request.set_mesh_digest(query.mesh_digest);
  for (const Source& source : query.sources) {
    v1::Source* added = request.add_sources();
    added->set_vertex(source.vertex);
    added->set_offset(source.offset);
  }
  absl::StatusOr<v1::Algorithm> algorithm = AlgorithmFromName(query.algorithm);
  if (!algorithm.ok()) return algorithm.status();
  request.set_algorithm(*algorithm);

  Call call(options);
  FieldStream stream(&connection_->fields, call.context());
  FieldAssembler assembler(progress);
  absl::Status broken;
  if (stream.Send(request)) {
    grpc::ByteBuffer message;
    while (broken.ok() && stream.Read(&message)) {
      broken = assembler.Consume(&message);
    }
    if (!broken.ok()) call.context()->TryCancel();
  }
  const absl::Status status = FromRpcStatus(stream.Finish());
  if (!broken.ok()) return broken;
  if (!status.ok()) return status;
  return std::move(assembler).Finish();
}

}  // namespace geodesic::client
