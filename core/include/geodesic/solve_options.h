// Parameters that change the cost of an answer, never the answer.

#ifndef GEODESIC_SOLVE_OPTIONS_H_
#define GEODESIC_SOLVE_OPTIONS_H_

#include <cstdint>

namespace geodesic {

inline constexpr uint32_t kMostSolveThreads = 256;

// Parameters of FWP (Xu et al. 2015, Algorithm 1), and threads.
struct SolveOptions {
  // Bucket width as a multiple of h / sqrt(n), with h the mean edge length and
  // n the number of faces. DEFAULT: 16; the paper's 1 makes some per cent fewer
  // windows, each of which costs more.
  double bucket_width = 16;
  // Bound on K, the number of windows an iteration propagates (with the MMP
  // rule: of half-edges, each with all its windows). DEFAULT: 256.
  // The paper's 20000 takes whole wavefronts at once on meshes below a million
  // faces; smaller batches make fewer windows and let MMP forget sooner.
  uint32_t max_batch = 256;
  // Whether K follows the wavefront (section 4.2). If not it is max_batch
  // throughout; 1 then drains the buckets one by one. DEFAULT: true.
  bool adaptive_batch = true;
  // How many threads share the work of one computation, the calling one among
  // them: in [1, kMostSolveThreads]. The result is the same to the bit.
  // fwp-list uses them wherever the wavefront is wide enough; the others use
  // one. DEFAULT: 1.
  uint32_t threads = 1;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVE_OPTIONS_H_
