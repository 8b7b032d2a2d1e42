// The protocol gRPC-Web, as bytes: frames, their text form, and trailers.
//
// A body is a sequence of frames: a byte of flags, four of length (big endian),
// the message. The answer's last frame has the flag 0x80 and holds the trailers
// in the form of HTTP/1.1 headers. In the text variant all of it is base64, in
// pieces that may each be padded.
// https://github.com/grpc/grpc/blob/master/doc/PROTOCOL-WEB.md

#ifndef GEODESIC_SERVER_WEB_GRPC_WEB_H_
#define GEODESIC_SERVER_WEB_GRPC_WEB_H_

#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/slice.h>
#include <grpcpp/support/status.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace geodesic::server {

// How the bytes of a body are written.
enum class WebEncoding : uint8_t { kBinary, kText };

// The encoding that a content type asks for, e.g. "application/grpc-web+proto";
// nullopt if that is not gRPC-Web with protobuf.
std::optional<WebEncoding> WebEncodingOf(std::string_view content_type);

// The content type of the answer.
std::string_view ContentTypeOf(WebEncoding encoding);

// Decodes base64 that comes in pieces of any size. Not thread-safe.
class Base64Reader {
 public:
  // Appends to `decoded` what is whole. Errors: INVALID_ARGUMENT.
  absl::Status Decode(std::string_view text, std::string& decoded);

  // Whether the last group of four is whole.
  bool is_whole() const { return rest_.empty(); }

 private:
  std::string rest_;  // less than four characters
};

// Cuts messages out of a body that comes in pieces of any size. Holds one
// message at the most. Not thread-safe.
class FrameReader {
 public:
  FrameReader(WebEncoding encoding, uint64_t max_message_bytes)
      : encoding_(encoding), max_message_bytes_(max_message_bytes) {}

  // Takes bytes up to where a message begins or ends; returns how many it took.
  // REQUIRES: neither wants_room() nor has_message(). Errors: INVALID_ARGUMENT
  // for no base64, unknown flags or a trailer; UNIMPLEMENTED for a compressed
  // message; RESOURCE_EXHAUSTED for one that is too large. None can be read on
  // after.
  absl::StatusOr<size_t> Read(std::string_view bytes);

  // Whether bytes were taken that Read has not looked at yet.
  bool has_pending() const { return !decoded_.empty(); }

  // Whether the length of the next message has come, but nothing of it.
  bool wants_room() const { return header_bytes_ == kHeader && !has_room_; }
  // REQUIRES: wants_room().
  size_t message_bytes() const { return left_; }
  // Takes memory for the message. REQUIRES: wants_room().
  void MakeRoom();

  bool has_message() const { return has_room_ && left_ == 0; }
  // REQUIRES: has_message().
  grpc::ByteBuffer TakeMessage();

  // Whether a message, or a part of one, takes memory here.
  bool has_room() const { return has_room_; }
  // Frees it. Nothing can be read after.
  void Drop();

  // Whether the body may end here. Errors: INVALID_ARGUMENT within a frame.
  absl::Status CheckEnd() const;

 private:
  static constexpr size_t kHeader = 5;

  absl::StatusOr<size_t> ReadBinary(std::string_view bytes);
  absl::Status CheckHeader();

  const WebEncoding encoding_;
  const uint64_t max_message_bytes_;

  Base64Reader base64_;
  std::string decoded_;  // that no message has taken

  std::array<char, kHeader> header_ = {};
  size_t header_bytes_ = 0;
  bool has_room_ = false;
  grpc::Slice message_;
  uint8_t* next_ = nullptr;  // in message_, where the next byte goes
  size_t left_ = 0;          // bytes of the message that have not come
};

// The five bytes before a message.
std::string FrameHeader(size_t message_bytes);

using WebTrailers = std::vector<std::pair<std::string, std::string>>;

// The last frame of an answer. Values of `trailers` are as HTTP has them.
std::string TrailerFrame(const grpc::Status& status,
                         const WebTrailers& trailers);

// The time in a "grpc-timeout", e.g. "250m"; nullopt if it is malformed. More
// than a year counts as a year.
std::optional<std::chrono::nanoseconds> ParseTimeout(std::string_view text);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_WEB_GRPC_WEB_H_
