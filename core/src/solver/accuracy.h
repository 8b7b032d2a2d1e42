// How well a computation keeps distances: exactly, or within a tolerance, by
// windows that stand for several and an account of what that costs
// (docs/algorithm.md, 22).

#ifndef GEODESIC_SOLVER_ACCURACY_H_
#define GEODESIC_SOLVER_ACCURACY_H_

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "tolerances.h"

namespace geodesic {

// A double that is not negative, as a float that is no less.
inline float RoundedUp(double value) {
  const auto rounded = static_cast<float>(value);
  return rounded < value
             ? std::nextafter(rounded, std::numeric_limits<float>::infinity())
             : rounded;
}

// A merged window has no pseudo-source. In that column it keeps its account: by
// how much its distances may be below those of real paths. Numbers of
// pseudo-sources leave the highest bit free, and so do floats that are not
// negative.
inline constexpr uint32_t kMergedWindow = 0x80000000u;
inline bool IsMerged(uint32_t pseudo_source) {
  return (pseudo_source & kMergedWindow) != 0;
}
inline uint32_t MergedWithAccount(float account) {
  return std::bit_cast<uint32_t>(account) | kMergedWindow;
}
inline float AccountOfMerged(uint32_t pseudo_source) {
  return std::bit_cast<float>(pseudo_source & ~kMergedWindow);
}

// Windows are never merged, and every distance is that of a real path.
struct Exact {
  static constexpr bool kMerges = false;
};

// Windows of a half-edge are merged while their accounts stay within a part of
// their label. The distances that a front holds are lower bounds; the account
// of a vertex is what its upper bound lies above that.
class WithinTolerance {
 public:
  static constexpr bool kMerges = true;
  // Of every tolerance, kept for rounding: what exact distances are promised to
  // be good to.
  static constexpr double kMargin = 1e-10;

  WithinTolerance() = default;
  explicit WithinTolerance(double tolerance)
      : share_(ShareOf(std::min(tolerance, kLoosestOfUse))) {}

  // The largest account, over the label of a window.
  double share() const { return share_; }

 private:
  static double ShareOf(double tolerance) {
    return (tolerance - kMargin) /
           ((1 - kAnswerInAccount) * (1 + 2 * tolerance));
  }

  double share_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_ACCURACY_H_
