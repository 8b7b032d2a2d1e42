// Triangles as they come from a file or a client, before anything about their
// topology is known.

#ifndef GEODESIC_TRIANGLE_SOUP_H_
#define GEODESIC_TRIANGLE_SOUP_H_

#include <array>
#include <cstdint>
#include <vector>

#include "geodesic_types/places.h"

namespace geodesic {

// Three vertex indices, 0-based.
using Triangle = std::array<uint32_t, 3>;

// A vertex that a file repeats, and the vertex whose place it takes.
struct JoinedVertex {
  uint32_t vertex = 0;
  uint32_t into = 0;  // below `vertex`, and itself joined into none

  friend bool operator==(const JoinedVertex&, const JoinedVertex&) = default;
};

// What was joined or guessed when faces became triangles. It is part of a
// mesh's identity.
struct Reading {
  // In order of `vertex`. Triangles go on naming what the file names; a mesh
  // takes the vertex that it was joined into, and gives both the same answers.
  std::vector<JoinedVertex> joined;
  // Edges along which faces meet that the file keeps apart.
  uint64_t seam_edges = 0;
  // Polygons that cross themselves, or turn back so that they have no inside:
  // these are fans from their first corners, which cover other places or some
  // of them twice. And the number of the first of them among the polygons of
  // the file, triangles included, from 0.
  uint64_t crossing_polygons = 0;
  uint64_t first_crossing_polygon = 0;

  bool is_plain() const { return *this == Reading(); }
  friend bool operator==(const Reading&, const Reading&) = default;
};

// Vertices keep the order of the file. The k - 2 triangles of a polygon with k
// corners stand in the polygon's place and cover it once, turned as it is: if
// it is convex fanned from its first corner, else cut along short diagonals,
// the same whichever corner comes first. What bends in space is looked at along
// the sum of its triangles' normals. A corner that a polygon names twice in a
// row makes a triangle that names it twice. Nothing is checked beyond what the
// reader promises (see read_mesh.h).
struct TriangleSoup {
  std::vector<Point> positions;
  std::vector<Triangle> triangles;
  Reading reading = {};
  // Whether the positions were computed in single precision; those that single
  // precision can hold are taken to be.
  bool is_single_precision = false;
};

// Whether a triangle names a vertex twice. It has no place in a surface: a mesh
// leaves it out, and counts it.
inline bool RepeatsVertex(const Triangle& triangle) {
  return triangle[0] == triangle[1] || triangle[1] == triangle[2] ||
         triangle[2] == triangle[0];
}

}  // namespace geodesic

#endif  // GEODESIC_TRIANGLE_SOUP_H_
