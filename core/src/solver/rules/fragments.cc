#include "solver/rules/fragments.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "solver/windows/window.h"
#include "tolerances.h"

namespace geodesic {
namespace {

bool AreTied(const Origin& a, const Origin& b, double at) {
  const double distance = a.PathTo(at);
  return std::abs(distance - b.PathTo(at)) <=
         kFragmentTies * std::max(kTie * distance, kRoundedPosition * at);
}

// Whether windows i and k are pieces of one, and window j between them is tied
// with it.
bool AreFragments(const WindowColumns& windows, size_t i, size_t j, size_t k,
                  double least) {
  if (windows.pseudo_source[i] != windows.pseudo_source[k] ||
      windows.x[i] != windows.x[k] || windows.depth[i] != windows.depth[k] ||
      windows.sigma[i] != windows.sigma[k]) {
    return false;
  }
  if (windows.begin[j] - windows.end[i] > least ||
      windows.begin[k] - windows.end[j] > least) {
    return false;
  }
  const Origin whole = windows.OriginAt(i), between = windows.OriginAt(j);
  return AreTied(whole, between, windows.begin[j]) &&
         AreTied(whole, between, windows.end[j]);
}

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

void JoinFragments(double length, WindowColumns& windows) {
  if (windows.size < kMany || !ManyAlternate(windows)) return;
  const double least = kLeastWidth * length;
  size_t i = 2;
  while (i < windows.size && !AreFragments(windows, i - 2, i - 1, i, least)) {
    ++i;
  }
  size_t kept = i;
  for (; i < windows.size; ++i) {
    if (AreFragments(windows, kept - 2, kept - 1, i, least)) {
      --kept;
      windows.end[kept - 1] = windows.end[i];
    } else {
      windows.Move(i, kept++);
    }
  }
  windows.size = kept;
}

}  // namespace geodesic
