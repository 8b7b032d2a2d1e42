#include "server/rpc/calls/receive_slots.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace geodesic::server {
namespace {

// A reception that is younger is not broken off: an honest one takes less.
constexpr std::chrono::milliseconds kYoung{250};

// How often room is made while somebody waits.
constexpr std::chrono::milliseconds kInterval{100};

}  // namespace

void ReceiveSlots::Enter(std::shared_ptr<Receiver> receiver,
                         const std::string& connection) {
  {
    std::lock_guard lock(mutex_);
    connections_[connection].waiting.push_back(std::move(receiver));
  }
  Serve();
}

void ReceiveSlots::Leave(const Receiver& receiver) {
  std::shared_ptr<Receiver> gone;  // destroyed without the lock
  {
    std::lock_guard lock(mutex_);
    const auto it = std::find_if(held_.begin(), held_.end(),
                                 [&](const Reception& reception) {
                                   return reception.receiver.get() == &receiver;
                                 });
    gone = std::move(it->receiver);
    const auto connection = connections_.find(it->connection);
    if (--connection->second.held == 0 && connection->second.waiting.empty()) {
      connections_.erase(connection);
    }
    held_.erase(it);
    ++free_;
  }
  Serve();
}

std::pair<const std::string, ReceiveSlots::Connection>*
ReceiveSlots::Neediest() {
  std::pair<const std::string, Connection>* neediest = nullptr;
  for (auto& entry : connections_) {
    if (!entry.second.waiting.empty() &&
        (neediest == nullptr || entry.second.held < neediest->second.held)) {
      neediest = &entry;
    }
  }
  return neediest;
}

void ReceiveSlots::Serve() {
  std::vector<std::shared_ptr<Receiver>> served;
  {
    std::lock_guard lock(mutex_);
    auto* next = Neediest();
    for (; next != nullptr && free_ > 0; next = Neediest()) {
      auto& [name, connection] = *next;
      served.push_back(std::move(connection.waiting.front()));
      connection.waiting.pop_front();
      ++connection.held;
      --free_;
      held_.push_back({served.back(), name, Clock::now()});
    }
    if (next != nullptr && !is_watching_) Watch();
  }
  for (const auto& receiver : served) receiver->OnSlot();
}

void ReceiveSlots::Watch() {
  is_watching_ = true;
  alarm_.emplace();
  alarm_->Set(std::chrono::system_clock::now() + kInterval,
              [this](bool has_passed) {
                if (has_passed) MakeRoom();
              });
}

void ReceiveSlots::MakeRoom() {
  std::vector<std::shared_ptr<Receiver>> broken_off;
  {
    std::lock_guard lock(mutex_);
    is_watching_ = false;
    const auto* neediest = Neediest();
    if (neediest == nullptr) return;
    size_t waiting = 0;
    std::map<std::string, size_t> left;
    for (const auto& [name, connection] : connections_) {
      left[name] = connection.held;
      if (connection.held == neediest->second.held) {
        waiting += connection.waiting.size();
      }
    }
    const auto ends = Clock::now() - kYoung;
    for (const Reception& reception : held_) {
      if (broken_off.size() == waiting || reception.since > ends) break;
      size_t& held = left[reception.connection];
      if (held <= neediest->second.held) continue;
      --held;
      broken_off.push_back(reception.receiver);
    }
    Watch();
  }
  for (const auto& receiver : broken_off) receiver->OnBrokenOff();
}

}  // namespace geodesic::server
