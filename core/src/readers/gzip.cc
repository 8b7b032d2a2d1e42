#include "geodesic/gzip.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "geodesic/checkpoint.h"
#include "readers/byte_order.h"
#include "readers/inflater.h"
#include "readers/reader_errors.h"

namespace geodesic {
namespace {

// The format of RFC 1952, with any window.
constexpr int kWindowBits = 15 + 16;
constexpr std::string_view kMagic = "\x1f\x8b\x08";
// The shortest file: header, an empty block, trailer.
constexpr size_t kLeastBytes = 20;
constexpr size_t kBlockBytes = 1 << 16;

bool IsPadding(std::string_view bytes) {
  return std::ranges::all_of(bytes, [](char c) { return c == '\0'; });
}

}  // namespace

bool IsGzip(std::string_view bytes) { return bytes.starts_with(kMagic); }

uint64_t PromisedGzipBytes(std::string_view bytes) {
  const uint64_t most = std::max<uint64_t>(1, bytes.size() * kMostInflation);
  if (bytes.size() < kLeastBytes) return most;
  // The last piece's size, modulo 2^32.
  const uint64_t promised = Load<uint32_t, std::endian::little>(
      bytes.data() + bytes.size() - sizeof(uint32_t));
  return std::clamp<uint64_t>(promised, 1, most);
}

absl::StatusOr<std::vector<char>> Gunzip(std::string_view bytes, uint64_t most,
                                         Checkpoint* checkpoint) {
  Inflater inflater(kWindowBits);
  if (!inflater.is_ready()) {
    return absl::ResourceExhaustedError("there is no memory to decompress");
  }
  z_stream& stream = inflater.stream();
  std::vector<char> inflated;
  inflated.reserve(std::min(most, PromisedGzipBytes(bytes)));
  std::array<char, kBlockBytes> block;
  size_t taken = 0;
  while (true) {
    // zlib counts in 32 bits.
    const size_t input = std::min<size_t>(bytes.size() - taken,
                                          std::numeric_limits<uInt>::max());
    stream.next_in = const_cast<Bytef*>(
        reinterpret_cast<const Bytef*>(bytes.data() + taken));
    stream.avail_in = static_cast<uInt>(input);
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = block.size();
    const int result = inflate(&stream, Z_NO_FLUSH);
    taken += input - stream.avail_in;
    const size_t output = block.size() - stream.avail_out;
    if (output > most - inflated.size()) {
      return absl::ResourceExhaustedError(absl::StrCat(
          "the file holds more than ", most, " bytes when it is decompressed"));
    }
    if (const uint64_t needed = inflated.size() + output;
        needed > inflated.capacity()) {
      inflated.reserve(std::clamp<uint64_t>(2 * inflated.size(), needed, most));
    }
    inflated.insert(inflated.end(), block.data(), block.data() + output);
    if (result == Z_STREAM_END) {
      const std::string_view rest = bytes.substr(taken);
      if (IsPadding(rest)) return inflated;
      if (!IsGzip(rest)) {
        return AtByte(taken, "the compressed bytes end here, but not the file");
      }
      inflateReset(&stream);
    } else if (result == Z_BUF_ERROR && output == 0) {
      return AtByte(bytes.size(),
                    "the file is cut off: its compressed bytes "
                    "go on");
    } else if (result != Z_OK && result != Z_BUF_ERROR) {
      return AtByte(taken, "the compressed bytes are damaged",
                    stream.msg == nullptr ? "" : ": ",
                    stream.msg == nullptr ? "" : stream.msg);
    }
    if (checkpoint == nullptr) continue;
    if (absl::Status status = checkpoint->Poll({}); !status.ok()) return status;
  }
}

}  // namespace geodesic
