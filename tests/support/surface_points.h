// Points anywhere on a surface, for the oracles: worked out apart from the
// solver's own surface_point.h, which is under test, but for the types.

#ifndef GEODESIC_TESTS_SUPPORT_SURFACE_POINTS_H_
#define GEODESIC_TESTS_SUPPORT_SURFACE_POINTS_H_

#include <cstdint>
#include <string>
#include <vector>

#include "geodesic/query.h"
#include "geodesic/surface_point.h"
#include "geodesic/triangle_soup.h"
#include "tests/support/random.h"
#include "tests/support/vec.h"

namespace geodesic::test {

// The point in each face around it, with weights that sum to 1.
struct Place {
  uint32_t face = 0;
  Real weights[3] = {0, 0, 0};
};
std::vector<Place> PlacesOf(const TriangleSoup& soup,
                            const SurfacePoint& point);

bool HaveCommonFace(const TriangleSoup& soup, const SurfacePoint& a,
                    const SurfacePoint& b);

// In words, for messages.
std::string Name(const SurfacePoint& point);
std::string Name(const Source& source);

Vec3 PositionIn(const TriangleSoup& soup, const SurfacePoint& point);

// The same surface with the point as a vertex, which `vertex` names: the faces
// around it are cut up in their own planes. Old vertices keep their numbers.
struct Inserted {
  TriangleSoup soup;
  uint32_t vertex = 0;
};
Inserted InsertPoint(TriangleSoup soup, const SurfacePoint& point);

// Points at random, well inside a face or an edge.
SurfacePoint RandomFacePoint(const TriangleSoup& soup, Random& random);
SurfacePoint RandomEdgePoint(const TriangleSoup& soup, Random& random);
// A vertex that has a face.
SurfacePoint RandomVertexPoint(const TriangleSoup& soup, Random& random);
// A point in a face, `distance` (as a weight) away from an edge or a corner of
// it, or on an edge so near its end.
SurfacePoint RandomPointNearby(const TriangleSoup& soup, double distance,
                               Random& random);
// Points in the faces around these vertices, `weight` away from them.
std::vector<SurfacePoint> PointsBeside(const TriangleSoup& soup,
                                       const std::vector<uint32_t>& vertices,
                                       double weight);
// Any of the random ones.
SurfacePoint RandomSurfacePoint(const TriangleSoup& soup, Random& random);
// What lies beside a point: itself, the corners of one of its faces, and a
// point of that face, mostly very near.
std::vector<SurfacePoint> RandomNeighbours(const TriangleSoup& soup,
                                           const SurfacePoint& point,
                                           Random& random);

// A polyline of up to `most` points, each in a common face with the one before.
std::vector<SurfacePoint> RandomCurve(const TriangleSoup& soup, uint32_t most,
                                      Random& random);

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_SURFACE_POINTS_H_
