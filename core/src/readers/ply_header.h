// The header of a PLY file: what its body holds, in order.

#ifndef GEODESIC_READERS_PLY_HEADER_H_
#define GEODESIC_READERS_PLY_HEADER_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "readers/text_scanner.h"

namespace geodesic {

enum class PlyEncoding { kAscii, kBinaryLittleEndian, kBinaryBigEndian };

// A scalar type and how binary files store it.
struct PlyType {
  std::string_view name, sized_name;  // "uchar" and "uint8"
  size_t bytes;
  bool is_integer;
  // They read a value at any address, of little and of big endian. As a double
  // it is exact; only integers are read as integers.
  std::array<double (*)(const char*), 2> load_double;
  std::array<int64_t (*)(const char*), 2> load_integer;
};

// What a property is to a triangle mesh.
enum class PlyRole { kX, kY, kZ, kCorners, kIgnored };

struct PlyProperty {
  std::string_view name;
  const PlyType* type = nullptr;        // of a list: of its items
  const PlyType* count_type = nullptr;  // lists only; an integer type
  PlyRole role = PlyRole::kIgnored;     // kCorners: a list of an integer type
};

enum class PlyElementKind { kVertex, kFace, kOther };

struct PlyElement {
  std::string_view name;
  PlyElementKind kind = PlyElementKind::kOther;
  uint64_t count = 0;
  uint64_t line = 0;  // where the header declares it
  std::vector<PlyProperty> properties;

  // "vertex 7", for messages.
  std::string Row(uint64_t row) const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;
  uint64_t vertices = 0;   // as declared
  size_t body_offset = 0;  // of a binary body
};

// Reads up to end_header. The views of the result point into the scanner's
// bytes. Vertices have x, y and z, each once, and faces (if there are any) one
// list of vertex numbers.
// Errors: INVALID_ARGUMENT naming the line.
absl::StatusOr<PlyHeader> ReadPlyHeader(LineScanner& scanner);

}  // namespace geodesic

#endif  // GEODESIC_READERS_PLY_HEADER_H_
