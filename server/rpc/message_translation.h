// The engine's types <-> the protocol's messages.

#ifndef GEODESIC_SERVER_RPC_MESSAGE_TRANSLATION_H_
#define GEODESIC_SERVER_RPC_MESSAGE_TRANSLATION_H_

#include "absl/status/statusor.h"
#include "geodesic/algorithm.h"
#include "geodesic/checkpoint.h"
#include "geodesic/distance_field.h"
#include "geodesic/v1/field_service.pb.h"
#include "geodesic/v1/mesh.pb.h"
#include "geodesic/v1/mesh_service.pb.h"
#include "server/engine/mesh_store.h"
#include "server/engine/query_engine.h"
#include "server/engine/upload_header.h"

namespace geodesic::server {

v1::Mesh ToProto(const ResidentMesh& mesh);
v1::Algorithm ToProto(Algorithm algorithm);
v1::FieldOrigin ToProto(FieldOrigin origin);
v1::FileDigest ToProto(const FileKey& file);
v1::SolveProgress ToProto(const Progress& progress);
v1::SolveStatistics ToProto(const SolveStatistics& statistics);

// Errors of these: INVALID_ARGUMENT naming `field`, the path of the value in
// the request.
absl::StatusOr<UploadFormat> FromProto(v1::MeshFormat format,
                                       std::string_view field);
absl::StatusOr<UploadHeader> FromProto(const v1::UploadHeader& header);
absl::StatusOr<Algorithm> FromProto(v1::Algorithm algorithm);
absl::StatusOr<FieldRequest> FromProto(const v1::ComputeFieldRequest& request);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_MESSAGE_TRANSLATION_H_
