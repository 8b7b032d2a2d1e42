// Distances between random pairs of vertices, timed, for the programs that
// measure.

#ifndef GEODESIC_BENCH_PAIRS_H_
#define GEODESIC_BENCH_PAIRS_H_

#include <cstdint>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/landmarks.h"
#include "geodesic/mesh.h"

namespace geodesic {

struct Pair {
  uint32_t from, to;
};

// Between vertices that have faces.
std::vector<Pair> RandomPairs(const Mesh& mesh, uint32_t count, uint32_t seed);

// What some pairs took, in their order. Times are this thread's processor time.
struct PairRuns {
  std::vector<double> distances, seconds, windows;
};

// One after the other by one TargetSearch; each `repeat` times, of which the
// median counts. Errors: as TargetSearch::Run.
absl::StatusOr<PairRuns> SearchPairs(const Mesh& mesh,
                                     std::span<const Pair> pairs,
                                     const Landmarks* landmarks, int repeat,
                                     double tolerance = 0);

// Each as a field that stops at the target. Errors: as Solve.
absl::StatusOr<PairRuns> StopAtTargets(const Mesh& mesh,
                                       std::span<const Pair> pairs);

// How far apart two of them are at the most, relatively, in the pairs that both
// have.
double LargestDifference(const PairRuns& a, const PairRuns& b);

// Of this thread.
double ProcessorSeconds();

// The value that this part of all is not above. REQUIRES: there is one.
double Quantile(std::vector<double> values, double part);

}  // namespace geodesic

#endif  // GEODESIC_BENCH_PAIRS_H_
