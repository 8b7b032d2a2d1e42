// Points and sources of requests <-> core's.

#ifndef GEODESIC_SERVER_RPC_MESSAGES_SURFACE_TRANSLATION_H_
#define GEODESIC_SERVER_RPC_MESSAGES_SURFACE_TRANSLATION_H_

#include <google/protobuf/repeated_ptr_field.h>

#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/query.h"
#include "geodesic/surface_point.h"
#include "geodesic/v1/surface.pb.h"
#include "server/engine/base/limits.h"

namespace geodesic::server {

// Errors of these: INVALID_ARGUMENT naming `field`, the path of the value in
// the request, or a part of it: no place; a number beyond 32 bits; other than
// three weights. Whether the place is on a mesh is for the engine to judge.
absl::StatusOr<SurfacePoint> FromProto(const v1::SurfacePoint& point,
                                       const std::string& field);
absl::StatusOr<std::vector<SurfacePoint>> FromProto(
    const google::protobuf::RepeatedPtrField<v1::SurfacePoint>& points,
    const std::string& field);

// The targets of a request.
// Errors: also RESOURCE_EXHAUSTED when they are more than the limit.
absl::StatusOr<std::vector<SurfacePoint>> TargetsFromProto(
    const google::protobuf::RepeatedPtrField<v1::SurfacePoint>& targets,
    const Limits& limits);

// Puts the sources of a request into a query.
// Errors: also RESOURCE_EXHAUSTED when they are more than the limit, or their
// curves have more points than the limit.
absl::Status AddSources(
    const google::protobuf::RepeatedPtrField<v1::Source>& sources,
    const Limits& limits, Query& query);

// The same for sources that are rows of a matrix.
absl::Status AddRows(
    const google::protobuf::RepeatedPtrField<v1::Source>& sources,
    const Limits& limits, Query& query);

void SetSurfacePoint(const SurfacePoint& from, v1::SurfacePoint& to);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_MESSAGES_SURFACE_TRANSLATION_H_
