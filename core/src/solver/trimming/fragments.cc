#include "solver/trimming/fragments.h"

#include <cmath>

#include "solver/trimming/trimming.h"
#include "solver/windows/mixed_origin.h"
#include "tolerances.h"

namespace geodesic {
namespace {

// Whether `part` is tied all along with a window that is seen there.
template <typename OriginType>
bool IsTied(const BasicWindow<OriginType>& whole,
            const BasicWindow<OriginType>& part) {
  const auto is_tied = [&](double at) {
    const double distance = part.DistanceTo(at);
    return std::abs(distance - whole.DistanceTo(at)) <=
           kFragmentTies * TieAt(at, distance);
  };
  // Windows that change over at both ends are tied there, of course.
  const double most = CommonRay(whole.origin, part.origin);
  const bool has_most = most > part.interval.begin && most < part.interval.end;
  return is_tied(part.interval.begin) && is_tied(part.interval.end) &&
         (!has_most || is_tied(most));
}

}  // namespace

template <typename OriginType>
bool AreFragments(const BasicWindow<OriginType>& before,
                  const BasicWindow<OriginType>& between,
                  const BasicWindow<OriginType>& after, double length) {
  const double least = kLeastWidth * length;
  return before.origin == after.origin &&
         between.interval.begin - before.interval.end <= least &&
         after.interval.begin - between.interval.end <= least &&
         IsTied(before, between);
}

template bool AreFragments(const Window&, const Window&, const Window&, double);
template bool AreFragments(const MixedWindow&, const MixedWindow&,
                           const MixedWindow&, double);

}  // namespace geodesic
