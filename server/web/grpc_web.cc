#include "server/web/grpc_web.h"

#include <arpa/inet.h>
#include <grpc/slice.h>

#include <algorithm>
#include <cstring>

#include "absl/strings/ascii.h"
#include "absl/strings/escaping.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/string_view.h"

namespace geodesic::server {
namespace {

constexpr uint8_t kCompressed = 0x01;
constexpr uint8_t kTrailer = 0x80;

// Text that is decoded at once; bounds what a reader holds beside a message.
constexpr size_t kTextPiece = 4096;

bool IsBase64(char c) {
  return absl::ascii_isalnum(static_cast<unsigned char>(c)) || c == '+' ||
         c == '/' || c == '=';
}

std::string Header(uint8_t flags, size_t bytes) {
  const uint32_t length = htonl(static_cast<uint32_t>(bytes));
  std::string header(1 + sizeof(length), '\0');
  header[0] = static_cast<char>(flags);
  std::memcpy(header.data() + 1, &length, sizeof(length));
  return header;
}

// A status message as a header has it: what is not printable ASCII, and "%", as
// "%" and two hexadecimal digits.
std::string PercentEncoded(std::string_view text) {
  constexpr char kDigits[] = "0123456789ABCDEF";
  std::string encoded;
  encoded.reserve(text.size());
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (absl::ascii_isprint(byte) && c != '%') {
      encoded += c;
    } else {
      encoded += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
    }
  }
  return encoded;
}

}  // namespace

std::optional<WebEncoding> WebEncodingOf(std::string_view content_type) {
  // Parameters such as "; charset=utf-8" change nothing.
  const std::string type = absl::AsciiStrToLower(
      std::string(content_type.substr(0, content_type.find_first_of("; "))));
  if (type == "application/grpc-web" || type == "application/grpc-web+proto") {
    return WebEncoding::kBinary;
  }
  if (type == "application/grpc-web-text" ||
      type == "application/grpc-web-text+proto") {
    return WebEncoding::kText;
  }
  return std::nullopt;
}

std::string_view ContentTypeOf(WebEncoding encoding) {
  return encoding == WebEncoding::kText ? "application/grpc-web-text+proto"
                                        : "application/grpc-web+proto";
}

absl::Status Base64Reader::Decode(std::string_view text, std::string& decoded) {
  rest_.append(text);
  std::string_view left = rest_;
  std::string piece;
  while (left.size() >= 4) {
    // Up to a padded group: one piece of base64 may follow another.
    size_t size = left.size() / 4 * 4;
    const size_t padding = left.find('=');
    if (padding < size) size = (padding / 4 + 1) * 4;
    const absl::string_view group(left.data(), size);
    // It skips white space and takes "." for "=", of which a body has none.
    if (!std::all_of(group.begin(), group.end(), IsBase64) ||
        !absl::Base64Unescape(group, &piece)) {
      return absl::InvalidArgumentError("the body is not base64");
    }
    decoded += piece;
    left.remove_prefix(size);
  }
  rest_.erase(0, rest_.size() - left.size());
  return absl::OkStatus();
}

absl::StatusOr<size_t> FrameReader::Read(std::string_view bytes) {
  if (encoding_ == WebEncoding::kBinary) return ReadBinary(bytes);
  size_t taken = 0;
  for (;;) {
    const absl::StatusOr<size_t> read = ReadBinary(decoded_);
    if (!read.ok()) return read.status();
    decoded_.erase(0, *read);
    if (wants_room() || has_message() || taken == bytes.size()) return taken;
    const std::string_view piece = bytes.substr(taken, kTextPiece);
    absl::Status status = base64_.Decode(piece, decoded_);
    if (!status.ok()) return status;
    taken += piece.size();
  }
}

absl::StatusOr<size_t> FrameReader::ReadBinary(std::string_view bytes) {
  size_t taken = 0;
  while (taken < bytes.size() && !wants_room() && !has_message()) {
    const std::string_view left = bytes.substr(taken);
    if (header_bytes_ < kHeader) {
      const size_t size = std::min(kHeader - header_bytes_, left.size());
      std::memcpy(header_.data() + header_bytes_, left.data(), size);
      header_bytes_ += size;
      taken += size;
      if (header_bytes_ < kHeader) break;
      if (absl::Status status = CheckHeader(); !status.ok()) return status;
    } else {
      const size_t size = std::min(left_, left.size());
      std::memcpy(next_, left.data(), size);
      next_ += size;
      left_ -= size;
      taken += size;
    }
  }
  return taken;
}

absl::Status FrameReader::CheckHeader() {
  const auto flags = static_cast<uint8_t>(header_[0]);
  uint32_t length = 0;
  std::memcpy(&length, header_.data() + 1, sizeof(length));
  length = ntohl(length);
  if (flags == kCompressed) {
    return absl::UnimplementedError("compressed messages are not taken");
  }
  if (flags == kTrailer) {
    return absl::InvalidArgumentError("a request has no trailers");
  }
  if (flags != 0) {
    return absl::InvalidArgumentError(
        absl::StrCat("a frame has the unknown flags ", flags));
  }
  if (length > max_message_bytes_) {
    return absl::ResourceExhaustedError(
        absl::StrCat("a message has ", length, " bytes; the server takes ",
                     max_message_bytes_, " (limit max-message-bytes)"));
  }
  left_ = length;
  return absl::OkStatus();
}

void FrameReader::MakeRoom() {
  grpc_slice message = grpc_slice_malloc_large(left_);
  next_ = GRPC_SLICE_START_PTR(message);
  message_ = grpc::Slice(message, grpc::Slice::STEAL_REF);
  has_room_ = true;
}

grpc::ByteBuffer FrameReader::TakeMessage() {
  grpc::ByteBuffer message(&message_, 1);
  message_ = grpc::Slice();
  header_bytes_ = 0;
  has_room_ = false;
  return message;
}

void FrameReader::Drop() {
  message_ = grpc::Slice();
  has_room_ = false;
}

absl::Status FrameReader::CheckEnd() const {
  if (header_bytes_ == 0 && decoded_.empty() && base64_.is_whole()) {
    return absl::OkStatus();
  }
  return absl::InvalidArgumentError("the body ends within a frame");
}

std::string FrameHeader(size_t message_bytes) {
  return Header(0, message_bytes);
}

std::string TrailerFrame(const grpc::Status& status,
                         const WebTrailers& trailers) {
  std::string text = absl::StrCat(
      "grpc-status: ", static_cast<int>(status.error_code()), "\r\n");
  if (!status.error_message().empty()) {
    absl::StrAppend(&text,
                    "grpc-message: ", PercentEncoded(status.error_message()),
                    "\r\n");
  }
  for (const auto& [name, value] : trailers) {
    absl::StrAppend(&text, name, ": ", value, "\r\n");
  }
  return Header(kTrailer, text.size()) + text;
}

std::optional<std::chrono::nanoseconds> ParseTimeout(std::string_view text) {
  constexpr size_t kMostDigits = 8;
  using std::chrono::nanoseconds;
  constexpr std::pair<char, nanoseconds> kUnits[] = {
      {'n', std::chrono::nanoseconds(1)},  {'u', std::chrono::microseconds(1)},
      {'m', std::chrono::milliseconds(1)}, {'S', std::chrono::seconds(1)},
      {'M', std::chrono::minutes(1)},      {'H', std::chrono::hours(1)}};
  constexpr nanoseconds kMost = std::chrono::hours(24 * 365);
  if (text.size() < 2 || text.size() > kMostDigits + 1) return std::nullopt;
  const std::string_view digits = text.substr(0, text.size() - 1);
  if (!std::all_of(digits.begin(), digits.end(), absl::ascii_isdigit)) {
    return std::nullopt;
  }
  int64_t count = 0;
  if (!absl::SimpleAtoi(absl::string_view(digits.data(), digits.size()),
                        &count)) {
    return std::nullopt;
  }
  for (const auto& [letter, unit] : kUnits) {
    if (letter != text.back()) continue;
    return count > kMost / unit ? kMost : unit * count;
  }
  return std::nullopt;
}

}  // namespace geodesic::server
