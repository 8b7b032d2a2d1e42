// What solving on a mesh costs.

#ifndef GEODESIC_BENCH_PAPER_MEASUREMENT_H_
#define GEODESIC_BENCH_PAPER_MEASUREMENT_H_

#include <cstdint>

#include "bench/subject.h"
#include "geodesic/distance_field.h"
#include "geodesic/solve_options.h"
#include "geodesic_types/algorithms.h"

namespace geodesic::paper {

// The paper's parameters: l = h / sqrt(n), K_max = 20000.
inline constexpr SolveOptions kPaperOptions = {.bucket_width = 1,
                                               .max_batch = 20000};

// Solves from subject.source() until `most_runs` are done or as many as make a
// third of a second, and returns the statistics of the fastest. Its
// solve_seconds are processor time: one thread solves, and others may share the
// machine.
SolveStatistics Measure(const Subject& subject, Algorithm algorithm,
                        const SolveOptions& options, int most_runs);

// Whether it is worth waiting for an algorithm on so many faces. CH without a
// filter makes ten to fifty times the windows of the others.
inline bool IsFeasible(Algorithm algorithm, uint64_t faces) {
  constexpr uint64_t kMostFacesForCh = 6000;
  return algorithm != Algorithm::kCh || faces <= kMostFacesForCh;
}

}  // namespace geodesic::paper

#endif  // GEODESIC_BENCH_PAPER_MEASUREMENT_H_
