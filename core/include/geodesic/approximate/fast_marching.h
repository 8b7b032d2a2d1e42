// Fast marching: vertices are accepted in the order of their distances, and
// each hands a planar front on through the faces around it.
//
//   auto marching = FastMarching::Prepare(*mesh, MarchingQueue::kHeap,
//                                         checkpoint);
//   absl::StatusOr<ApproximateField> field =
//       (*marching)->Distances(query, checkpoint);
//
// Kimmel, Sethian: Computing geodesic paths on manifolds. PNAS 95(15), 1998.
// Yatziv, Bartesaghi, Sapiro: O(N) implementation of the fast marching
// algorithm. Journal of Computational Physics 212(2), 2006: the untidy queue.

#ifndef GEODESIC_APPROXIMATE_FAST_MARCHING_H_
#define GEODESIC_APPROXIMATE_FAST_MARCHING_H_

#include <cstdint>
#include <memory>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/approximate/prepared_method.h"
#include "geodesic/mesh.h"

namespace geodesic {

// Which vertex is next.
enum class MarchingQueue {
  kHeap,    // fmm: always the nearest vertex next
  kUntidy,  // fmm-untidy: first in, first out within a bucket
};

// Guarantees:
//   1. planar fronts stay what they are: where distances are linear on a plane
//      and no angle is obtuse, they are exact up to rounding;
//   2. elsewhere the error is of first order in the length of edges (of order
//      h log h around a source), far more where edges are of unequal length;
//   3. +infinity exactly where no path leads.
//
// Any mesh will do. An obtuse angle is split by a vertex beyond the opposite
// edge, which is found by unfolding (Kimmel, Sethian, section 4.2); one that
// cannot be split, since a boundary or an irregular edge is in the way, is used
// as it is.
//
// Sources are points, with offsets; one that is no vertex starts from the
// corners around it.
class FastMarching final : public PreparedMethod {
 public:
  // Splits the obtuse angles. O(F).
  // Errors: whatever `checkpoint` returns.
  static absl::StatusOr<std::shared_ptr<const FastMarching>> Prepare(
      const Mesh& mesh, MarchingQueue queue, Checkpoint& checkpoint);

  ApproximateMethod method() const override;
  uint64_t bytes() const override;

 private:
  // O(n log n), with the untidy queue O(n).
  absl::StatusOr<std::vector<double>> Compute(
      const ValidQuery& query, Checkpoint& checkpoint) const override;

  class March;

  // A triangle that an obtuse angle was split into: its corner, and two
  // vertices that support a front which comes there. In the plane, with the
  // first support at (0, 0), the second at (length, 0) and the corner at (x,
  // y), y >= 0.
  struct Split {
    uint32_t corner;
    uint32_t supports[2];
    double length, x, y;
  };

  FastMarching(const Mesh& mesh, MarchingQueue queue);
  // Splits the angle at the apex of h if it is obtuse and can be.
  void SplitAngle(HalfEdge h);
  void ListSplits();

  const MarchingQueue queue_;
  std::vector<bool> is_split_;  // by half-edge: the angle opposite
  std::vector<Split> splits_;
  std::vector<uint32_t> splits_begin_;  // by vertex + 1; empty without splits
  std::vector<uint32_t> splits_at_;     // numbers of splits, by support
};

}  // namespace geodesic

#endif  // GEODESIC_APPROXIMATE_FAST_MARCHING_H_
