// Trimming windows of one half-edge one by one: what is left is their lower
// envelope.

#ifndef GEODESIC_SOLVER_TRIMMING_WINDOW_ENVELOPE_H_
#define GEODESIC_SOLVER_TRIMMING_WINDOW_ENVELOPE_H_

#include <vector>

#include "solver/windows/window.h"
#include "solver/windows/window_lists.h"

namespace geodesic {

// Windows that are disjoint and sorted. Scratch that keeps its memory.
//
// Windows that may change over more than once are split first
// (SplitBeforeContest): those of a front that says so, and any that stand for
// several, whose origins lie anywhere.
template <typename Accuracy>
class WindowEnvelope {
 public:
  // Forgets all. `length`: of the half-edge. `may_split`: whether two windows
  // may change over more than once (Front::MayChangeOverTwice).
  void Start(double length, bool may_split) {
    length_ = length;
    may_split_ = may_split;
    windows_.clear();
  }

  // Adds a window, which counts as newer than those here, as far as it is
  // nearer than they, and trims them. What is too narrow is dropped.
  // O(windows that it meets or that begin after it).
  void Add(const ListedWindow& window);
  // Adds one that meets none of those here and begins after all of them.
  void Append(const ListedWindow& window) { windows_.push_back(window); }

  std::vector<ListedWindow>& windows() { return windows_; }

 private:
  void AddInside(const ListedWindow& window);
  void Contest(const ListedWindow& window);
  void CutLast(const Interval& part);
  void Push(const ListedWindow& window, const Interval& part);
  // Whether one that comes next has the pseudo-source of the last but one.
  bool Alternates(const ListedWindow& next) const;
  // Makes one of the last three if they are fragments (fragments.h).
  void JoinLast();

  double length_ = 0;
  bool may_split_ = false;
  std::vector<ListedWindow> windows_;
  std::vector<ListedWindow> aside_;  // a stack
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_TRIMMING_WINDOW_ENVELOPE_H_
