#include "solver/rules/fragments.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "solver/rules/trimming.h"
#include "solver/windows/mixed_origin.h"
#include "tolerances.h"

namespace geodesic {
namespace {

// Shorter lists cost less than looking for fragments.
constexpr size_t kMany = 64;

// Whether more than a quarter of the windows begin after another of the same
// pseudo-source and one window between, as every fourth of them says.
bool ManyAlternate(const WindowColumns& windows) {
  const uint32_t* source = windows.pseudo_source;
  size_t alternating = 0;
  for (size_t i = 2; i < windows.size; i += 4) {
    alternating += (source[i - 2] == source[i]) & (source[i - 1] != source[i]);
  }
  return alternating > windows.size / 16;
}

}  // namespace

template <typename OriginType>
bool AreFragments(const BasicWindow<OriginType>& before,
                  const BasicWindow<OriginType>& between,
                  const BasicWindow<OriginType>& after, double length) {
  const Interval& part = between.interval;
  if (!(before.origin == after.origin) ||
      part.begin - before.interval.end > kLeastWidth * length ||
      after.interval.begin - part.end > kLeastWidth * length) {
    return false;
  }
  const auto is_tied = [&](double at) {
    const double distance = between.DistanceTo(at);
    return std::abs(distance - before.DistanceTo(at)) <=
           kFragmentTies * std::max(kTie * distance, kRoundedPosition * at);
  };
  // Windows that change over at both ends are tied there, of course.
  const double most = CommonRay(before.origin, between.origin);
  const bool has_most = most > part.begin && most < part.end;
  return is_tied(part.begin) && is_tied(part.end) &&
         (!has_most || is_tied(most));
}

template bool AreFragments(const Window&, const Window&, const Window&, double);
template bool AreFragments(const MixedWindow&, const MixedWindow&,
                           const MixedWindow&, double);

void JoinFragments(double length, WindowColumns& windows) {
  if (windows.size < kMany || !ManyAlternate(windows)) return;
  const auto are_fragments = [&](size_t before, size_t between, size_t after) {
    return windows.pseudo_source[before] == windows.pseudo_source[after] &&
           AreFragments(windows.At(before), windows.At(between),
                        windows.At(after), length);
  };
  size_t i = 2;
  while (i < windows.size && !are_fragments(i - 2, i - 1, i)) ++i;
  size_t kept = i;
  for (; i < windows.size; ++i) {
    if (are_fragments(kept - 2, kept - 1, i)) {
      --kept;
      windows.end[kept - 1] = windows.end[i];
    } else {
      windows.Move(i, kept++);
    }
  }
  windows.size = kept;
}

}  // namespace geodesic
