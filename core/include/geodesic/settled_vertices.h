// The certified frontier as a list of vertices, for streaming a field while it
// is computed.

#ifndef GEODESIC_SETTLED_VERTICES_H_
#define GEODESIC_SETTLED_VERTICES_H_

#include <cstdint>
#include <vector>

#include "geodesic/checkpoint.h"

namespace geodesic {

struct SettledVertex {
  uint32_t vertex = 0;
  double distance = 0;  // in the unit of the file; final
};

// Gives out every vertex once, in order of distance (of number at a tie), up to
// rounding between calls.
class SettledVertices {
 public:
  // The vertices that have become final since the last call; none before the
  // wavefront has moved. O(V).
  std::vector<SettledVertex> Collect(const Progress& progress);

 private:
  // By radius alone a vertex would be lost whose distance improves by a
  // rounding just as the radius passes it.
  std::vector<bool> given_;
};

}  // namespace geodesic

#endif  // GEODESIC_SETTLED_VERTICES_H_
