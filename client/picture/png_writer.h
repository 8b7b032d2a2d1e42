// Images -> PNG files.

#ifndef GEODESIC_CLIENT_PICTURE_PNG_WRITER_H_
#define GEODESIC_CLIENT_PICTURE_PNG_WRITER_H_

#include <string>

#include "absl/status/statusor.h"
#include "client/picture/image.h"

namespace geodesic::client {

// The bytes of a PNG file, tagged as sRGB.
// Errors: INTERNAL with libpng's message.
absl::StatusOr<std::string> EncodePng(const Image& image);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_PNG_WRITER_H_
