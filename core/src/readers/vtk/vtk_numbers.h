// Numbers and lines of VTK's formats.

#ifndef GEODESIC_READERS_VTK_VTK_NUMBERS_H_
#define GEODESIC_READERS_VTK_VTK_NUMBERS_H_

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>

#include "readers/byte_order.h"
#include "readers/text_scanner.h"

namespace geodesic {

template <typename T, std::endian kOrder>
double LoadVtkReal(const char* address) {
  return static_cast<double>(Load<T, kOrder>(address));
}
template <typename T, std::endian kOrder>
int64_t LoadVtkInteger(const char* address) {
  return static_cast<int64_t>(Load<T, kOrder>(address));
}

// A type of numbers, as a format names it.
struct VtkType {
  std::string_view name;
  size_t bytes;
  bool is_whole;
  // By whether the most significant byte comes first.
  std::array<double (*)(const char*), 2> load_real;
  std::array<int64_t (*)(const char*), 2> load_integer;
};

template <typename T>
constexpr VtkType VtkTypeOf(std::string_view name) {
  return {
      name,
      sizeof(T),
      std::is_integral_v<T>,
      {&LoadVtkReal<T, std::endian::little>, &LoadVtkReal<T, std::endian::big>},
      {&LoadVtkInteger<T, std::endian::little>,
       &LoadVtkInteger<T, std::endian::big>}};
}

inline constexpr VtkType kVtkInt = VtkTypeOf<int32_t>("int");
// Those of the legacy format.
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

// Null where there is no such type among `types`.
inline const VtkType* VtkTypeNamed(std::span<const VtkType> types,
                                   std::string_view name) {
  for (const VtkType& type : types) {
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
  void set_binary(std::endian order) {
    is_binary_ = true;
    is_big_ = order == std::endian::big;
  }

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

  // How many numbers may follow at the most.
  uint64_t MostNumbers(const VtkType& type) const {
    // The last number of a text may lack its end.
    return is_binary_ ? remaining() / type.bytes : (remaining() + 1) / 2;
  }

  std::optional<double> Real(const VtkType& type) {
    if (!is_binary_) return ParseFinite(Word());
    const char* const number = Take(type.bytes);
    if (number == nullptr) return std::nullopt;
    const double value = type.load_real[is_big_](number);
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
  }
  std::optional<int64_t> Integer(const VtkType& type) {
    if (!is_binary_) return ParseInteger(Word());
    const char* const number = Take(type.bytes);
    if (number == nullptr) return std::nullopt;
    return type.load_integer[is_big_](number);
  }

  // Moves past numbers. REQUIRES: count <= MostNumbers(type).
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
  bool is_big_ = false;
};

}  // namespace geodesic

#endif  // GEODESIC_READERS_VTK_VTK_NUMBERS_H_
