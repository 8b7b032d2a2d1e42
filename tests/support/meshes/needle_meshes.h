// Meshes of needles, faces far longer than they are high, beside faces of usual
// shapes.

#ifndef GEODESIC_TESTS_SUPPORT_MESHES_NEEDLE_MESHES_H_
#define GEODESIC_TESTS_SUPPORT_MESHES_NEEDLE_MESHES_H_

#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"
#include "geodesic/triangle_soup.h"
#include "tests/support/random.h"

namespace geodesic::test {

// A strip of two to five rows of faces. The first row and the last are about 1
// high; those between are 1e-10 to 1e-3 high, and as wide.
TriangleSoup NeedleRows(Random& random);

// Two to six pages along one spine, each of up to three rows of faces; a page
// may be 1e-12 to 1 high, lie on another, and have copies of all its faces.
TriangleSoup NeedleBook(Random& random);

// In a face, at a corner, or 1e-13 to 1e-4 away from one or from an edge.
SurfacePoint PointBesideCorner(const Mesh& mesh, Random& random);

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_MESHES_NEEDLE_MESHES_H_
