// Where the calls of the door wait for gRPC.
//
// Not gRPC's callback API: it asks for a call's status at its start, and an
// in-process channel (gRPC 1.51) takes that as a sign that no more messages are
// wanted, and drops the last one if nobody reads at that moment. Here a call
// asks for its status when it has read everything.

#ifndef GEODESIC_SERVER_WEB_CALL_QUEUE_H_
#define GEODESIC_SERVER_WEB_CALL_QUEUE_H_

#include <grpcpp/channel.h>
#include <grpcpp/client_context.h>
#include <grpcpp/completion_queue.h>
#include <grpcpp/generic/generic_stub.h>

#include <condition_variable>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "server/locks/mutex.h"

namespace geodesic::server {

// Thread-safe.
class CallQueue {
 public:
  // Tags an operation: it is called with the result, by the queue's thread, and
  // must be short.
  using Event = std::function<void(bool ok)>;

  explicit CallQueue(std::shared_ptr<grpc::Channel> channel);
  // Waits until every call has left.
  ~CallQueue();
  CallQueue(const CallQueue&) = delete;
  CallQueue& operator=(const CallQueue&) = delete;

  // A call that is not started yet; its operations are tagged with pointers to
  // Events. It must be destroyed before Leave.
  std::unique_ptr<grpc::GenericClientAsyncReaderWriter> Enter(
      grpc::ClientContext& context, const std::string& method);
  void Leave();

 private:
  void Run();

  grpc::GenericStub stub_;
  grpc::CompletionQueue queue_;

  Mutex mutex_;
  std::condition_variable_any left_;
  int calls_ ABSL_GUARDED_BY(mutex_) = 0;

  std::jthread thread_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_WEB_CALL_QUEUE_H_
