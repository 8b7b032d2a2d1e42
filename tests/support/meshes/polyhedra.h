// Convex polyhedra and the oracle for distances on them.

#ifndef GEODESIC_TESTS_SUPPORT_MESHES_POLYHEDRA_H_
#define GEODESIC_TESTS_SUPPORT_MESHES_POLYHEDRA_H_

#include <cstdint>
#include <string>
#include <vector>

#include "geodesic/triangle_soup.h"

namespace geodesic::test {

// Faces are convex polygons, counterclockwise seen from outside.
struct Polyhedron {
  std::string name;
  std::vector<Point> vertices;
  std::vector<std::vector<uint32_t>> faces;
};

Polyhedron Tetrahedron();
Polyhedron Octahedron();
Polyhedron Icosahedron();
Polyhedron Box(double a, double b, double c);

// Each face fanned from its first corner; vertices keep their numbers.
TriangleSoup Triangulate(const Polyhedron& polyhedron);

// Box(a, b, c) with each edge cut into na, nb or nc equal parts.
TriangleSoup BoxGrid(double a, double b, double c, uint32_t na, uint32_t nb,
                     uint32_t nc);

// The shortest distance on a convex polyhedron between two points of its
// surface, by unfolding every sequence of distinct faces: on a convex
// polyhedron a shortest path enters a face once and avoids the vertices.
double DistanceOnConvex(const Polyhedron& polyhedron, const Point& p,
                        const Point& q);

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_MESHES_POLYHEDRA_H_
