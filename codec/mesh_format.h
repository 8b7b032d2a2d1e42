// Formats of mesh files, as geodesic/v1/mesh.proto numbers them.

#ifndef GEODESIC_CODEC_MESH_FORMAT_H_
#define GEODESIC_CODEC_MESH_FORMAT_H_

#include <optional>

#include "geodesic/v1/mesh.pb.h"
#include "geodesic_types/mesh_format.h"

namespace geodesic::codec {

v1::MeshFormat ToProto(MeshFormat format);

// Nothing for arrays, and for numbers that name no format of files.
std::optional<MeshFormat> FromProto(v1::MeshFormat format);

}  // namespace geodesic::codec

#endif  // GEODESIC_CODEC_MESH_FORMAT_H_
