// Where a surface point lies, for the solver: the faces around it and its place
// in their frames.

#ifndef GEODESIC_SURFACE_SURFACE_LOCATION_H_
#define GEODESIC_SURFACE_SURFACE_LOCATION_H_

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"
#include "surface/plane_point.h"

namespace geodesic {

// The half-edges, one a face, that run along the edge between two vertices in
// either direction; none if there is no such edge. O(valence).
std::vector<HalfEdge> SidesOf(const Mesh& mesh, uint32_t from, uint32_t to);

// The point as weights in every face around it. O(valence).
std::vector<FacePoint> FacesAround(const Mesh& mesh, const SurfacePoint& point);

// The point as weights in `face`, if it lies there: at a corner, on a side or
// inside. O(1).
std::optional<FacePoint> WithinFace(const Mesh& mesh, const SurfacePoint& point,
                                    uint32_t face);

// The point in the frame of one of its face's half-edges, in the scaled unit.
PlanePoint InFrame(const Mesh& mesh, const FacePoint& point, HalfEdge h);

// Distance from the point straight to a corner of its face.
double DistanceToCorner(const Mesh& mesh, const FacePoint& point,
                        uint32_t corner);

}  // namespace geodesic

#endif  // GEODESIC_SURFACE_SURFACE_LOCATION_H_
