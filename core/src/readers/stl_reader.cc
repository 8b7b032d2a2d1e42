// STL. ASCII: any number of solids, keywords in any case. Binary files are told
// apart by their content.

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

#include "absl/status/statusor.h"
#include "absl/strings/match.h"
#include "absl/strings/string_view.h"
#include "readers/byte_order.h"
#include "readers/readers.h"
#include "readers/text_reader.h"
#include "readers/vertex_welder.h"

namespace geodesic {
namespace {

bool Is(std::string_view token, absl::string_view keyword) {
  return absl::EqualsIgnoreCase(absl::string_view(token.data(), token.size()),
                                keyword);
}

bool Welds(const ReadLimits& limits) {
  return limits.welding.kind != Welding::Kind::kNone;
}

class AsciiStlReader : TextReader {
 public:
  AsciiStlReader(std::string_view bytes, const ReadLimits& limits)
      : TextReader(bytes, limits), welder_(builder_, Welds(limits)) {}

  absl::StatusOr<TriangleSoup> Read() {
    for (std::string_view token = Take(); !token.empty(); token = Take()) {
      if (!Expect("solid", token) || !ReadSolid()) break;
    }
    return std::move(builder_).Take();
  }

 private:
  // The next token, on whatever line; empty at the end of the file.
  std::string_view Take() {
    while (true) {
      const std::string_view token = TakeToken(rest_);
      if (!token.empty()) return token;
      if (!NextLine()) return {};
    }
  }

  bool Expect(absl::string_view keyword, std::string_view token) {
    if (Is(token, keyword)) return true;
    if (token.empty()) {
      return Refuse("the file ends at face ", face_, ", where '", keyword,
                    "' was expected");
    }
    return Refuse("face ", face_, ": '", keyword, "' was expected, not '",
                  Printable(token), "'");
  }

  // The rest of a solid behind its first word.
  bool ReadSolid() {
    rest_ = {};  // a name, which may hold anything
    std::string_view token = Take();
    for (; Is(token, "facet"); token = Take(), ++face_) {
      if (!ReadFacet()) return false;
    }
    rest_ = {};  // the name again
    return Expect("endsolid", token);
  }

  // The rest of a facet behind its first word.
  bool ReadFacet() {
    std::string_view token = Take();
    if (Is(token, "normal")) {
      // Normals follow from the corners, so theirs go unread.
      for (int axis = 0; axis < 3; ++axis) Take();
      token = Take();
    }
    if (!Expect("outer", token) || !Expect("loop", Take())) return false;
    builder_.BeginFace();
    int64_t corners = 0;
    for (token = Take(); Is(token, "vertex"); token = Take(), ++corners) {
      Point point;
      for (double& coordinate : point) {
        if (!ReadCoordinate(Take(), coordinate, "face ", face_, ", corner ",
                            corners)) {
          return false;
        }
      }
      if (!welder_.AddCorner(point)) return false;
    }
    if (!Expect("endloop", token)) return false;
    if (corners < 3) return Refuse("face ", face_, TooFewCorners(corners));
    return Expect("endfacet", Take());
  }

  VertexWelder welder_;
  uint64_t face_ = 0;
};

constexpr size_t kCountOffset = 80;
constexpr size_t kHeaderBytes = 84;
// Normal, three corners, two bytes of attributes.
constexpr size_t kFacetBytes = 50;
constexpr size_t kNormalBytes = 12;

// REQUIRES: the header is there.
uint64_t PromisedFacets(std::string_view bytes) {
  return Load<uint32_t, std::endian::little>(bytes.data() + kCountOffset);
}

bool LooksLikeAscii(std::string_view bytes) {
  if (bytes.find('\0') != std::string_view::npos) return false;
  LineScanner scanner(bytes);
  if (!scanner.NextNonBlank()) return false;
  std::string_view line = scanner.line();
  return Is(TakeToken(line), "solid");
}

bool ReadFacet(std::string_view bytes, uint64_t facet, SoupBuilder& builder,
               VertexWelder& welder) {
  size_t offset = kHeaderBytes + facet * kFacetBytes + kNormalBytes;
  builder.BeginFace();
  for (int corner = 0; corner < 3; ++corner) {
    Point point;
    for (double& coordinate : point) {
      coordinate = Load<float, std::endian::little>(bytes.data() + offset);
      if (!std::isfinite(coordinate)) {
        return builder.Refuse(AtByte(offset, "face ", facet, ", corner ",
                                     corner,
                                     ": a coordinate is not a finite number"));
      }
      offset += sizeof(float);
    }
    if (!welder.AddCorner(point)) return false;
  }
  return true;
}

absl::StatusOr<TriangleSoup> ReadBinaryStl(std::string_view bytes,
                                           const ReadLimits& limits) {
  if (bytes.size() < kHeaderBytes) {
    return AtByte(bytes.size(),
                  "the file is neither ASCII STL (it does not begin with "
                  "'solid') nor as long as the header of a binary STL");
  }
  const uint64_t facets = PromisedFacets(bytes);
  if (!HasSizeOfBinaryStl(bytes)) {
    return AtByte(kCountOffset, facets, " faces take ",
                  kHeaderBytes + facets * kFacetBytes,
                  " bytes, but the file has ", bytes.size());
  }
  SoupBuilder builder(limits);
  VertexWelder welder(builder, Welds(limits));
  bool goes_on = builder.ReserveTriangles(facets);
  for (uint64_t facet = 0; facet < facets && goes_on; ++facet) {
    goes_on = ReadFacet(bytes, facet, builder, welder);
  }
  return std::move(builder).Take();
}

}  // namespace

bool HasSizeOfBinaryStl(std::string_view bytes) {
  if (bytes.size() < kHeaderBytes) return false;
  const uint64_t needed = kHeaderBytes + PromisedFacets(bytes) * kFacetBytes;
  return bytes.size() >= needed && bytes.size() - needed < kFacetBytes;
}

absl::StatusOr<TriangleSoup> ReadStl(std::string_view bytes,
                                     const ReadLimits& limits) {
  if (!HasSizeOfBinaryStl(bytes) && LooksLikeAscii(bytes)) {
    return AsciiStlReader(bytes, limits).Read();
  }
  return ReadBinaryStl(bytes, limits);
}

}  // namespace geodesic
