#include "solver/trimming/envelope.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "solver/trimming/trimming.h"
#include "solver/trimming/trimming_kernels.h"

namespace geodesic {
namespace {

ListedWindow Listed(const WindowColumns& windows, size_t i) {
  return {windows.At(i), windows.pseudo_source[i]};
}

// Puts `listed` into the place of windows [first, last).
void Replace(size_t first, size_t last, std::span<const ListedWindow> listed,
             WindowColumns& windows) {
  const size_t size = windows.size, to = first + listed.size();
  windows.Reserve(size - last + to);
  if (to < last) {
    for (size_t i = last; i < size; ++i) windows.Move(i, i - last + to);
  } else if (to > last) {
    for (size_t i = size; i-- > last;) windows.Move(i, i - last + to);
  }
  windows.size = size - last + to;
  for (size_t k = 0; k < listed.size(); ++k) {
    windows.Set(first + k, listed[k].window, listed[k].pseudo_source);
  }
}

}  // namespace

void Envelope::Trim(double length, WindowColumns& windows) {
  if (windows.size < 2) return;
  length_ = length;
  FindMeetings(windows);
  const size_t done = CutAtMeetings(windows);
  if (done == older_.size) return;
  next_pair_ = done;
  TrimFrom(pairs_[done] + 1, windows);
}

void Envelope::FindMeetings(WindowColumns& windows) {
  const size_t room = windows.size + WindowColumns::kPadding;
  if (begins_.size() < room) {
    begins_.resize(2 * room);
    overlaps_.resize(2 * room);
    pairs_.resize(2 * room);
    meetings_.resize(2 * room);
  }
  OverlapsOfNeighbours(length_, windows, begins_.data(), overlaps_.data());
  // Gathered without a branch.
  size_t count = 0;
  for (size_t i = 0; i < windows.size - 1; ++i) {
    pairs_[count] = i;
    count += !(overlaps_[i] <= 0);
  }
  std::copy_n(begins_.data(), windows.size, windows.begin);
  older_.size = newer_.size = 0;
  older_.Reserve(count);
  newer_.Reserve(count);
  for (size_t k = 0; k < count; ++k) {
    older_.Set(k, windows.At(pairs_[k]));
    newer_.Set(k, windows.At(pairs_[k] + 1));
  }
  older_.size = newer_.size = count;
  if (count > 0) FindCrossovers(older_, newer_, meetings_.data());
}

size_t Envelope::CutAtMeetings(WindowColumns& windows) const {
  const double least = kLeastWidth * length_;
  for (size_t k = 0; k < older_.size; ++k) {
    const size_t i = pairs_[k];
    const double at = meetings_[k];
    // Also if there is no such place.
    if (!(at - windows.begin[i] > least && windows.end[i + 1] - at > least &&
          overlaps_[i] > 0)) {
      return k;
    }
    windows.end[i] = at;
    windows.end_distance[i] = older_.end_distance[k];
    windows.begin[i + 1] = at;
    windows.begin_distance[i + 1] = newer_.begin_distance[k];
  }
  return older_.size;
}

size_t Envelope::MeetingOf(size_t pair) {
  while (next_pair_ < older_.size && pairs_[next_pair_] < pair) {
    ++next_pair_;
  }
  const bool is_known = next_pair_ < older_.size &&
                        pairs_[next_pair_] == pair &&
                        !std::isnan(meetings_[next_pair_]);
  return is_known ? next_pair_ : kNone;
}

void Envelope::TrimFrom(size_t i, WindowColumns& windows) {
  size_t kept = i;
  // Whether the last of the kept is window i - 1, as it was.
  bool is_neighbour = true;
  const size_t size = windows.size;
  while (i < windows.size) {
    if (kept > 0 && windows.end[kept - 1] > windows.begin[i]) {
      // Those that follow may have been shifted.
      const size_t pair = i - 1 - (windows.size - size);
      if (!TrimNeighbours(i, is_neighbour ? MeetingOf(pair) : kNone, kept,
                          windows)) {
        i = TrimSeveral(i, kept, windows);
        is_neighbour = false;
        continue;
      }
    }
    const Interval interval{windows.begin[i], windows.end[i]};
    if (!IsLost(interval, windows.OriginAt(i), length_)) {
      if (kept != i) windows.Move(i, kept);
      ++kept;
      is_neighbour = true;
    } else {
      is_neighbour = false;
    }
    ++i;
  }
  windows.size = kept;
}

bool Envelope::TrimNeighbours(size_t i, size_t meeting, size_t& kept,
                              WindowColumns& windows) {
  const size_t top = kept - 1;
  const double begin = windows.begin[i];
  const double top_end = windows.end[top];
  if (begin < windows.begin[top]) return false;
  if (IsLost({begin, top_end}, windows.OriginAt(i), length_)) {
    // Two windows along one ray, overlapping by rounding.
    windows.begin[i] = top_end;
    return true;
  }
  if (meeting != kNone) {
    windows.begin[i] = windows.end[top] = meetings_[meeting];
    windows.begin_distance[i] = newer_.begin_distance[meeting];
    windows.end_distance[top] = older_.end_distance[meeting];
  } else {
    Window older = windows.At(top), newer = windows.At(i);
    const Interval won = WonByNewer(older, newer);
    if (won.width() <= 0) {
      newer.CutTo({top_end, newer.interval.end});
      windows.Set(i, newer);
      return true;
    }
    if (won.end < top_end) return false;
    newer.CutTo({won.begin, newer.interval.end});
    windows.Set(i, newer);
    older.CutTo({older.interval.begin, won.begin});
    windows.Set(top, older);
  }
  if (IsLost(windows.IntervalAt(top), windows.OriginAt(top), length_)) --kept;
  return true;
}

size_t Envelope::TrimSeveral(size_t i, size_t& kept, WindowColumns& windows) {
  if (windows.begin[i] < windows.begin[kept - 1]) {
    return TrimAll(i, kept, windows);
  }
  size_t first = kept;
  while (first > 0 && windows.end[first - 1] > windows.begin[i]) --first;
  met_.Start(length_, false);
  for (size_t k = first; k < kept; ++k) met_.Append(Listed(windows, k));
  const std::vector<ListedWindow>& trimmed = met_.windows();
  do {
    met_.Add(Listed(windows, i++));
  } while (i < windows.size && windows.begin[i] >= windows.begin[i - 1] &&
           (first + trimmed.size() > i ||
            (!trimmed.empty() &&
             windows.begin[i] < trimmed.back().window.interval.end)));
  kept = first + trimmed.size();
  // What lies between the kept ones and the next is not looked at again.
  Replace(first, std::min(i, kept), trimmed, windows);
  return std::max(i, kept);
}

size_t Envelope::TrimAll(size_t i, size_t& kept, WindowColumns& windows) {
  order_.clear();
  for (size_t k = 0; k < kept; ++k) order_.push_back(k);
  for (; i < windows.size; ++i) order_.push_back(i);
  std::ranges::sort(order_, {},
                    [&](size_t k) { return std::pair(windows.begin[k], k); });
  met_.Start(length_, false);
  for (const size_t k : order_) met_.Add(Listed(windows, k));
  kept = met_.windows().size();
  Replace(0, windows.size, met_.windows(), windows);
  return windows.size;
}

void Envelope::Merge(double length, bool may_split, size_t begin, size_t middle,
                     WindowColumns& windows) {
  if (middle == begin || middle == windows.size ||
      windows.end[middle - 1] <= windows.begin[middle]) {
    return;
  }
  // Whatever meets nothing of the other list stays in place.
  size_t first = begin;
  while (windows.end[first] <= windows.begin[middle]) ++first;
  size_t last = windows.size;
  while (windows.begin[last - 1] >= windows.end[middle - 1]) --last;
  met_.Start(length, may_split);
  const auto add = [&](size_t i) {
    met_.Add(
        {Window::Over({windows.begin[i], windows.end[i]}, windows.OriginAt(i)),
         windows.pseudo_source[i]});
  };
  size_t i = first, j = middle;
  while (i < middle && j < last) {
    add(windows.begin[i] <= windows.begin[j] ? i++ : j++);
  }
  while (i < middle) add(i++);
  while (j < last) add(j++);
  Replace(first, last, met_.windows(), windows);
}

}  // namespace geodesic
