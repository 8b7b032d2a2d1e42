#include "codec/mesh_format.h"

#include <string>

#include "absl/strings/ascii.h"

namespace geodesic::codec {

v1::MeshFormat ToProto(MeshFormat format) {
  v1::MeshFormat message = v1::MESH_FORMAT_UNSPECIFIED;
  v1::MeshFormat_Parse("MESH_FORMAT_" + absl::AsciiStrToUpper(std::string(
                                            MeshFormatName(format))),
                       &message);
  return message;
}

std::optional<MeshFormat> FromProto(v1::MeshFormat format) {
  for (const MeshFormatInfo& info : kMeshFormats) {
    if (ToProto(info.format) == format) return info.format;
  }
  return std::nullopt;
}

}  // namespace geodesic::codec
