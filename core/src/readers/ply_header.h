// The header of a PLY file: what its body holds, in order.

#ifndef GEODESIC_READERS_PLY_HEADER_H_
#define GEODESIC_READERS_PLY_HEADER_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "readers/ply_scalar.h"
#include "readers/text_scanner.h"

namespace geodesic {

enum class PlyEncoding { kAscii, kBinaryLittleEndian, kBinaryBigEndian };

// What a property is to a triangle mesh.
enum class PlyRole { kIgnored, kX, kY, kZ, kCorners };

struct PlyProperty {
  std::string_view name;
  PlyScalar type = PlyScalar::kInt8;    // of a list: of its items
  std::optional<PlyScalar> count_type;  // lists only; an integer type
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
