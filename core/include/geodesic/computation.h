// A computation that can stop early and go on later.
//
//   absl::StatusOr<std::unique_ptr<Computation>> computation =
//       StartComputation(mesh, query, {});
//   absl::Status status = (*computation)->Advance({.radius = 10}, checkpoint);
//   DistanceField near = (*computation)->Field();   // exact up to 10
//   status = (*computation)->Advance({.radius = 20}, checkpoint);  // goes on

#ifndef GEODESIC_COMPUTATION_H_
#define GEODESIC_COMPUTATION_H_

#include <cstdint>
#include <limits>
#include <memory>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "geodesic/solve_options.h"
#include "geodesic/valid_query.h"

namespace geodesic {

// A computation may stop as soon as one of these conditions holds.
struct Reach {
  // Every distance up to here is certified (with a tolerance, to within it); in
  // the unit of the mesh's file.
  double radius = std::numeric_limits<double>::infinity();
  // This many of the query's targets (vertices included) are certified.
  // DEFAULT: never stop because of targets.
  uint64_t targets = std::numeric_limits<uint64_t>::max();
};

// Of a question that names its radius. Errors: INVALID_ARGUMENT with the path
// "radius" (field_path.h) if it is negative or NaN.
absl::Status CheckRadius(double radius);

// Not thread-safe. It has threads of its own (SolveOptions::threads) only
// during Advance. It holds the wavefront and the distances between calls. The
// mesh must outlive it.
class Computation {
 public:
  virtual ~Computation() = default;

  // Propagates until `reach` is reached or nothing is left. The cost grows with
  // the surface covered.
  // Errors: INVALID_ARGUMENT for a radius that is negative or NaN; whatever
  // `checkpoint` returns. After an error Field() is still valid and Advance may
  // go on.
  virtual absl::Status Advance(const Reach& reach, Checkpoint& checkpoint) = 0;

  // What is certified now; distances beyond settled_radius are +infinity, of
  // those within a tolerance the least that they may be. If Advance stopped at
  // a radius, settled_radius is that radius, and nothing is given beyond. O(V).
  virtual DistanceField Field() const = 0;

  // Adds a source, which must be a point, to a computation that has come to its
  // end; the next Advance starts from it. Nothing is certified any more, but
  // distances can only become smaller. The source's number follows those of the
  // query's sources.
  // Errors: INVALID_ARGUMENT as ValidQuery::Make, or for a curve;
  // FAILED_PRECONDITION if the last Advance has left something to do, or if the
  // query asked for a trace.
  virtual absl::Status AddSource(const Source& source) = 0;

  // Bytes held beside the mesh.
  virtual uint64_t bytes() const = 0;
};

// Bytes to reserve before a computation of this query starts: its arrays per
// vertex and target, and a quarter of the mesh's size for the rest. If it comes
// to need more, Progress::solver_bytes tells. O(1).
uint64_t PlannedSolverBytes(const Mesh& mesh, const ValidQuery& query);

// Errors: INVALID_ARGUMENT for an option out of range.
absl::StatusOr<std::unique_ptr<Computation>> StartComputation(
    const Mesh& mesh, const ValidQuery& query, const SolveOptions& options);

}  // namespace geodesic

#endif  // GEODESIC_COMPUTATION_H_
