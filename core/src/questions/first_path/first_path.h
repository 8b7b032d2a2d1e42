// A path to a target that is close to shortest, found before any window is.

#ifndef GEODESIC_QUESTIONS_FIRST_PATH_FIRST_PATH_H_
#define GEODESIC_QUESTIONS_FIRST_PATH_FIRST_PATH_H_

#include <cstdint>
#include <span>
#include <vector>

#include "absl/functional/function_ref.h"
#include "absl/status/status.h"
#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"
#include "questions/first_path/route_search.h"
#include "questions/first_path/taut_path.h"
#include "solver/goal.h"
#include "surface/anchors.h"

namespace geodesic {

// Keeps its memory from one question to the next. For one thread.
class FirstPath {
 public:
  // What it holds for each vertex of the mesh.
  static constexpr uint64_t kBytesByVertex = RouteSearch::kBytesByVertex;

  // O(V) time and memory. The mesh outlives it.
  explicit FirstPath(const Mesh& mesh)
      : mesh_(mesh), routes_(mesh), path_(mesh) {}

  // Finds a locally shortest path from one of the anchors to a target, at which
  // the goal is aimed. Polls now and then; errors: whatever that returns.
  // REQUIRES: the anchors are points.
  absl::Status Find(std::span<const Anchor> anchors, const SurfacePoint& target,
                    const Goal& goal, absl::FunctionRef<absl::Status()> poll);

  // Of the path, with the offset of its source, in the scaled unit. No shortest
  // path is longer, but for rounding. Infinite if none was found.
  double length() const { return length_; }
  // Whether there is no path at all.
  bool shows_none() const { return !route_.exists; }
  // Where it bends, from its source on. The rest of the path, from a bend to
  // the target, is Rest(bend) long.
  std::span<const TautPath::Bend> bends() const { return path_.bends(); }
  double Rest(const TautPath::Bend& bend) const {
    return path_.length() - bend.before;
  }

  uint64_t bytes() const { return routes_.bytes() + path_.bytes(); }

 private:
  const Mesh& mesh_;
  RouteSearch routes_;
  TautPath path_;
  double length_ = 0;

  // Scratch.
  std::vector<RouteStart> starts_;
  Route route_;
};

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_FIRST_PATH_FIRST_PATH_H_
