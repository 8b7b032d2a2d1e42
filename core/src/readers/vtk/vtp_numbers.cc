#include "readers/vtk/vtp_numbers.h"

#include <algorithm>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"

namespace geodesic {
namespace {

// A zlib stream with any window.
constexpr int kWindowBits = 15;
constexpr size_t kBufferBytes = 1 << 16;
constexpr size_t kWidestNumber = 8;
constexpr int8_t kNoSextet = -1;

constexpr std::array<int8_t, 256> Sextets() {
  std::array<int8_t, 256> sextets;
  sextets.fill(kNoSextet);
  constexpr std::string_view kAlphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (size_t i = 0; i < kAlphabet.size(); ++i) {
    sextets[static_cast<uint8_t>(kAlphabet[i])] = static_cast<int8_t>(i);
  }
  return sextets;
}

template <typename... Parts>
absl::Status Invalid(const Parts&... parts) {
  return absl::InvalidArgumentError(absl::StrCat(parts...));
}

absl::Status CutOff() { return Invalid("its header is cut off"); }

// Of the numbers in the headers of arrays.
constexpr VtkType kShortHeader = VtkTypeOf<uint32_t>("UInt32");
constexpr VtkType kLongHeader = VtkTypeOf<uint64_t>("UInt64");

const VtkType& HeaderType(const VtpStyle& style) {
  return style.has_long_headers ? kLongHeader : kShortHeader;
}

}  // namespace

size_t VtpBytes::Take(char* out, size_t count) {
  if (!is_base64_) {
    count = text_.copy(out, count, offset_);
    offset_ += count;
    return count;
  }
  for (size_t taken = 0; taken < count; ++taken) {
    if (decoded_begin_ == decoded_end_ && !DecodeFour()) return taken;
    out[taken] = decoded_[decoded_begin_++];
  }
  return count;
}

bool VtpBytes::Skip(uint64_t count) {
  if (count > most()) return false;
  if (!is_base64_) {
    offset_ += count;
    return true;
  }
  for (char skipped = 0; count > 0; --count) {
    if (Take(&skipped, 1) == 0) return false;
  }
  return true;
}

bool VtpBytes::DecodeFour() {
  static constexpr std::array<int8_t, 256> kSextets = Sextets();
  uint32_t bits = 0;
  int padding = 0;
  size_t at = offset_;
  for (int character = 0; character < 4;) {
    if (at == text_.size()) return false;
    const char c = text_[at++];
    if (IsVtkBlank(c)) continue;
    int8_t sextet = kSextets[static_cast<uint8_t>(c)];
    if (c == '=' && character >= 2) {
      sextet = 0;
      ++padding;
    } else if (padding > 0) {
      return false;
    }
    if (sextet == kNoSextet) return false;
    bits = bits << 6 | static_cast<uint32_t>(sextet);
    ++character;
  }
  offset_ = at;
  decoded_ = {static_cast<char>(bits >> 16), static_cast<char>(bits >> 8),
              static_cast<char>(bits)};
  decoded_begin_ = 0;
  decoded_end_ = decoded_.size() - padding;
  return true;
}

VtpNumbers VtpNumbers::OfText(std::string_view text, const VtkType& type) {
  VtpNumbers numbers(type);
  numbers.cursor_ = VtkCursor(text);
  return numbers;
}

absl::StatusOr<VtpNumbers> VtpNumbers::OfBytes(const VtpBytes& bytes,
                                               const VtpStyle& style,
                                               const VtkType& type) {
  VtpNumbers numbers(type);
  numbers.bytes_ = bytes;
  numbers.style_ = style;
  const absl::Status status =
      style.is_compressed ? numbers.ReadBlockSizes() : numbers.ReadHeader();
  if (!status.ok()) return status;
  numbers.buffer_.resize(
      std::clamp<uint64_t>(numbers.left_, kWidestNumber, kBufferBytes));
  return numbers;
}

std::optional<uint64_t> VtpNumbers::HeaderNumber(VtpBytes& bytes) const {
  const VtkType& type = HeaderType(style_);
  std::array<char, kWidestNumber> number;
  if (bytes.Take(number.data(), type.bytes) < type.bytes) return std::nullopt;
  const bool is_big = style_.order == std::endian::big;
  return static_cast<uint64_t>(type.load_integer[is_big](number.data()));
}

absl::Status VtpNumbers::ReadHeader() {
  const std::optional<uint64_t> promised = HeaderNumber(*bytes_);
  if (!promised.has_value()) return CutOff();
  if (*promised > bytes_->most()) {
    return Invalid("its header promises ", *promised, " bytes, but ",
                   bytes_->most(), " follow");
  }
  left_ = *promised;
  return absl::OkStatus();
}

absl::Status VtpNumbers::ReadBlockSizes() {
  const std::optional<uint64_t> blocks = HeaderNumber(*bytes_);
  const std::optional<uint64_t> block_bytes = HeaderNumber(*bytes_);
  const std::optional<uint64_t> last_bytes = HeaderNumber(*bytes_);
  if (!last_bytes.has_value()) return CutOff();
  inflater_ = std::make_unique<Inflater>(kWindowBits);
  if (!inflater_->is_ready()) {
    return absl::ResourceExhaustedError("there is no memory to decompress");
  }
  sizes_ = bytes_;
  const uint64_t size = HeaderType(style_).bytes;
  if (*blocks > bytes_->most() / size || !bytes_->Skip(*blocks * size)) {
    return Invalid("its header promises ", *blocks,
                   " compressed blocks, more than can follow");
  }
  if (*blocks == 0) return absl::OkStatus();
  // Zero says that the last is as large as the others.
  last_block_bytes_ = *last_bytes == 0 ? *block_bytes : *last_bytes;
  const uint64_t most = bytes_->most() * kMostInflation;
  const uint64_t full_blocks = *blocks - 1;
  if (*block_bytes == 0 || last_block_bytes_ > *block_bytes ||
      last_block_bytes_ > most ||
      (full_blocks > 0 &&
       *block_bytes > (most - last_block_bytes_) / full_blocks)) {
    return Invalid("its header promises ", *blocks, " blocks of ", *block_bytes,
                   " bytes and a last one of ", *last_bytes,
                   ", which cannot be");
  }
  block_bytes_ = *block_bytes;
  blocks_left_ = *blocks;
  left_ = full_blocks * block_bytes_ + last_block_bytes_;
  compressed_.resize(std::min<uint64_t>(bytes_->most(), kBufferBytes));
  return absl::OkStatus();
}

uint64_t VtpNumbers::MostNumbers() const {
  return bytes_.has_value() ? left_ / type_->bytes
                            : cursor_.MostNumbers(*type_);
}

std::optional<double> VtpNumbers::Real() {
  Decode();
  return cursor_.Real(*type_);
}

std::optional<int64_t> VtpNumbers::Integer() {
  Decode();
  return cursor_.Integer(*type_);
}

void VtpNumbers::Decode() {
  if (!bytes_.has_value() || cursor_.remaining() >= type_->bytes) return;
  // A number may lie in two blocks.
  size_t end = cursor_.remaining();
  std::copy_n(buffer_.begin() + cursor_.offset(), end, buffer_.begin());
  while (end < type_->bytes) {
    const size_t more = DecodeInto(&buffer_[end], buffer_.size() - end);
    if (more == 0) break;
    end += more;
  }
  cursor_ = VtkCursor({buffer_.data(), end});
  cursor_.set_binary(style_.order);
}

size_t VtpNumbers::DecodeInto(char* out, size_t count) {
  count = std::min<uint64_t>(count, left_);
  if (count == 0) return 0;
  count = is_compressed() ? Inflate(out, count) : bytes_->Take(out, count);
  left_ -= count;
  return count;
}

size_t VtpNumbers::Inflate(char* out, size_t count) {
  if (block_left_ == 0 && !EnterBlock()) return 0;
  count = std::min<uint64_t>(count, block_left_);
  const bool is_rest = count == block_left_;
  z_stream& stream = inflater_->stream();
  stream.next_out = reinterpret_cast<Bytef*>(out);
  stream.avail_out = static_cast<uInt>(count);
  int result = Z_OK;
  // With the rest comes a checksum.
  while (stream.avail_out > 0 || (is_rest && result != Z_STREAM_END)) {
    if (stream.avail_in == 0 && compressed_left_ > 0 && !FeedInflater()) {
      return 0;
    }
    result = inflate(&stream, Z_NO_FLUSH);
    if (result == Z_STREAM_END && stream.avail_out > 0) return 0;
    if (result != Z_OK && result != Z_STREAM_END) return 0;
  }
  block_left_ -= count;
  if (block_left_ == 0 && (stream.avail_in > 0 || compressed_left_ > 0)) {
    return 0;
  }
  return count;
}

bool VtpNumbers::EnterBlock() {
  const std::optional<uint64_t> size = HeaderNumber(*sizes_);
  if (blocks_left_ == 0 || !size.has_value()) return false;
  --blocks_left_;
  compressed_left_ = *size;
  block_left_ = blocks_left_ == 0 ? last_block_bytes_ : block_bytes_;
  inflater_->stream().avail_in = 0;
  return inflateReset(&inflater_->stream()) == Z_OK;
}

bool VtpNumbers::FeedInflater() {
  const size_t count =
      bytes_->Take(compressed_.data(),
                   std::min<uint64_t>(compressed_left_, compressed_.size()));
  compressed_left_ -= count;
  inflater_->stream().next_in = reinterpret_cast<Bytef*>(compressed_.data());
  inflater_->stream().avail_in = static_cast<uInt>(count);
  return count > 0;
}

}  // namespace geodesic
