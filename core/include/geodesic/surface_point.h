// What is known of places on a mesh (geodesic_types/places.h).

#ifndef GEODESIC_SURFACE_POINT_H_
#define GEODESIC_SURFACE_POINT_H_

#include <cstdint>
#include <string>

#include "absl/status/status.h"
#include "geodesic/mesh.h"
#include "geodesic_types/places.h"

namespace geodesic {

// `path` is the point's path in messages, e.g. "targets[2]".
// Errors: INVALID_ARGUMENT for an index out of range, an edge that is not in
// the mesh, t outside [0, 1], a weight that is negative or not finite, or
// weights that do not sum to 1. The status carries the path of what is wrong
// (field_path.h) and its message begins with it, e.g. "targets[2].face.face 99
// is out of range: the mesh has 12 faces, numbered from 0".
absl::Status Validate(const SurfacePoint& point, const Mesh& mesh,
                      const std::string& path);

// The same point in one fixed form. It is on the lowest element that holds it:
// a weight or t of 0, or below 1e-18, leads to an edge or a vertex. Edges run
// from the lower vertex to the higher, weights sum to 1, and a vertex that was
// joined into another one (mesh.h) is that one.
// REQUIRES: Validate(point, mesh, "").ok().
SurfacePoint Canonicalize(const SurfacePoint& point, const Mesh& mesh);

// A point of an edge of `face`, by the numbers that the face's corners had
// before any were joined (Mesh::NamedTriangle); other points stay as they are.
SurfacePoint NamedIn(uint32_t face, const SurfacePoint& point,
                     const Mesh& mesh);

// Where the point lies in space, in the unit of the mesh's file.
// REQUIRES: Validate(point, mesh, "").ok().
Point PositionOf(const SurfacePoint& point, const Mesh& mesh);

}  // namespace geodesic

#endif  // GEODESIC_SURFACE_POINT_H_
