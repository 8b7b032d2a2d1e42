// Places, as geodesic/v1/surface.proto has them.

#ifndef GEODESIC_CODEC_PLACES_H_
#define GEODESIC_CODEC_PLACES_H_

#include <google/protobuf/repeated_ptr_field.h>

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/v1/surface.pb.h"
#include "geodesic_types/places.h"

namespace geodesic::codec {

// Errors of these: INVALID_ARGUMENT naming `field`, which is the value's path
// in the message, or a part of it (geodesic_types/field_path.h): no place; a
// number beyond 32 bits; other than three weights. That the place is on a mesh
// is not checked.
absl::StatusOr<SurfacePoint> FromProto(const v1::SurfacePoint& point,
                                       const std::string& field);
absl::StatusOr<std::vector<SurfacePoint>> FromProto(
    const google::protobuf::RepeatedPtrField<v1::SurfacePoint>& points,
    const std::string& field);
absl::StatusOr<Source> FromProto(const v1::Source& source,
                                 const std::string& field);

v1::SurfacePoint ToProto(const SurfacePoint& point);
v1::Source ToProto(const Source& source);

}  // namespace geodesic::codec

#endif  // GEODESIC_CODEC_PLACES_H_
