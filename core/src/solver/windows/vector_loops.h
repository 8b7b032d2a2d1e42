// Loops over columns of windows that the compiler makes into vector code, for
// several widths of vectors.

#ifndef GEODESIC_SOLVER_WINDOWS_VECTOR_LOOPS_H_
#define GEODESIC_SOLVER_WINDOWS_VECTOR_LOOPS_H_

#include <cstddef>

#include "solver/windows/window_columns.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define GEODESIC_FOR_EVERY_WIDTH \
  __attribute__((target_clones("avx2", "default")))
#else
#define GEODESIC_FOR_EVERY_WIDTH
#endif

// Into each of the versions.
#if defined(__GNUC__)
#define GEODESIC_INLINE inline __attribute__((always_inline))
#else
#define GEODESIC_INLINE inline
#endif

// Before a loop whose columns do not overlap.
#if defined(__GNUC__) && !defined(__clang__)
#define GEODESIC_INDEPENDENT _Pragma("GCC ivdep")
#else
#define GEODESIC_INDEPENDENT
#endif

namespace geodesic {

// Whole vectors: what lies behind a list's end is computed along with it, and
// nobody looks at that.
inline size_t Padded(size_t count) {
  constexpr size_t kStep = WindowColumns::kPadding;
  return (count + kStep - 1) / kStep * kStep;
}

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_WINDOWS_VECTOR_LOOPS_H_
