// Questions about fields and their answers <-> the protocol's messages.

#ifndef GEODESIC_SERVER_RPC_MESSAGES_FIELD_TRANSLATION_H_
#define GEODESIC_SERVER_RPC_MESSAGES_FIELD_TRANSLATION_H_

#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/distance_field.h"
#include "geodesic/v1/field_service.pb.h"
#include "geodesic/v1/query.pb.h"
#include "server/engine/base/limits.h"
#include "server/engine/fields/field_engine.h"
#include "server/engine/meshes/mesh_store.h"

namespace geodesic::server {

// What geodesic::Solve guarantees (solve.h).
inline constexpr double kRelativeTolerance = 1e-10;

v1::Algorithm ToProto(Algorithm algorithm);
v1::FieldOrigin ToProto(FieldOrigin origin);
v1::SolveProgress ToProto(const Progress& progress);
v1::SolveStatistics ToProto(const SolveStatistics& statistics);
v1::AnswerHeader MakeHeader(const ResidentMesh& mesh, Algorithm algorithm,
                            const std::string& version);

// INVALID_ARGUMENT: this field of a request has a number that its enumeration
// does not.
absl::Status Unknown(const std::string& field, int number);

// Errors of these: INVALID_ARGUMENT naming the part of the request at fault.
absl::StatusOr<Algorithm> FromProto(v1::Algorithm algorithm);
// Never unspecified.
absl::StatusOr<v1::ValueType> ResolveValueType(v1::ValueType type);
absl::StatusOr<bool> IsBatch(v1::Priority priority);
// Adds to `question` what only a field's request says.
// Errors: also RESOURCE_EXHAUSTED for counts beyond the limits.
absl::Status Translate(const v1::ComputeFieldRequest& request,
                       const Limits& limits, FieldRequest& question);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_MESSAGES_FIELD_TRANSLATION_H_
