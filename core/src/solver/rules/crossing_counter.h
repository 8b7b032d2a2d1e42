// How often windows cross the same half-edge.

#ifndef GEODESIC_SOLVER_RULES_CROSSING_COUNTER_H_
#define GEODESIC_SOLVER_RULES_CROSSING_COUNTER_H_

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geodesic/mesh.h"

namespace geodesic {

// Where half-edges are crossed so often, windows are suspected of going round
// and round (winding.h).
inline constexpr uint32_t kManyCrossings = 64;

// So many crossings are counted.
inline constexpr uint32_t kMostCrossings = 1 << 26;

// After so many nothing crosses a half-edge any more, so that every computation
// ends: what still comes goes round for certain. The wavefront of an anchor
// comes to a half-edge some few times, or about as often as a vertex has faces
// around which it goes.
inline uint32_t MostCrossings(const Mesh& mesh, uint64_t anchors) {
  constexpr uint64_t kFew = 1024;
  return static_cast<uint32_t>(std::min<uint64_t>(
      kFew + 4 * (mesh.face_count() + anchors), kMostCrossings));
}

// Counts them only once there have been more in all than there should be, so
// that nothing is paid where no window winds.
class CrossingCounter {
 public:
  explicit CrossingCounter(uint32_t half_edges) : half_edges_(half_edges) {}

  // One more, at h; so many vertices have been reached. Returns how often h has
  // been crossed since there are too many.
  uint32_t Count(HalfEdge h, uint64_t reached) {
    if (++crossings_ <= kFew + kByVertex * reached) return 1;
    if (counts_.empty()) counts_.resize(half_edges_);
    counts_[h] += counts_[h] < kMostCrossings;
    return counts_[h];
  }
  bool IsMany(HalfEdge h) const {
    return !counts_.empty() && counts_[h] >= kManyCrossings;
  }

  uint64_t bytes() const { return counts_.capacity() * sizeof(uint32_t); }

 private:
  // On real meshes lists cross 3 to 4 half-edges for each vertex.
  static constexpr uint64_t kByVertex = 12;
  static constexpr uint64_t kFew = 4096;

  uint32_t half_edges_;
  uint64_t crossings_ = 0;
  // By half-edge; empty until there are too many.
  std::vector<uint32_t> counts_;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_CROSSING_COUNTER_H_
