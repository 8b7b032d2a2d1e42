// The reader of each format, behind ReadMesh. Contracts as in read_mesh.h.

#ifndef GEODESIC_READERS_READERS_H_
#define GEODESIC_READERS_READERS_H_

#include <string_view>

#include "absl/status/statusor.h"
#include "geodesic/read_mesh.h"
#include "geodesic/triangle_soup.h"

namespace geodesic {

absl::StatusOr<TriangleSoup> ReadGltf(std::string_view bytes,
                                      const ReadLimits& limits);
absl::StatusOr<TriangleSoup> ReadObj(std::string_view bytes,
                                     const ReadLimits& limits);
absl::StatusOr<TriangleSoup> ReadOff(std::string_view bytes,
                                     const ReadLimits& limits);
absl::StatusOr<TriangleSoup> ReadPly(std::string_view bytes,
                                     const ReadLimits& limits);
absl::StatusOr<TriangleSoup> ReadStl(std::string_view bytes,
                                     const ReadLimits& limits);
absl::StatusOr<TriangleSoup> ReadVtk(std::string_view bytes,
                                     const ReadLimits& limits);
absl::StatusOr<TriangleSoup> ReadVtp(std::string_view bytes,
                                     const ReadLimits& limits);

// Whether the size is what the facet count at byte 80 asks for, give or take
// some padding. Stronger evidence than a header that begins with "solid".
bool HasSizeOfBinaryStl(std::string_view bytes);

}  // namespace geodesic

#endif  // GEODESIC_READERS_READERS_H_
