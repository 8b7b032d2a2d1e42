// Trimming a whole list of windows: what is left is their lower envelope.

#ifndef GEODESIC_RULES_ENVELOPE_H_
#define GEODESIC_RULES_ENVELOPE_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rules/list_kernels.h"
#include "tolerances.h"
#include "windows/window.h"
#include "windows/window_columns.h"
#include "windows/window_lists.h"

namespace geodesic {

// Trims windows of one half-edge against each other (WonByNewer; the later in
// the list count as the newer) until they are disjoint and sorted.
//
// The lists of windows that cross a face nearly are that already: where the
// wavefronts of two pseudo-sources meet, their neighbouring windows overlap.
// That is done in place. Whatever is more involved goes through a short list of
// its own, window by window.
class Envelope {
 public:
  // `length`: of the half-edge. `may_split`: Front::MayChangeOverTwice.
  void Trim(double length, bool may_split, WindowColumns& windows);

  // The same for two lists, [0, middle) and [middle, size), each of which is
  // trimmed already; the distances at the windows' ends need not be known, and
  // are not afterwards.
  void Merge(double length, bool may_split, size_t middle,
             WindowColumns& windows);

 private:
  // Trims window i, which begins before the last of the `kept` ends, against
  // that if one of the two gives way on their common side. Otherwise changes
  // nothing and returns false. `pair`: their number in meetings_, if they are
  // as they were, or kUnknown.
  bool TrimNeighbours(size_t i, size_t pair, size_t& kept,
                      WindowColumns& windows);
  // Trims windows from `i` on against those of the `kept` that they meet, until
  // one meets none of them; that is the next. Makes room if it needs any.
  size_t TrimSeveral(size_t i, size_t& kept, WindowColumns& windows);

  // Of sorted_, to which windows are added.
  void Add(const ListedWindow& window);
  void AddInside(const ListedWindow& window);
  void Contest(const ListedWindow& window);
  void Push(const ListedWindow& window, const Interval& part);

  // Whether a part of a window is too narrow to matter.
  bool IsLost(const Interval& part, const Origin& origin) const {
    return part.width() <= kLeastWidth * length_ &&
           IsSliver(part, origin, length_);
  }

  double length_ = 0;
  bool may_split_ = false;
  Meetings meetings_;
  std::vector<ListedWindow> sorted_;
  std::vector<ListedWindow> aside_;  // a stack
};

}  // namespace geodesic

#endif  // GEODESIC_RULES_ENVELOPE_H_
