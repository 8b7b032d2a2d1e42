// Numbers and lines of VTK's legacy format.

#ifndef GEODESIC_READERS_VTK_NUMBERS_H_
#define GEODESIC_READERS_VTK_NUMBERS_H_

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "readers/byte_order.h"
#include "readers/text_scanner.h"

namespace geodesic {

// Numbers of VTK's own types, which binary files store with the most
// significant byte first.
template <typename T>
double LoadVtkReal(const char* address) {
  return static_cast<double>(Load<T, std::endian::big>(address));
}
template <typename T>
int64_t LoadVtkInteger(const char* address) {
  return static_cast<int64_t>(Load<T, std::endian::big>(address));
}

struct VtkType {
  std::string_view name;
  size_t bytes;
  double (*load_real)(const char*);
  int64_t (*load_integer)(const char*);
};

template <typename T>
constexpr VtkType VtkTypeOf(std::string_view name) {
  return {name, sizeof(T), &LoadVtkReal<T>, &LoadVtkInteger<T>};
}

inline constexpr VtkType kVtkInt = VtkTypeOf<int32_t>("int");
inline constexpr std::array kVtkTypes = {VtkTypeOf<float>("float"),
                                         VtkTypeOf<double>("double"),
                                         kVtkInt,
                                         VtkTypeOf<uint32_t>("unsigned_int"),
                                         VtkTypeOf<int64_t>("long"),
                                         VtkTypeOf<uint64_t>("unsigned_long"),
                                         VtkTypeOf<int64_t>("vtktypeint64"),
                                         VtkTypeOf<int32_t>("vtktypeint32"),
                                         VtkTypeOf<uint64_t>("vtktypeuint64"),
                                         VtkTypeOf<int32_t>("vtkidtype"),
                                         VtkTypeOf<int16_t>("short"),
                                         VtkTypeOf<uint16_t>("unsigned_short"),
                                         VtkTypeOf<int8_t>("char"),
                                         VtkTypeOf<uint8_t>("unsigned_char")};

// Null where there is no such type.
inline const VtkType* VtkTypeNamed(std::string_view name) {
  for (const VtkType& type : kVtkTypes) {
    if (type.name == name) return &type;
  }
  return nullptr;
}

inline bool IsVtkBlank(char c) {
  return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}

// Walks the bytes by lines, words or numbers.
class VtkCursor {
 public:
  explicit VtkCursor(std::string_view bytes) : bytes_(bytes) {}

  size_t offset() const { return offset_; }
  size_t remaining() const { return bytes_.size() - offset_; }
  void set_binary() { is_binary_ = true; }

  // The next line without its end; none at the end of the file.
  std::optional<std::string_view> Line() {
    if (remaining() == 0) return std::nullopt;
    const size_t end =
        std::min(bytes_.find_first_of("\r\n", offset_), bytes_.size());
    const std::string_view line = bytes_.substr(offset_, end - offset_);
    const size_t end_bytes = bytes_.substr(end, 2) == "\r\n" ? 2 : 1;
    offset_ = std::min(end + end_bytes, bytes_.size());
    return line;
  }

  // Whether so many numbers may follow.
  bool HasRoom(uint64_t count, const VtkType& type) const {
    // The last number of a text may lack its end.
    return is_binary_ ? count <= remaining() / type.bytes
                      : count <= (remaining() + 1) / 2;
  }

  std::optional<double> Real(const VtkType& type) {
    if (!is_binary_) return ParseFinite(Word());
    const char* const number = Take(type.bytes);
    if (number == nullptr) return std::nullopt;
    const double value = type.load_real(number);
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
  }
  std::optional<int64_t> Integer(const VtkType& type) {
    if (!is_binary_) return ParseInteger(Word());
    const char* const number = Take(type.bytes);
    if (number == nullptr) return std::nullopt;
    return type.load_integer(number);
  }

  // Moves past numbers. REQUIRES: HasRoom(count, type).
  bool Skip(uint64_t count, const VtkType& type) {
    if (is_binary_) return Take(count * type.bytes) != nullptr;
    for (; count > 0; --count) {
      if (Word().empty()) return false;
    }
    return true;
  }

 private:
  std::string_view Word() {
    while (offset_ < bytes_.size() && IsVtkBlank(bytes_[offset_])) ++offset_;
    const size_t begin = offset_;
    while (offset_ < bytes_.size() && !IsVtkBlank(bytes_[offset_])) ++offset_;
    return bytes_.substr(begin, offset_ - begin);
  }
  const char* Take(size_t count) {
    if (count > remaining()) return nullptr;
    const char* const taken = bytes_.data() + offset_;
    offset_ += count;
    return taken;
  }

  std::string_view bytes_;
  size_t offset_ = 0;
  bool is_binary_ = false;
};

}  // namespace geodesic

#endif  // GEODESIC_READERS_VTK_NUMBERS_H_
