// Lower bounds on the rest of the way to a target that are nearly exact: what
// merged windows (docs/algorithm.md, 22) find from the target back to the
// source.

#ifndef GEODESIC_QUESTIONS_BACKWARD_BOUNDS_H_
#define GEODESIC_QUESTIONS_BACKWARD_BOUNDS_H_

#include <cstdint>
#include <vector>

#include "absl/functional/function_ref.h"
#include "absl/status/status.h"
#include "geodesic/landmarks.h"
#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"
#include "solver/accuracy.h"
#include "solver/goal.h"
#include "solver/queues/fwp_buckets.h"
#include "solver/rules/front.h"
#include "solver/rules/hub.h"
#include "solver/rules/merging_rule.h"
#include "solver/windows/window.h"

namespace geodesic {

// Two places, and the longest paths between them that matter, in the scaled
// unit.
struct BoundedWay {
  SurfacePoint source, target;
  double longest = 0;
};

// Keeps its memory from one way to the next. For one thread.
class BackwardBounds {
 public:
  // Whether windows may be merged on this mesh, and miss no vertex.
  static bool Serve(const Mesh& mesh) {
    return !mesh.HasThinFaces() && !mesh.HasCollapsedFaces() &&
           !mesh.HasNonManifoldEdges();
  }

  // O(V + F) time and memory. The mesh outlives it. REQUIRES: Serve(mesh).
  explicit BackwardBounds(const Mesh& mesh);

  // Covers all that lies on paths from the source to the target that are no
  // longer than `longest`, if there are any. Polls now and then; errors:
  // whatever that returns. `landmarks` may be null; they outlive the bounds.
  absl::Status Find(const BoundedWay& way, const Landmarks* landmarks,
                    absl::FunctionRef<absl::Status()> poll);

  // Whether there are bounds: not if windows went round and round.
  bool has_bounds() const { return has_bounds_; }
  // No path from vertex v to the target is shorter. REQUIRES: has_bounds().
  double Bound(uint32_t v) const;
  // No shortest path from the source to the target is shorter; REQUIRES:
  // has_bounds().
  double shortest() const;
  // Nor is it longer. Infinite if none within `longest` was found.
  double longest() const { return longest_; }

  uint64_t windows() const { return windows_; }
  uint64_t bytes() const {
    return queue_.bytes() + front_.bytes() + front_.goal().bytes() +
           rule_.bytes() + hubs_.bytes();
  }

  // What it holds for each vertex and half-edge of a mesh.
  static constexpr uint64_t kBytesByVertex =
      2 * sizeof(double) + 1 + sizeof(IncomingRay) + sizeof(float);
  static constexpr uint64_t kBytesByHalfEdge = sizeof(uint32_t);

 private:
  // The distance of the source, as far as it was found.
  double FoundAtSource() const;

  using MergingFront = Front<FwpBuckets, Origin, Goal, WithinTolerance>;

  FwpBuckets queue_;
  MergingFront front_;
  MergingRule<MergingFront> rule_;
  Hubs<MergingFront, MergingRule<MergingFront>> hubs_;
  double covered_ = 0;  // the largest key that was propagated
  double longest_ = 0;
  bool has_bounds_ = false;
  uint64_t windows_ = 0;
  std::vector<uint32_t> together_;
};

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_BACKWARD_BOUNDS_H_
