#include "server/web/connection_watch.h"

#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <stop_token>
#include <utility>
#include <vector>

namespace geodesic::server {
namespace {

// How often connections that are late are looked for.
constexpr int kTickMilliseconds = 1000;

// What a browser has sent before it went is looked at for so long.
constexpr std::chrono::seconds kAfterGone{5};

// The number under which epoll knows wake_.
constexpr uint64_t kWake = 0;

}  // namespace

ConnectionWatch::ConnectionWatch(std::chrono::seconds patience)
    : patience_(patience),
      epoll_(epoll_create1(EPOLL_CLOEXEC)),
      wake_(eventfd(0, EFD_CLOEXEC)) {
  epoll_event event = {.events = EPOLLIN, .data = {.u64 = kWake}};
  epoll_ctl(epoll_, EPOLL_CTL_ADD, wake_, &event);
  thread_ = std::jthread([this](const std::stop_token& stop) { Run(stop); });
}

ConnectionWatch::~ConnectionWatch() {
  thread_.request_stop();
  eventfd_write(wake_, 1);
  thread_.join();
  close(wake_);
  close(epoll_);
}

uint64_t ConnectionWatch::Open(int socket) {
  MutexLock lock(mutex_);
  const uint64_t number = next_++;
  connections_.emplace(number, Connection{.socket = socket,
                                          .until = Clock::now() + patience_,
                                          .call = {}});
  // Each connection goes once.
  epoll_event event = {.events = EPOLLRDHUP | EPOLLONESHOT,
                       .data = {.u64 = number}};
  epoll_ctl(epoll_, EPOLL_CTL_ADD, socket, &event);
  return number;
}

void ConnectionWatch::Close(uint64_t connection) {
  MutexLock lock(mutex_);
  const auto it = connections_.find(connection);
  epoll_ctl(epoll_, EPOLL_CTL_DEL, it->second.socket, nullptr);
  connections_.erase(it);
}

void ConnectionWatch::Expect(uint64_t connection) {
  MutexLock lock(mutex_);
  Connection& expected = connections_.at(connection);
  expected.until =
      Clock::now() +
      (expected.is_gone ? std::min(patience_, kAfterGone) : patience_);
}

void ConnectionWatch::Rest(uint64_t connection) {
  MutexLock lock(mutex_);
  connections_.at(connection).until = Clock::time_point::max();
}

void ConnectionWatch::Attach(uint64_t connection,
                             const std::shared_ptr<WebCall>& call) {
  {
    MutexLock lock(mutex_);
    Connection& attached = connections_.at(connection);
    attached.call = call;
    if (!attached.is_gone && !is_closing_) return;
  }
  call->Leave();
}

void ConnectionWatch::Detach(uint64_t connection) {
  MutexLock lock(mutex_);
  connections_.at(connection).call.reset();
}

void ConnectionWatch::LeaveAll() {
  std::vector<std::shared_ptr<WebCall>> calls;
  {
    MutexLock lock(mutex_);
    is_closing_ = true;
    for (const auto& [number, connection] : connections_) {
      if (auto call = connection.call.lock()) calls.push_back(std::move(call));
    }
  }
  for (const auto& call : calls) call->Leave();
}

void ConnectionWatch::Run(const std::stop_token& stop) {
  std::array<epoll_event, 64> events = {};
  while (!stop.stop_requested()) {
    const int count =
        epoll_wait(epoll_, events.data(), static_cast<int>(events.size()),
                   kTickMilliseconds);
    for (int i = 0; i < count; ++i) Gone(events[i].data.u64);
    ShutLate();
  }
}

void ConnectionWatch::ShutLate() {
  MutexLock lock(mutex_);
  const Clock::time_point now = Clock::now();
  for (auto& [number, connection] : connections_) {
    if (connection.until > now) continue;
    shutdown(connection.socket, SHUT_RDWR);
    connection.until = Clock::time_point::max();
  }
}

void ConnectionWatch::Gone(uint64_t connection) {
  std::shared_ptr<WebCall> call;
  {
    MutexLock lock(mutex_);
    const auto it = connections_.find(connection);
    if (it == connections_.end()) return;
    Connection& gone = it->second;
    gone.is_gone = true;
    // If more was expected, it cannot come.
    if (gone.until != Clock::time_point::max()) {
      gone.until = std::min(gone.until, Clock::now() + kAfterGone);
    }
    call = gone.call.lock();
  }
  if (call != nullptr) call->Leave();
}

}  // namespace geodesic::server
