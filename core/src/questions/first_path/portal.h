// Where a strip of faces, laid into the plane, goes from one to the next.

#ifndef GEODESIC_QUESTIONS_FIRST_PATH_PORTAL_H_
#define GEODESIC_QUESTIONS_FIRST_PATH_PORTAL_H_

#include <cstdint>

#include "geodesic/mesh.h"
#include "surface/plane_point.h"

namespace geodesic {

// A half-edge through which a strip enters a face. Seen on the way its begin
// lies on the left and its end on the right. What laying it out takes is kept
// here: a path is drawn taut through the same faces many times.
struct Portal {
  HalfEdge half_edge = kNoHalfEdge;
  // Whether the end that it does not share with the portal before is the left.
  bool tip_is_left = false;
  double length = 0;
  // How it is turned against the portal before: cosine and sine.
  PlanePoint turn = {1, 0};

  // The first of a strip.
  static Portal First(const Mesh& mesh, HalfEdge h) {
    return {.half_edge = h, .length = mesh.frame(h).length};
  }
  // REQUIRES: h is the twin of a side of the face of `before`, another one.
  static Portal After(const Mesh& mesh, HalfEdge before, HalfEdge h) {
    const HalfEdgeFrame& frame = mesh.frame(before);
    const bool turns_left = frame.left_exit == h;
    return {.half_edge = h,
            .tip_is_left = !turns_left,
            .length = mesh.frame(h).length,
            .turn = turns_left ? PlanePoint{frame.left_x, frame.left_y}
                               : PlanePoint{-frame.right_x, -frame.right_y}};
  }
};

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_FIRST_PATH_PORTAL_H_
