// Parameters that change the cost of an answer, never the answer.

#ifndef GEODESIC_SOLVE_OPTIONS_H_
#define GEODESIC_SOLVE_OPTIONS_H_

#include <cstdint>

namespace geodesic {

// How many threads may share a computation.
inline constexpr uint32_t kMostSolveThreads = 256;

// Parameters of FWP (Xu et al. 2015, Algorithm 1), and threads.
struct SolveOptions {
  // Bucket width as a multiple of h / sqrt(n), with h the mean edge length and
  // n the number of faces. DEFAULT: 16. The paper's 1 makes a few per cent
  // fewer windows, but each of them costs more.
  double bucket_width = 16;
  // Bound on K, the number of windows that an iteration propagates. With the
  // MMP rule K counts half-edges, each with all its windows. DEFAULT: 256.
  // The paper's 20000 takes whole wavefronts at once on meshes below a million
  // faces; smaller batches make fewer windows and let MMP forget sooner.
  uint32_t max_batch = 256;
  // Whether K follows the wavefront (section 4.2). If not, K is always
  // max_batch, and 1 then empties one bucket at a time. DEFAULT: true.
  bool adaptive_batch = true;
  // How many threads share the work of one computation, in [1,
  // kMostSolveThreads]; the calling thread is one of them. The result is the
  // same to the bit. fwp-list uses them wherever the wavefront is wide enough;
  // the other algorithms, and fields within a tolerance, use one. DEFAULT: 1.
  uint32_t threads = 1;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVE_OPTIONS_H_
