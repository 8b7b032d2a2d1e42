// Fewer faces for drawing, over the same vertices.
//
//   NoCheckpoint checkpoint;
//   absl::StatusOr<std::vector<Triangle>> coarse =
//       Decimate(*mesh, 200'000, checkpoint);
//   // Draw *coarse with mesh->positions() and anything else that is known of
//   // the vertices: distances at those that remain are as exact as before.

#ifndef GEODESIC_DECIMATE_H_
#define GEODESIC_DECIMATE_H_

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/mesh.h"
#include "geodesic/triangle_soup.h"

namespace geodesic {

// Collapses half-edges of least quadric error until at most `max_faces` faces
// are left, or as few as it gets: a collapse that breaks one of the guarantees
// is not made. A mesh that has no more faces is given back as it is.
//
// Guarantees:
//   1. vertices stay where they are and keep their numbers; none is added;
//   2. components, their holes and handles stay: no face is left alone that was
//      not, and no edge comes to have more faces or fewer;
//   3. boundaries move by less than a thousandth of the bounding box's
//      diagonal;
//   4. no face turns by a right angle in a collapse, or loses its area;
//   5. vertices that are not manifold, at edges along which faces disagree in
//      orientation, or of more than 24 faces stay;
//   6. the same mesh gives the same triangles in the same order, that of the
//      faces they come from.
//
// Vertices are left without a face, so this is no mesh to measure on.
//
// O(V + F) time a pass, a third of the vertices at most, so O(V + F) in all
// while collapses are legal; and EstimateDecimateBytes of memory. `checkpoint`
// is told nothing but that the work goes on.
// Errors: INVALID_ARGUMENT if `max_faces` is 0; whatever `checkpoint` returns.
// Thread-safe.
absl::StatusOr<std::vector<Triangle>> Decimate(const Mesh& mesh,
                                               uint64_t max_faces,
                                               Checkpoint& checkpoint);

// An upper bound on the memory that Decimate takes beside the mesh.
uint64_t EstimateDecimateBytes(const Mesh& mesh);

}  // namespace geodesic

#endif  // GEODESIC_DECIMATE_H_
