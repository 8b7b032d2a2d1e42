#include "solver/trimming/window_envelope.h"

#include "solver/accuracy.h"
#include "solver/trimming/fragments.h"
#include "solver/trimming/trimming.h"

namespace geodesic {

template <typename Accuracy>
void WindowEnvelope<Accuracy>::Add(const ListedWindow& window) {
  const Interval& interval = window.window.interval;
  if (IsLost(interval, window.window.origin, length_)) return;
  if (windows_.empty() ||
      windows_.back().window.interval.end <= interval.begin) {
    const bool alternates = Alternates(window);
    windows_.push_back(window);
    if (alternates) JoinLast();
  } else if (windows_.back().window.interval.begin > interval.begin) {
    AddInside(window);
  } else {
    Contest(window);
  }
}

template <typename Accuracy>
void WindowEnvelope<Accuracy>::AddInside(const ListedWindow& window) {
  const size_t below = aside_.size();
  while (!windows_.empty() &&
         windows_.back().window.interval.begin > window.window.interval.begin) {
    aside_.push_back(windows_.back());
    windows_.pop_back();
  }
  Add(window);
  while (aside_.size() > below) {
    const ListedWindow next = aside_.back();
    aside_.pop_back();
    Add(next);
  }
}

// REQUIRES: the window begins within the last.
template <typename Accuracy>
void WindowEnvelope<Accuracy>::Contest(const ListedWindow& window) {
  const Window& older = windows_.back().window;
  const Interval held = older.interval;
  const Interval interval = window.window.interval;
  if (may_split_) {
    if (const auto at = SplitBeforeContest(older, window.window)) {
      ListedWindow part = window;
      part.window.CutTo({interval.begin, *at});
      Contest(part);
      part = window;
      part.window.CutTo({*at, interval.end});
      Add(part);
      return;
    }
  }
  const Interval won = WonByNewer(older, window.window);
  if (won.width() <= 0) {
    Push(window, {held.end, interval.end});
    return;
  }
  const bool goes_on = won.end < held.end;
  const ListedWindow beyond = goes_on ? windows_.back() : ListedWindow();
  CutLast({held.begin, won.begin});
  if (!goes_on) {
    Push(window, {won.begin, interval.end});
    return;
  }
  Push(window, won);
  Push(beyond, {won.end, held.end});
  Push(window, {held.end, interval.end});
}

template <typename Accuracy>
void WindowEnvelope<Accuracy>::CutLast(const Interval& part) {
  Window& last = windows_.back().window;
  if (IsLost(part, last.origin, length_)) {
    windows_.pop_back();
  } else {
    last.CutTo(part);
  }
}

template <typename Accuracy>
void WindowEnvelope<Accuracy>::Push(const ListedWindow& window,
                                    const Interval& part) {
  if (IsLost(part, window.window.origin, length_)) return;
  const bool alternates = Alternates(window);
  windows_.push_back(window);
  windows_.back().window.CutTo(part);
  if (alternates) JoinLast();
}

template <typename Accuracy>
bool WindowEnvelope<Accuracy>::Alternates(const ListedWindow& next) const {
  const size_t count = windows_.size();
  return !Accuracy::kMerges && count >= 2 &&
         windows_[count - 2].pseudo_source == next.pseudo_source;
}

template <typename Accuracy>
void WindowEnvelope<Accuracy>::JoinLast() {
  const auto last = windows_.end() - 1, between = last - 1, first = last - 2;
  if (!AreFragments(first->window, between->window, last->window, length_)) {
    return;
  }
  first->window.interval.end = last->window.interval.end;
  first->window.end_distance = last->window.end_distance;
  windows_.erase(between, windows_.end());
}

template class WindowEnvelope<Exact>;
template class WindowEnvelope<WithinTolerance>;

}  // namespace geodesic
