// Looks for places on a mesh, by trying every face.

#ifndef GEODESIC_CLIENT_PLACES_NEAREST_POINT_H_
#define GEODESIC_CLIENT_PLACES_NEAREST_POINT_H_

#include "absl/status/statusor.h"
#include "client/places/written_place.h"
#include "geodesic_client/mesh.h"
#include "geodesic_types/places.h"

namespace geodesic::client {

// The point of the faces that is nearest to `wanted.to`, a vertex or a point of
// an edge where it is one. Of several it is the one in the face with the lowest
// number. Faces without area count as the edges they are. Exact up to rounding,
// whatever the unit; if the mesh is smaller than the last digit of its distance
// from `wanted.to`, all its points are equally near. Linear in the faces.
//
// Errors: INVALID_ARGUMENT if the mesh has no faces. Thread-safe.
absl::StatusOr<SurfacePoint> FindOnMesh(const MeshArrays& mesh,
                                        const NearestPoint& wanted);

// The vertex with the least or greatest coordinate of those that a face has, of
// several the one with the lowest number. Linear in the faces.
//
// Errors: INVALID_ARGUMENT if the mesh has no faces. Thread-safe.
absl::StatusOr<SurfacePoint> FindOnMesh(const MeshArrays& mesh,
                                        const ExtremeVertex& wanted);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PLACES_NEAREST_POINT_H_
