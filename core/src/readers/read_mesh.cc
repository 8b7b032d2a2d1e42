#include "geodesic/read_mesh.h"

#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "readers/content_sniffer.h"
#include "readers/readers.h"

namespace geodesic {

absl::StatusOr<TriangleSoup> ReadMesh(std::string_view bytes, MeshFormat format,
                                      const ReadLimits& limits) {
  // The header of a binary STL may begin with any bytes.
  if (format == MeshFormat::kStl && HasSizeOfBinaryStl(bytes)) {
    return ReadStl(bytes, limits);
  }
  if (absl::Status status = CheckContent(bytes, format); !status.ok()) {
    return status;
  }
  switch (format) {
    case MeshFormat::kObj:
      return ReadObj(bytes, limits);
    case MeshFormat::kPly:
      return ReadPly(bytes, limits);
    case MeshFormat::kOff:
      return ReadOff(bytes, limits);
    case MeshFormat::kStl:
      return ReadStl(bytes, limits);
  }
  return absl::InvalidArgumentError("unknown mesh format");
}

}  // namespace geodesic
