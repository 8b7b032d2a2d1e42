// Messages of geodesic.v1 <-> the plain types of the public headers.

#ifndef GEODESIC_CLIENT_TRANSLATE_H_
#define GEODESIC_CLIENT_TRANSLATE_H_

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "geodesic/v1/capabilities_service.pb.h"
#include "geodesic/v1/field_service.pb.h"
#include "geodesic/v1/mesh.pb.h"
#include "geodesic_client/capabilities.h"
#include "geodesic_client/field.h"
#include "geodesic_client/mesh.h"

namespace geodesic::client {

MeshInfo FromProto(const v1::Mesh& mesh);
FieldOrigin FromProto(v1::FieldOrigin origin);
FieldStatistics FromProto(const v1::SolveStatistics& statistics);
Capabilities FromProto(const v1::GetCapabilitiesResponse& response);

v1::MeshFormat ToProto(MeshFormat format);

// "fwp-ch" for ALGORITHM_FWP_CH: the name follows from the protocol's.
std::string AlgorithmName(v1::Algorithm algorithm);

// The inverse; ALGORITHM_UNSPECIFIED for an empty name.
// Errors: INVALID_ARGUMENT naming the name and those that are known.
absl::StatusOr<v1::Algorithm> AlgorithmFromName(std::string_view name);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_TRANSLATE_H_
