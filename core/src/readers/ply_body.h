// The body of a PLY file, behind its header.

#ifndef GEODESIC_READERS_PLY_BODY_H_
#define GEODESIC_READERS_PLY_BODY_H_

#include <string_view>

#include "absl/status/status.h"
#include "readers/ply_header.h"
#include "readers/soup_builder.h"
#include "readers/text_scanner.h"

namespace geodesic {

// Reads the rows of all elements, one per line, from where `scanner` stands.
// Errors: INVALID_ARGUMENT naming line and row; RESOURCE_EXHAUSTED.
absl::Status ReadPlyAsciiBody(const PlyHeader& header, LineScanner& scanner,
                              SoupBuilder& builder);

// Reads the rows of all elements from header.body_offset on; `bytes` is the
// whole file. Errors: INVALID_ARGUMENT naming byte and row;
// RESOURCE_EXHAUSTED.
absl::Status ReadPlyBinaryBody(const PlyHeader& header, std::string_view bytes,
                               SoupBuilder& builder);

}  // namespace geodesic

#endif  // GEODESIC_READERS_PLY_BODY_H_
