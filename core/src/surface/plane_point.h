// A place in the plane of a face.

#ifndef GEODESIC_SURFACE_PLANE_POINT_H_
#define GEODESIC_SURFACE_PLANE_POINT_H_

namespace geodesic {

// In the frame of one of the face's half-edges (Mesh::frame), in the mesh's
// scaled unit.
struct PlanePoint {
  double x = 0;
  double y = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_SURFACE_PLANE_POINT_H_
