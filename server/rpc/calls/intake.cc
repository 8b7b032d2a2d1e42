#include "server/rpc/calls/intake.h"

#include <google/protobuf/descriptor.h>
#include <grpcpp/support/proto_buffer_reader.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "server/engine/base/error_reasons.h"
#include "server/engine/base/status_details.h"
#include "server/rpc/calls/decoded_size.h"

namespace geodesic::server {
namespace {

// While the engine is asked there are the request, and up to three copies of
// the question, each smaller than the request; the call keeps one or two of
// them.
constexpr uint64_t kWhileAsking = 3;
constexpr uint64_t kShareAfterwards = 2;  // half of it

constexpr std::chrono::milliseconds kComeAgain{1000};

// A reception that is younger is not broken off: an honest one takes less.
constexpr std::chrono::milliseconds kYoung{250};

// How often room is made while somebody waits.
constexpr std::chrono::milliseconds kInterval{100};

}  // namespace

Intake::Intake(const Options& options)
    : memory_(
          std::make_shared<ByteBudget>("request memory", options.memory_bytes)),
      patience_(options.patience),
      free_slots_(options.slots) {}

void Intake::Enter(std::shared_ptr<Receiver> receiver,
                   const std::string& connection) {
  {
    std::lock_guard lock(mutex_);
    connections_[connection].waiting.push_back(std::move(receiver));
  }
  Serve();
}

void Intake::Leave(const Receiver& receiver) {
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
    ++free_slots_;
  }
  Serve();
}

std::pair<const std::string, Intake::Connection>* Intake::Neediest() {
  std::pair<const std::string, Connection>* neediest = nullptr;
  for (auto& entry : connections_) {
    if (!entry.second.waiting.empty() &&
        (neediest == nullptr || entry.second.held < neediest->second.held)) {
      neediest = &entry;
    }
  }
  return neediest;
}

void Intake::Serve() {
  std::vector<std::shared_ptr<Receiver>> served;
  {
    std::lock_guard lock(mutex_);
    auto* next = Neediest();
    for (; next != nullptr && free_slots_ > 0; next = Neediest()) {
      auto& [name, connection] = *next;
      served.push_back(std::move(connection.waiting.front()));
      connection.waiting.pop_front();
      ++connection.held;
      --free_slots_;
      held_.push_back({served.back(), name, Clock::now()});
    }
    if (next != nullptr && !is_watching_) Watch();
  }
  for (const auto& receiver : served) receiver->OnSlot();
}

void Intake::Watch() {
  is_watching_ = true;
  alarm_.emplace();
  alarm_->Set(std::chrono::system_clock::now() + kInterval,
              [this](bool has_passed) {
                if (has_passed) MakeRoom();
              });
}

void Intake::MakeRoom() {
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

absl::StatusOr<ByteReservation> Intake::Decode(
    grpc::ByteBuffer& bytes, google::protobuf::Message& request) const {
  const google::protobuf::Descriptor& type = *request.GetDescriptor();
  grpc::ProtoBufferReader measured(&bytes);
  absl::StatusOr<ByteReservation> memory = ByteReservation::Make(
      memory_, kWhileAsking * DecodedSize(type, measured));
  if (!memory.ok()) return memory.status();
  grpc::ProtoBufferReader reader(&bytes);
  if (!request.ParseFromZeroCopyStream(&reader)) {
    return absl::InvalidArgumentError(absl::StrCat(
        "the message is not a well-formed ", std::string(type.full_name())));
  }
  return memory;
}

void Intake::ReleaseRequest(ByteReservation& reservation) {
  reservation.ShrinkTo(reservation.bytes() / kShareAfterwards);
}

void Arrival::Start(std::chrono::milliseconds patience,
                    std::function<void()> late) {
  alarm_.emplace();
  alarm_->Set(std::chrono::system_clock::now() + patience,
              [late = std::move(late)](bool has_passed) {
                if (has_passed) late();
              });
}

absl::Status LateError(std::chrono::milliseconds patience) {
  return absl::DeadlineExceededError(
      absl::StrCat("a message of the request did not come as a whole within ",
                   patience.count() / 1000,
                   " s (the server's "
                   "--receive-seconds)"));
}

absl::Status BrokenOffError() {
  return WithReason(
      WithRetryAfter(
          absl::ResourceExhaustedError(
              "messages that are still coming in fill the server's "
              "--receive-memory, and this one came slowly; try again later"),
          kComeAgain),
      reason::kMemoryFull);
}

}  // namespace geodesic::server
