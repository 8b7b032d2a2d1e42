// Points, sources and polylines <-> core's.

#ifndef GEODESIC_SERVER_RPC_MESSAGES_SURFACE_TRANSLATION_H_
#define GEODESIC_SERVER_RPC_MESSAGES_SURFACE_TRANSLATION_H_

#include <google/protobuf/repeated_ptr_field.h>

#include <cstdint>
#include <span>
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

// Puts the targets of a request into a query.
// Errors: also RESOURCE_EXHAUSTED when they are more than the limit.
absl::Status AddTargets(
    const google::protobuf::RepeatedPtrField<v1::SurfacePoint>& targets,
    const Limits& limits, Query& query);

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

void SetPoint(const Point& from, v1::Point& to);
void SetSurfacePoint(const SurfacePoint& from, v1::SurfacePoint& to);

// Replaces `piece` by the points from `first` on, as many as a message takes;
// returns where the next piece begins. A polyline without points has one empty
// piece.
uint64_t SetPiece(std::span<const SurfacePoint> points,
                  std::span<const Point> positions, uint64_t first,
                  v1::PolylinePiece& piece);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_MESSAGES_SURFACE_TRANSLATION_H_
