// What a client announces before it sends a mesh.

#ifndef GEODESIC_SERVER_ENGINE_MESHES_UPLOAD_HEADER_H_
#define GEODESIC_SERVER_ENGINE_MESHES_UPLOAD_HEADER_H_

#include <compare>
#include <cstdint>
#include <string>

#include "geodesic/read_mesh.h"

namespace geodesic::server {

// How the bytes of an upload are to be read: the canonical arrays themselves,
// or a file that geodesic::ReadMesh reads.
enum class UploadFormat { kArrays, kObj, kPly, kOff, kStl };

struct UploadHeader {
  UploadFormat format = UploadFormat::kArrays;
  uint64_t size_bytes = 0;
  // kArrays only.
  uint64_t vertex_count = 0;
  uint64_t face_count = 0;
  // When not empty, a mesh with another digest is refused.
  std::string expected_digest;
};

// Names a file as the client holds it.
struct FileKey {
  UploadFormat format = UploadFormat::kArrays;
  std::string sha256;

  friend auto operator<=>(const FileKey&, const FileKey&) = default;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESHES_UPLOAD_HEADER_H_
