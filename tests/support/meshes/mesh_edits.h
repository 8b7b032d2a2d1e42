// Ways to make another mesh of a mesh.

#ifndef GEODESIC_TESTS_SUPPORT_MESHES_MESH_EDITS_H_
#define GEODESIC_TESTS_SUPPORT_MESHES_MESH_EDITS_H_

#include <cstdint>
#include <vector>

#include "geodesic/surface_point.h"
#include "geodesic/triangle_soup.h"

namespace geodesic::test {

// The same surface with finer faces. The old vertices keep their numbers.

// Each face becomes four.
TriangleSoup SubdivideAtMidpoints(const TriangleSoup& soup);
// `count` times a face, drawn at random, becomes three around a point inside.
TriangleSoup SplitFaces(TriangleSoup soup, uint32_t count, uint64_t seed);
// As SplitFaces, with the new point within 1e-6 of an edge or a corner.
TriangleSoup InsertNeedles(TriangleSoup soup, uint32_t count, uint64_t seed);
// `count` times a point goes onto an edge between two faces, drawn at random:
// one of the two is cut in two, and a face without area fills the gap.
TriangleSoup InsertZeroAreaFaces(TriangleSoup soup, uint32_t count,
                                 uint64_t seed);
// `count` times a vertex inside the surface, drawn at random, gets a double at
// the same place (numbered last), an edge without length to it and two faces
// without area beside that edge. `doubled` is told which.
TriangleSoup DoubleVertices(TriangleSoup soup, uint32_t count, uint64_t seed,
                            std::vector<uint32_t>* doubled = nullptr);

// Another surface on the same vertices: `count` times an edge between two
// faces, drawn at random, is turned to the other diagonal, where that is not
// an edge already.
TriangleSoup FlipEdges(TriangleSoup soup, uint32_t count, uint64_t seed);

// The same surface elsewhere, in another order or at another size.

struct Relabelled {
  TriangleSoup soup;
  std::vector<uint32_t> new_number;  // of each old vertex
};
// Shuffles vertices and faces and turns each face's corners.
Relabelled Relabel(const TriangleSoup& soup, uint64_t seed);
// Turns about half of the faces over: their corners run the other way.
TriangleSoup TurnFaces(TriangleSoup soup, uint64_t seed);
// Gives every face again, turned over; the second ones come last.
TriangleSoup AddBackFaces(TriangleSoup soup);

TriangleSoup RotateAndShift(TriangleSoup soup, uint64_t seed);
TriangleSoup Scale(TriangleSoup soup, double factor);

// Both, not connected; the vertices of `b` come last.
TriangleSoup Join(TriangleSoup a, const TriangleSoup& b);
// `pages` copies, turned about the y axis in equal steps. They share their
// vertices at x = 0: a spine where all of them meet. The first page's vertices
// keep their numbers. REQUIRES: the page lies in the plane z = 0.
TriangleSoup Book(const TriangleSoup& page, uint32_t pages);
// With another sheet over some `count` faces that hang together at vertices,
// drawn at random: `lift` edges away at the most, and where it is 0 at the same
// place. Where the sheet ends it shares vertices and edges with the rest; its
// own vertices come last.
TriangleSoup AddLayer(TriangleSoup soup, uint32_t count, double lift,
                      uint64_t seed);
// With `count` more vertices that no face uses.
TriangleSoup AddIsolatedVertices(TriangleSoup soup, uint32_t count);

// Solids and sheets of every kind, edited at random; up to some hundred faces.
// Turned edges of flat parts give faces folded over. `degenerate` ones have
// faces without area and coincident vertices too.
TriangleSoup EditedMesh(uint64_t seed, bool degenerate);

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_MESHES_MESH_EDITS_H_
