// libFuzzer target: however a body is cut into pieces, the same messages are
// read from it, and the same error; of malformed text, an error.

#include <fuzzer/FuzzedDataProvider.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "server/web/grpc_web.h"

namespace geodesic::server {
namespace {

constexpr uint64_t kMaxMessageBytes = 1 << 12;

struct Outcome {
  std::vector<std::string> messages;
  absl::Status status;

  friend bool operator==(const Outcome&, const Outcome&) = default;
};

std::string Bytes(const grpc::ByteBuffer& message) {
  std::vector<grpc::Slice> slices;
  if (!message.Dump(&slices).ok()) std::abort();
  std::string bytes;
  for (const grpc::Slice& slice : slices) {
    bytes.append(reinterpret_cast<const char*>(slice.begin()), slice.size());
  }
  return bytes;
}

// Reads the body in pieces of the sizes that `next_size` gives.
template <typename NextSize>
Outcome ReadBody(WebEncoding encoding, std::string_view body,
                 NextSize next_size) {
  Outcome outcome;
  FrameReader reader(encoding, kMaxMessageBytes);
  while (!body.empty() || reader.has_pending()) {
    const std::string_view piece = body.substr(0, next_size());
    const auto read = reader.Read(piece);
    if (!read.ok()) {
      outcome.status = read.status();
      return outcome;
    }
    if (*read > piece.size()) std::abort();
    body.remove_prefix(*read);
    if (reader.wants_room()) {
      if (reader.message_bytes() > kMaxMessageBytes) std::abort();
      reader.MakeRoom();
    }
    if (reader.has_message()) {
      outcome.messages.push_back(Bytes(reader.TakeMessage()));
    }
  }
  outcome.status = reader.CheckEnd();
  return outcome;
}

void Check(FuzzedDataProvider& data) {
  const auto encoding =
      data.ConsumeBool() ? WebEncoding::kText : WebEncoding::kBinary;
  std::vector<size_t> sizes(8);
  for (size_t& size : sizes) size = data.ConsumeIntegralInRange<size_t>(1, 64);
  const std::string body = data.ConsumeRemainingBytesAsString();
  const Outcome whole =
      ReadBody(encoding, body, [&] { return body.size() + 1; });
  size_t next = 0;
  const Outcome pieces =
      ReadBody(encoding, body, [&] { return sizes[next++ % sizes.size()]; });
  if (encoding == WebEncoding::kText && !whole.status.ok()) {
    // Several frames may be in the piece of text that is found malformed.
    const size_t common =
        std::min(whole.messages.size(), pieces.messages.size());
    if (pieces.status.ok() ||
        !std::equal(whole.messages.begin(), whole.messages.begin() + common,
                    pieces.messages.begin())) {
      std::abort();
    }
    return;
  }
  if (!(whole == pieces)) std::abort();
  if (encoding == WebEncoding::kText) return;
  // What was read, framed again, is the body's beginning.
  std::string again;
  for (const std::string& message : whole.messages) {
    again += FrameHeader(message.size()) + message;
  }
  if (!body.starts_with(again)) std::abort();
  if (whole.status.ok() && again != body) std::abort();
}

}  // namespace
}  // namespace geodesic::server

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
  FuzzedDataProvider data(bytes, size);
  geodesic::server::Check(data);
  return 0;
}
