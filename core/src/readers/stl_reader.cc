// STL, binary; ASCII files are told apart here and read next door.

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/match.h"
#include "absl/strings/string_view.h"
#include "geodesic/read_mesh.h"
#include "readers/byte_order.h"
#include "readers/messages.h"
#include "readers/readers.h"
#include "readers/soup_builder.h"
#include "readers/text_scanner.h"
#include "readers/vertex_welder.h"

namespace geodesic {
namespace {

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
  const std::string_view token = TakeToken(line);
  return absl::EqualsIgnoreCase(absl::string_view(token.data(), token.size()),
                                "solid");
}

absl::Status ReadFacet(std::string_view bytes, uint64_t facet,
                       SoupBuilder& builder, VertexWelder& welder) {
  size_t offset = kHeaderBytes + facet * kFacetBytes + kNormalBytes;
  builder.BeginFace();
  for (int corner = 0; corner < 3; ++corner) {
    Point point;
    for (double& coordinate : point) {
      coordinate = Load<float, std::endian::little>(bytes.data() + offset);
      if (!std::isfinite(coordinate)) {
        return AtByte(offset, "face ", facet, ", corner ", corner,
                      ": a coordinate is not a finite number");
      }
      offset += sizeof(float);
    }
    if (absl::Status status = welder.AddCorner(point); !status.ok()) {
      return status;
    }
  }
  return absl::OkStatus();
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
  if (absl::Status status = builder.ReserveTriangles(facets); !status.ok()) {
    return status;
  }
  VertexWelder welder(builder);
  for (uint64_t facet = 0; facet < facets; ++facet) {
    if (absl::Status status = ReadFacet(bytes, facet, builder, welder);
        !status.ok()) {
      return status;
    }
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
    return ReadAsciiStl(bytes, limits);
  }
  return ReadBinaryStl(bytes, limits);
}

}  // namespace geodesic
