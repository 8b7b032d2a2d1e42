#include "server/rpc/calls/intake.h"

#include <google/protobuf/descriptor.h>
#include <grpcpp/support/proto_buffer_reader.h>

#include <utility>

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

}  // namespace

Intake::Intake(const Options& options)
    : memory_(
          std::make_shared<ByteBudget>("request memory", options.memory_bytes)),
      patience_(options.patience),
      slots_(options.slots) {}

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
