// Which rule and which queue an algorithm is.

#ifndef GEODESIC_SOLVER_ALGORITHM_TABLE_H_
#define GEODESIC_SOLVER_ALGORITHM_TABLE_H_

#include <memory>

#include "geodesic/algorithm.h"
#include "geodesic/computation.h"
#include "solver/queues/queue.h"
#include "solver/windows/window_observer.h"

namespace geodesic {

using StartFunction = std::unique_ptr<Computation> (*)(const Mesh&,
                                                       const ValidQuery&,
                                                       const Tuning&,
                                                       WindowObserver*);

// Type erasure happens here, once per query.
StartFunction PointStart(Algorithm algorithm);
// For queries with curves.
StartFunction CurveStart(Algorithm algorithm);

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_ALGORITHM_TABLE_H_
