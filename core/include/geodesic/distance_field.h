// What a solver returns.

#ifndef GEODESIC_DISTANCE_FIELD_H_
#define GEODESIC_DISTANCE_FIELD_H_

#include <cstdint>
#include <vector>

#include "geodesic/algorithm.h"

namespace geodesic {

// Figures of merit, as the paper reports them (Xu et al. 2015, section 7).
struct SolveStatistics {
  // Batches taken from the queue; for a heap, one per window.
  uint64_t iterations = 0;
  // Windows that entered the wavefront, and those of them propagated.
  uint64_t windows_created = 0;
  uint64_t windows_propagated = 0;
  // Windows waiting in the queue: at the most, and the mean over iterations.
  uint64_t peak_wavefront = 0;
  double mean_wavefront = 0;
  // Windows in memory at the most (MMP keeps propagated ones for trimming).
  uint64_t peak_windows = 0;
  uint64_t pseudo_source_events = 0;
  uint64_t peak_solver_bytes = 0;
  double solve_seconds = 0;
};

struct DistanceField {
  // One per vertex, in the unit of the mesh's file; +infinity where no path
  // from any source leads.
  std::vector<double> distances;
  Algorithm algorithm = kDefaultAlgorithm;
  SolveStatistics statistics;
};

}  // namespace geodesic

#endif  // GEODESIC_DISTANCE_FIELD_H_
