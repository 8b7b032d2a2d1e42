// Meshes where very many faces meet at one place: what is done there once for
// each of them must not be done for each pair of them.

#ifndef GEODESIC_TESTS_SUPPORT_MESHES_CROWDED_MESHES_H_
#define GEODESIC_TESTS_SUPPORT_MESHES_CROWDED_MESHES_H_

#include <cstdint>

#include "geodesic/triangle_soup.h"

namespace geodesic::test {

// `count` triangles around the edge between vertices 0 and 1; vertex i + 2 is
// the corner of number i.
TriangleSoup Pages(uint32_t count);

// A flat disc of `count` triangles around vertex 0.
TriangleSoup NeedleFan(uint32_t count);

// The same triangles, all vertices at one place.
TriangleSoup FanInOnePoint(uint32_t count);

// A strip of `count` squares, each cut in two by the diagonal, with another
// triangle upright on each diagonal and on each side between two squares: paths
// along it cross edges of three faces only.
TriangleSoup FinnedStrip(uint32_t count);

// All triangles of `count` points that are nearly in line: each edge has
// count - 2 faces.
TriangleSoup AllTriangles(uint32_t count);

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_MESHES_CROWDED_MESHES_H_
