// Writes numbers and strings as bytes for the server's own files: little
// endian, in order, without padding.

#ifndef GEODESIC_SERVER_ENGINE_BASE_BINARY_CODEC_H_
#define GEODESIC_SERVER_ENGINE_BASE_BINARY_CODEC_H_

#include <bit>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace geodesic::server {

static_assert(std::endian::native == std::endian::little);

// The values of an array as they lie in memory.
template <typename Array>
std::string_view AsBytes(const Array& values) {
  return {reinterpret_cast<const char*>(std::data(values)),
          std::size(values) * sizeof(*std::data(values))};
}

// The same, to be read into.
template <typename T>
std::span<char> AsWritableBytes(std::vector<T>& values) {
  return {reinterpret_cast<char*>(values.data()), values.size() * sizeof(T)};
}

class BinaryWriter {
 public:
  template <typename T>
  void Put(const T& value) {
    static_assert(std::is_arithmetic_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(value));
  }
  void PutString(std::string_view text) {
    Put(uint64_t{text.size()});
    bytes_.append(text);
  }

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

// A value beyond the end and all that follow read as zero; ok() is then false.
class BinaryReader {
 public:
  explicit BinaryReader(std::string_view bytes) : bytes_(bytes) {}

  template <typename T>
  void Get(T& value) {
    static_assert(std::is_arithmetic_v<T>);
    value = T();
    ok_ = ok_ && bytes_.size() >= sizeof(value);
    if (!ok_) return;
    std::memcpy(&value, bytes_.data(), sizeof(value));
    bytes_.remove_prefix(sizeof(value));
  }
  void GetString(std::string& text) {
    uint64_t size = 0;
    Get(size);
    ok_ = ok_ && bytes_.size() >= size;
    text = ok_ ? bytes_.substr(0, size) : "";
    if (ok_) bytes_.remove_prefix(size);
  }

  bool ok() const { return ok_; }
  // Whether every value could be read and no byte is left.
  bool AtEnd() const { return ok_ && bytes_.empty(); }

 private:
  std::string_view bytes_;
  bool ok_ = true;
};

// What records begin with, so that none is taken for another. A record that
// changes gets a new number.
inline constexpr uint32_t kMeshRecord = 4;
inline constexpr uint32_t kFieldRecord = 2;
inline constexpr uint32_t kLandmarksRecord = 1002;
inline constexpr uint32_t kGraphRecord = 2001;
inline constexpr uint32_t kSharedMeshRecord = 3001;

// The record that `read(reader, record)` reads. Empty unless the bytes begin
// with this number and end with the record.
template <typename Record, typename Read>
std::optional<Record> DecodeRecord(std::string_view bytes, uint32_t number,
                                   Read read) {
  BinaryReader reader(bytes);
  uint32_t found = 0;
  reader.Get(found);
  if (found != number) return std::nullopt;
  Record record;
  read(reader, record);
  if (!reader.AtEnd()) return std::nullopt;
  return record;
}

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_BASE_BINARY_CODEC_H_
