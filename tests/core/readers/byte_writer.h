// Writes binary test files in either byte order.

#ifndef GEODESIC_TESTS_CORE_READERS_BYTE_WRITER_H_
#define GEODESIC_TESTS_CORE_READERS_BYTE_WRITER_H_

#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <string_view>

namespace geodesic::test {

class ByteWriter {
 public:
  explicit ByteWriter(std::endian order = std::endian::little)
      : order_(order) {}

  ByteWriter& Text(std::string_view text) {
    bytes_ += text;
    return *this;
  }

  // Each value as a number of type T.
  template <typename T, typename... Values>
  ByteWriter& Put(Values... values) {
    (PutOne<T>(static_cast<T>(values)), ...);
    return *this;
  }

  const std::string& bytes() const { return bytes_; }

 private:
  template <typename T>
  void PutOne(T value) {
    auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (order_ != std::endian::native) std::reverse(raw.begin(), raw.end());
    bytes_.append(raw.data(), raw.size());
  }

  std::endian order_;
  std::string bytes_;
};

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_CORE_READERS_BYTE_WRITER_H_
