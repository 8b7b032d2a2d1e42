#include "server/web/call_queue.h"

#include <utility>

namespace geodesic::server {

CallQueue::CallQueue(std::shared_ptr<grpc::Channel> channel)
    : stub_(std::move(channel)), thread_([this] { Run(); }) {}

CallQueue::~CallQueue() {
  {
    MutexLock lock(mutex_);
    while (calls_ > 0) left_.wait(lock);
  }
  queue_.Shutdown();
}

std::unique_ptr<grpc::GenericClientAsyncReaderWriter> CallQueue::Enter(
    grpc::ClientContext& context, const std::string& method) {
  {
    MutexLock lock(mutex_);
    ++calls_;
  }
  return stub_.PrepareCall(&context, method, &queue_);
}

void CallQueue::Leave() {
  MutexLock lock(mutex_);
  --calls_;
  // Under the lock: a waiter may destroy the queue as soon as it wakes.
  left_.notify_all();
}

void CallQueue::Run() {
  void* event = nullptr;
  bool ok = false;
  while (queue_.Next(&event, &ok)) (*static_cast<Event*>(event))(ok);
}

}  // namespace geodesic::server
