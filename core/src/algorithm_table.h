// Which rule and which queue an algorithm is.

#ifndef GEODESIC_ALGORITHM_TABLE_H_
#define GEODESIC_ALGORITHM_TABLE_H_

#include <memory>

#include "geodesic/algorithm.h"
#include "geodesic/computation.h"
#include "queues/queue.h"
#include "windows/window_observer.h"

namespace geodesic {

using StartFunction = std::unique_ptr<Computation> (*)(const Mesh&,
                                                       const Query&,
                                                       const Tuning&,
                                                       WindowObserver*);

// Type erasure happens here, once per query.
StartFunction PointStart(Algorithm algorithm);
// For queries with curves.
StartFunction CurveStart(Algorithm algorithm);

}  // namespace geodesic

#endif  // GEODESIC_ALGORITHM_TABLE_H_
