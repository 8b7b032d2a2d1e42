// solve --algorithm svg --target and --pairs: what the distance between two
// vertices costs in the saddle vertex graph.

#ifndef GEODESIC_BENCH_SOLVE_GRAPH_PAIRS_H_
#define GEODESIC_BENCH_SOLVE_GRAPH_PAIRS_H_

#include "absl/status/status.h"
#include "bench/question_options.h"
#include "bench/solve_approximate.h"
#include "bench/solve_pairs.h"
#include "geodesic/mesh.h"

namespace geodesic {

// Prints a line of JSON; times of pairs are processor time. Graph and landmarks
// are made before the clock starts.
absl::Status SolveGraphPairs(const Mesh& mesh, const QuestionOptions& question,
                             const ApproximateOptions& approximate,
                             uint32_t threads, const PairOptions& options);

}  // namespace geodesic

#endif  // GEODESIC_BENCH_SOLVE_GRAPH_PAIRS_H_
