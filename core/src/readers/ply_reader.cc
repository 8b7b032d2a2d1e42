// Stanford PLY.

#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/read_mesh.h"
#include "readers/ply_body.h"
#include "readers/ply_header.h"
#include "readers/readers.h"
#include "readers/soup_builder.h"
#include "readers/text_scanner.h"

namespace geodesic {

absl::StatusOr<TriangleSoup> ReadPly(std::string_view bytes,
                                     const ReadLimits& limits) {
  LineScanner scanner(bytes);
  const absl::StatusOr<PlyHeader> header = ReadPlyHeader(scanner);
  if (!header.ok()) return header.status();
  SoupBuilder builder(limits);
  const absl::Status status = header->encoding == PlyEncoding::kAscii
                                  ? ReadPlyAsciiBody(*header, scanner, builder)
                                  : ReadPlyBinaryBody(*header, bytes, builder);
  if (!status.ok()) return status;
  return std::move(builder).Take();
}

}  // namespace geodesic
