#include "server/rpc/calls/intake.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/wire_format_lite.h>
#include <grpcpp/support/proto_buffer_reader.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "server/engine/base/status_details.h"

namespace geodesic::server {
namespace {

// While the engine is asked, there are the request and up to three copies of
// the question, each smaller than the request. The call keeps one or two.
constexpr uint64_t kWhileAsking = 3;
constexpr uint64_t kShareAfterwards = 2;  // half of it

constexpr std::chrono::milliseconds kComeAgain{1000};

// Younger receptions are not broken off: an honest one takes less time.
constexpr std::chrono::milliseconds kYoung{250};

// How often room is made while somebody waits.
constexpr std::chrono::milliseconds kInterval{100};

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::MessageFactory;
using google::protobuf::internal::WireFormatLite;
using google::protobuf::io::CodedInputStream;

// The cost of an allocation and its place in a list beside its own bytes: the
// allocator's header and rounding, and a pointer in a list that may have twice
// the capacity it needs.
constexpr uint64_t kAllocation = 32;
// A scalar in such a list, or a field unknown to the type.
constexpr uint64_t kScalar = 32;
// A string is an object beside its bytes.
constexpr uint64_t kString = kAllocation + 64;
// Packed numbers lie in such a list. Those of fixed length keep their size; a
// varint of one byte takes eight.
constexpr uint64_t kFixedGrowth = 2;
constexpr uint64_t kVarintGrowth = 16;

bool HasFixedLength(const FieldDescriptor& field) {
  return field.cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE ||
         field.cpp_type() == FieldDescriptor::CPPTYPE_FLOAT;
}

class Sizer {
 public:
  explicit Sizer(CodedInputStream& input) : input_(input) {}

  // Adds a message of this type, up to the input's limit. False if malformed.
  bool AddMessage(const Descriptor& type) {
    size_ += SizeOf(type);
    while (const uint32_t tag = input_.ReadTag()) {
      if (!AddField(type, tag)) return false;
    }
    return input_.ConsumedEntireMessage();
  }

  uint64_t size() const { return size_; }

 private:
  // The parser refuses deeper nesting, too.
  static constexpr int kDeepest = 100;

  bool AddField(const Descriptor& type, uint32_t tag) {
    const FieldDescriptor* field =
        type.FindFieldByNumber(WireFormatLite::GetTagFieldNumber(tag));
    switch (WireFormatLite::GetTagWireType(tag)) {
      case WireFormatLite::WIRETYPE_LENGTH_DELIMITED:
        return AddDelimited(field);
      case WireFormatLite::WIRETYPE_START_GROUP:
      case WireFormatLite::WIRETYPE_END_GROUP:
        // The protocol has no groups; the parser keeps them as unknown fields.
        is_in_group_ = true;
        size_ += kString;
        return true;
      default:
        if (field == nullptr || field->is_repeated() || is_in_group_) {
          size_ += kScalar;
        }
        return WireFormatLite::SkipField(&input_, tag);
    }
  }

  bool AddDelimited(const FieldDescriptor* field) {
    uint32_t length = 0;
    if (!input_.ReadVarint32(&length)) return false;
    if (field == nullptr || field->message_type() == nullptr) {
      if (field != nullptr && field->is_packable()) {
        size_ +=
            kAllocation +
            (HasFixedLength(*field) ? kFixedGrowth : kVarintGrowth) * length;
      } else {
        size_ += kString + length;
      }
      return input_.Skip(static_cast<int>(length));
    }
    if (++depth_ > kDeepest) return false;
    size_ += kAllocation;
    const auto limit = input_.PushLimit(static_cast<int>(length));
    if (!AddMessage(*field->message_type())) return false;
    input_.PopLimit(limit);
    --depth_;
    return true;
  }

  uint64_t SizeOf(const Descriptor& type) {
    uint64_t& size = sizes_[&type];
    if (size == 0) {
      size = MessageFactory::generated_factory()
                 ->GetPrototype(&type)
                 ->SpaceUsedLong();
    }
    return size;
  }

  CodedInputStream& input_;
  std::map<const Descriptor*, uint64_t> sizes_;  // of empty messages
  uint64_t size_ = 0;
  int depth_ = 0;
  bool is_in_group_ = false;
};

}  // namespace

uint64_t DecodedSize(const Descriptor& type,
                     google::protobuf::io::ZeroCopyInputStream& bytes) {
  CodedInputStream input(&bytes);
  Sizer sizer(input);
  sizer.AddMessage(type);
  return sizer.size();
}

Intake::Intake(const Options& options)
    : memory_(
          std::make_shared<ByteBudget>("request memory", options.memory_bytes)),
      patience_(options.patience),
      free_slots_(options.slots) {}

void Intake::Enter(std::shared_ptr<Receiver> receiver,
                   const std::string& connection) {
  {
    MutexLock lock(mutex_);
    connections_[connection].waiting.push_back(std::move(receiver));
  }
  Serve();
}

void Intake::Leave(const Receiver& receiver) {
  std::shared_ptr<Receiver> gone;  // destroyed without the lock
  {
    MutexLock lock(mutex_);
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
    MutexLock lock(mutex_);
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
    MutexLock lock(mutex_);
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
        "the message is not a well-formed ", std::string(type.full_name()),
        ", or compressed by neither gzip nor deflate"));
  }
  return memory;
}

void Intake::ReleaseRequest(ByteReservation& reservation) {
  reservation.ShrinkTo(reservation.bytes() / kShareAfterwards);
}

absl::Status LateError(std::chrono::milliseconds patience) {
  return absl::DeadlineExceededError(
      absl::StrCat("a message of the request did not come as a whole within ",
                   patience.count() / 1000,
                   " s (the server's "
                   "limit receive-seconds)"));
}

absl::Status BrokenOffError() {
  return WithReason(
      WithRetryAfter(absl::ResourceExhaustedError(
                         "messages that are still coming in fill the server's "
                         "limit receive-memory, and this one came slowly; try "
                         "again later"),
                     kComeAgain),
      reason::kMemoryFull);
}

}  // namespace geodesic::server
