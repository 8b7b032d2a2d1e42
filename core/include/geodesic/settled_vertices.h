// Lists vertices as their distances become final, for streaming a field while
// it is computed.

#ifndef GEODESIC_SETTLED_VERTICES_H_
#define GEODESIC_SETTLED_VERTICES_H_

#include <cstdint>
#include <vector>

#include "geodesic/checkpoint.h"
#include "geodesic/mesh.h"

namespace geodesic {

// A vertex whose distance is final.
struct SettledVertex {
  uint32_t vertex = 0;
  double distance = 0;  // in the unit of the file; final
};

// Returns every vertex once, ordered by distance and at a tie by number;
// between calls the order holds up to rounding. Not thread-safe.
class SettledVertices {
 public:
  // Of a field on `mesh`, which must outlive it.
  explicit SettledVertices(const Mesh& mesh) : mesh_(&mesh) {}

  // The vertices that have become final since the last call; none before the
  // wavefront has moved. O(V).
  std::vector<SettledVertex> Collect(const Progress& progress);

 private:
  const Mesh* mesh_;
  // The radius alone would miss a vertex whose distance improves by a rounding
  // just as the radius passes it.
  std::vector<bool> given_;
};

}  // namespace geodesic

#endif  // GEODESIC_SETTLED_VERTICES_H_
