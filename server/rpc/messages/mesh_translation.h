// Meshes and uploads <-> the protocol's messages.

#ifndef GEODESIC_SERVER_RPC_MESSAGES_MESH_TRANSLATION_H_
#define GEODESIC_SERVER_RPC_MESSAGES_MESH_TRANSLATION_H_

#include <string_view>
#include <utility>

#include "absl/status/statusor.h"
#include "geodesic/v1/mesh.pb.h"
#include "geodesic/v1/mesh_service.pb.h"
#include "server/engine/meshes/mesh_catalogue.h"

namespace geodesic::server {

// What clients may upload.
inline constexpr std::pair<UploadFormat, v1::MeshFormat> kMeshFormats[] = {
    {UploadFormat::kArrays, v1::MESH_FORMAT_ARRAYS},
    {UploadFormat::kObj, v1::MESH_FORMAT_OBJ},
    {UploadFormat::kPly, v1::MESH_FORMAT_PLY},
    {UploadFormat::kOff, v1::MESH_FORMAT_OFF},
    {UploadFormat::kStl, v1::MESH_FORMAT_STL},
};

v1::Mesh ToProto(const MeshDescription& mesh);
v1::FileDigest ToProto(const FileKey& file);

// Errors of these: INVALID_ARGUMENT naming `field`, the path of the value in
// the request.
absl::StatusOr<UploadFormat> FromProto(v1::MeshFormat format,
                                       std::string_view field);
absl::StatusOr<UploadHeader> FromProto(const v1::UploadHeader& header);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_MESSAGES_MESH_TRANSLATION_H_
