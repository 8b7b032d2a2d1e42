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

// When a computation may stop: as soon as one of these holds.
struct Reach {
  // Every distance up to here is certified; in the unit of the mesh's file.
  double radius = std::numeric_limits<double>::infinity();
  // So many of the query's targets (vertices among them) are certified.
  // DEFAULT: never stop because of targets.
  uint64_t targets = std::numeric_limits<uint64_t>::max();
};

// Not thread-safe; one thread at a time. Has threads of its own
// (SolveOptions::threads) during Advance alone. Holds the wavefront and the
// distances between calls; the mesh must outlive it.
class Computation {
 public:
  virtual ~Computation() = default;

  // Propagates until `reach` is reached or nothing is left. Work goes with the
  // surface covered.
  // Errors: INVALID_ARGUMENT for a radius that is negative or NaN; whatever
  // `checkpoint` returns. After that too Field() is valid and Advance may go
  // on.
  virtual absl::Status Advance(const Reach& reach, Checkpoint& checkpoint) = 0;

  // What is certified now: distances beyond settled_radius are +infinity.
  // After an Advance that stopped at a radius, that is settled_radius. O(V).
  virtual DistanceField Field() const = 0;

  // Adds a source, which is a point, to a computation that has come to its end;
  // the next Advance starts from it. What was certified is so no longer:
  // distances may only become smaller. Its number follows those of the query's.
  // Errors: INVALID_ARGUMENT as ValidQuery::Make, or for a curve;
  // FAILED_PRECONDITION: the last Advance has left something to do, or the
  // query asked for a trace.
  virtual absl::Status AddSource(const Source& source) = 0;

  // Bytes held beside the mesh.
  virtual uint64_t bytes() const = 0;
};

// What to set aside before a computation of this query starts: what it holds
// per vertex and target, and a quarter of the mesh for the rest. What it turns
// out to need beyond that, Progress::solver_bytes tells. O(1).
uint64_t PlannedSolverBytes(const Mesh& mesh, const ValidQuery& query);

// Errors: INVALID_ARGUMENT for an option out of range.
absl::StatusOr<std::unique_ptr<Computation>> StartComputation(
    const Mesh& mesh, const ValidQuery& query, const SolveOptions& options);

}  // namespace geodesic

#endif  // GEODESIC_COMPUTATION_H_
