// StartComputation with an observer: for what is made from windows.

#ifndef GEODESIC_SOLVER_START_COMPUTATION_H_
#define GEODESIC_SOLVER_START_COMPUTATION_H_

#include <memory>

#include "absl/status/statusor.h"
#include "geodesic/computation.h"
#include "solver/queues/queue.h"
#include "solver/windows/window_observer.h"

namespace geodesic {

// As the public StartComputation (computation.h). `observer` may be null and
// outlives the computation.
absl::StatusOr<std::unique_ptr<Computation>> StartComputation(
    const Mesh& mesh, const ValidQuery& query, const SolveOptions& options,
    WindowObserver* observer);

// Errors: INVALID_ARGUMENT for an option out of range.
absl::StatusOr<Tuning> TuningFor(const Mesh& mesh, const SolveOptions& options);

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_START_COMPUTATION_H_
