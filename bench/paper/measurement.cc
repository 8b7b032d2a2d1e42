#include "bench/paper/measurement.h"

#include <ctime>

#include "geodesic/solve.h"

namespace geodesic::paper {

SolveStatistics Measure(const Subject& subject, Algorithm algorithm,
                        const SolveOptions& options, int most_runs) {
  constexpr double kEnoughSeconds = 0.3;
  const Query query{.sources = {{VertexPoint{subject.source()}}},
                    .algorithm = algorithm};
  NoCheckpoint checkpoint;
  SolveStatistics fastest;
  double spent = 0;
  for (int run = 0; run < most_runs && spent < kEnoughSeconds; ++run) {
    const std::clock_t start = std::clock();
    SolveStatistics statistics =
        Solve(*subject.mesh, query, options, checkpoint).value().statistics;
    statistics.solve_seconds =
        static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    spent += statistics.solve_seconds;
    if (run == 0 || statistics.solve_seconds < fastest.solve_seconds) {
      fastest = statistics;
    }
  }
  return fastest;
}

}  // namespace geodesic::paper
