// Tells people who name the wrong format what their bytes look like.

#ifndef GEODESIC_READERS_CONTENT_SNIFFER_H_
#define GEODESIC_READERS_CONTENT_SNIFFER_H_

#include <string_view>

#include "absl/status/status.h"
#include "geodesic/read_mesh.h"

namespace geodesic {

// OK unless the bytes are plainly something other than `format`.
// Errors: INVALID_ARGUMENT that says what they look like and what to do.
absl::Status CheckContent(std::string_view bytes, MeshFormat format);

}  // namespace geodesic

#endif  // GEODESIC_READERS_CONTENT_SNIFFER_H_
