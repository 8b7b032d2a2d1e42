// Trimming a whole list of windows: what is left is their lower envelope.

#ifndef GEODESIC_SOLVER_TRIMMING_ENVELOPE_H_
#define GEODESIC_SOLVER_TRIMMING_ENVELOPE_H_

#include <cstddef>
#include <limits>
#include <vector>

#include "solver/accuracy.h"
#include "solver/trimming/window_envelope.h"
#include "solver/windows/window.h"
#include "solver/windows/window_columns.h"

namespace geodesic {

// Trims windows of one half-edge against each other (WonByNewer; the later in
// the list count as the newer) until they are disjoint and sorted.
//
// The lists of windows that cross a face nearly are that already: where the
// wavefronts of two pseudo-sources meet, their neighbouring windows overlap.
// That is done in place, for all of them together. From the first overlap on
// that is more involved, windows are taken one by one, and what one of them
// meets goes through a short list of its own.
//
// Two windows change over twice only beside a ray that both hold
// (SplitBeforeContest). Windows that crossed a face together share none, since
// they were disjoint before; those of lists that are merged may.
class Envelope {
 public:
  // `length`: of the half-edge.
  void Trim(double length, WindowColumns& windows);

  // The same for two lists, [begin, middle) and [middle, size), each of which
  // is trimmed already; the distances at the windows' ends need not be known,
  // and are not afterwards. `may_split`: Front::MayChangeOverTwice.
  void Merge(double length, bool may_split, size_t begin, size_t middle,
             WindowColumns& windows);

 private:
  // Finds the neighbours that overlap by more than rounding, which is given up,
  // and where they meet.
  void FindMeetings(WindowColumns& windows);
  // Cuts windows where they meet their neighbours. Returns the first meeting
  // that asks for more, or how many there are.
  size_t CutAtMeetings(WindowColumns& windows) const;
  // Trims windows from `i` on, one by one; those before are done.
  void TrimFrom(size_t i, WindowColumns& windows);
  // The number of the meeting of window `pair` and the next one, kNone if they
  // do not meet. REQUIRES: pairs are asked for in order.
  size_t MeetingOf(size_t pair);
  // Trims window i, which begins before the last of the `kept` ends, against
  // that, in place. Where they meet `meeting` says, unless it is kNone. Changes
  // nothing and returns false if the two are not neighbours, or the newer one
  // wins the middle of the older one.
  bool TrimNeighbours(size_t i, size_t meeting, size_t& kept,
                      WindowColumns& windows);
  // Trims windows from `i` on against those of the `kept` that they meet, until
  // one meets none of them and what is left has room; that is the next.
  size_t TrimSeveral(size_t i, size_t& kept, WindowColumns& windows);
  // The same for all, in the order in which they begin: in any other each would
  // be moved past all those before.
  size_t TrimAll(size_t i, size_t& kept, WindowColumns& windows);

  static constexpr size_t kNone = std::numeric_limits<size_t>::max();

  double length_ = 0;
  std::vector<double> begins_, overlaps_;
  // Of the windows that overlap the next one: their numbers, the pairs that
  // they make (so many as older_ holds), where those meet (FindCrossovers).
  std::vector<size_t> pairs_;
  WindowColumns older_, newer_;
  std::vector<double> meetings_;
  size_t next_pair_ = 0;  // for MeetingOf
  WindowEnvelope<Exact> met_;
  std::vector<size_t> order_;  // for TrimAll
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_TRIMMING_ENVELOPE_H_
