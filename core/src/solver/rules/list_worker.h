// What one thread does of a round of the list rule: lists of windows cross the
// faces that they wait to enter, and vertices that have improved become
// pseudo-sources. Reads the front and changes nothing there; what comes of it
// is kept until it is applied (list_rule.h).

#ifndef GEODESIC_SOLVER_RULES_LIST_WORKER_H_
#define GEODESIC_SOLVER_RULES_LIST_WORKER_H_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "solver/accuracy.h"
#include "solver/rules/expansion.h"
#include "solver/rules/face_crossing.h"
#include "solver/rules/passed_windows.h"
#include "solver/rules/shadow_fan.h"
#include "solver/rules/wide_edges.h"
#include "solver/rules/winding.h"
#include "solver/thread_team.h"
#include "solver/trimming/envelope.h"
#include "solver/windows/window_blocks.h"
#include "solver/windows/window_columns.h"

namespace geodesic {

// What waits at a half-edge: chains of lists, each list trimmed. By the side of
// the neighbouring face that they come across: across its left one they arrive
// nearer to the half-edge's begin.
using WaitingLists = std::array<WindowBlock*, 2>;

// On cache lines of its own, since a thread writes its scratch all the time.
// REQUIRES: the front's origins are points.
template <typename Front>
class alignas(kCacheLine) ListWorker {
 public:
  static constexpr bool kTakesWideEdges = !Front::Goal::kDirects;
  // A better path to a vertex, as Front::Relax takes it.
  struct Relaxation {
    uint32_t vertex;
    double distance;
    Arrival arrival;
    IncomingRay ray;
  };
  // A list that goes on through a half-edge.
  struct HandedOn {
    HalfEdge to;  // with kBeyond: through all others at this one's edge
    Side from;
    WindowBlock* list;
    uint32_t count;  // its windows
    double label;    // no window's label is below
  };
  // A window that the front watches.
  struct Observed {
    HalfEdge half_edge;
    Window window;
    uint32_t pseudo_source;
  };
  // A place in what is kept.
  struct Place {
    uint32_t relaxation = 0, handed_on = 0, observed = 0;
    bool operator==(const Place&) const = default;
  };
  static constexpr HalfEdge kBeyond = kIrregularExit;
  // What comes of one half-edge or vertex.
  struct Outcome {
    uint32_t waited = 0;      // windows
    uint32_t propagated = 0;  // those among them that were not useless
    Place begin, end;
  };

  ListWorker(const Front& front, BlockPool& pool)
      : front_(front),
        mesh_(front.mesh()),
        blocks_(pool),
        crossing_(front),
        list_(crossing_.list()) {}

  // Takes and frees the lists that wait at h. What has crossed is kept in
  // `passed`, unless that is null (PassedWindows::At). Windows that go round
  // and round are dropped.
  Outcome Cross(HalfEdge h, const WaitingLists& lists, WindowBlock** passed,
                Winding winding) {
    Outcome outcome{.begin = Here()};
    outcome.waited = Take(lists, mesh_.frame(h).length);
    if (winding == Winding::kCertain) list_.size = 0;
    if (winding == Winding::kSuspected) DropWinding(h);
    if (passed != nullptr) MeetPassed(h, *passed);
    outcome.propagated = static_cast<uint32_t>(list_.size);
    if (list_.size > 0) CrossFace(h);
    outcome.end = Here();
    return outcome;
  }

  // Makes one list of those that wait at h. Returns how many windows there are
  // more: fewer as a rule, but some may be split.
  int64_t Join(HalfEdge h, WaitingLists& lists) {
    const uint32_t waited = Take(lists, mesh_.frame(h).length);
    lists = {list_.size > 0 ? blocks_.Store(list_) : nullptr, nullptr};
    return static_cast<int64_t>(list_.size) - waited;
  }

  // Copies of a list that was handed on with kBeyond, for any number of faces
  // there.
  void BeginCopies(HalfEdge side, const WindowBlock* list) {
    opened_.size = passed_.size = 0;
    WindowBlocks::Copy(list, opened_);
    WindowBlocks::Copy(list, passed_);
    passed_.Mirror(mesh_.frame(side).length);
  }
  WindowBlock* CopyFor(bool is_mirrored) {
    return blocks_.Store(is_mirrored ? passed_ : opened_);
  }

  // Frees lists that nobody will take.
  void Drop(const WaitingLists& lists) {
    for (WindowBlock* list : lists) blocks_.Drop(list);
  }

  Outcome Expand(uint32_t vertex) {
    Outcome outcome{.begin = Here()};
    faces_ += geodesic::Expand(front_, vertex, *this);
    outcome.end = Here();
    return outcome;
  }

  // What came of all that was done since the last Clear.
  std::span<const Relaxation> relaxations() const { return relaxations_; }
  std::span<const HandedOn> handed_on() const { return handed_on_; }
  std::span<const Observed> observed() const { return observed_; }
  const MetWindows& met() const { return met_; }
  // Faces through which lines were followed back.
  uint64_t followed() const { return followed_; }
  // Faces that vertices have looked at beyond irregular edges.
  uint64_t faces() const { return faces_; }
  void Clear() {
    relaxations_.clear();
    handed_on_.clear();
    observed_.clear();
    met_ = {};
    followed_ = 0;
    faces_ = 0;
  }

  // As geodesic::Expand calls them.
  void Relax(uint32_t vertex, double distance, const Arrival& arrival,
             const IncomingRay& ray = {}) {
    if (!front_.Takes(vertex, distance, arrival)) return;
    relaxations_.push_back({vertex, distance, arrival, ray});
  }
  void Open(HalfEdge half_edge, uint32_t pseudo_source, const Origin& origin,
            const Interval& interval) {
    const auto window = front_.UsefulWindow(half_edge, origin, interval);
    if (!window.has_value()) return;
    const double key = front_.KeyOf(half_edge, *window, window->Label());
    if (std::isinf(key)) return;
    opened_.Reserve(1);
    opened_.Set(0, *window, pseudo_source);
    opened_.size = 1;
    HandOn(half_edge, kLeft, key, opened_);
  }

  void OpenBeyond(HalfEdge side, uint32_t pseudo_source, const Origin& origin,
                  const Interval& interval) {
    const double length = mesh_.frame(side).length;
    if (IsLost(interval, origin, length)) return;
    const Window window = Window::Over(interval, origin);
    if (front_.EndsAreNearer(window, length, mesh_.To(side), mesh_.From(side)))
      return;
    opened_.Reserve(1);
    opened_.Set(0, window, pseudo_source);
    opened_.size = 1;
    HandOn(side | kBeyond, kLeft, window.Label(), opened_);
  }

  void Observe(HalfEdge h, const Window& window, uint32_t pseudo_source) {
    if (front_.Watches(h)) observed_.push_back({h, window, pseudo_source});
  }

  // What is kept of a round; a vertex with very many faces makes it long.
  uint64_t bytes() const {
    return relaxations_.capacity() * sizeof(Relaxation) +
           handed_on_.capacity() * sizeof(HandedOn) +
           observed_.capacity() * sizeof(Observed);
  }

 private:
  using Passed = PassedWindows<WindowBlock*>;

  // So many lists are merged one after the other. Of more, parts of as many
  // lists are merged with each other: thousands wait where there are thousands
  // of sources.
  static constexpr uint32_t kMergedInTurn = 16;

  // Some of list_, trimmed: from here to the next part.
  struct Part {
    size_t begin = 0;
    uint32_t lists = 0;  // that it was made of
  };

  Place Here() const {
    return {static_cast<uint32_t>(relaxations_.size()),
            static_cast<uint32_t>(handed_on_.size()),
            static_cast<uint32_t>(observed_.size())};
  }
  void CrossFace(HalfEdge h) {
    if (front_.Watches(h)) {
      for (size_t i = 0; i < list_.size; ++i) {
        Observe(h,
                Window::Over({list_.begin[i], list_.end[i]}, list_.OriginAt(i)),
                list_.pseudo_source[i]);
      }
    }
    if (mesh_.IsCopy(h)) return;
    crossing_.Cross(
        h,
        [this](uint32_t apex, double distance, const Arrival& arrival,
               const IncomingRay& ray) {
          relaxations_.push_back({apex, distance, arrival, ray});
        },
        [this, h](HalfEdge side, Exit exit, WindowColumns& children,
                  double label) {
          Leave(side, exit, side == Prev(h) ? kLeft : kRight, label, children);
        });
  }

  // Moves what waits to list_. Returns how many windows that were.
  uint32_t Take(const WaitingLists& lists, double length) {
    uint32_t waited = 0;
    list_.size = 0;
    Part last;
    for (WindowBlock* list : lists) {
      while (list != nullptr) {
        if (last.lists == kMergedInTurn) {
          parts_.push_back(last);
          while (parts_.size() > 1 &&
                 parts_[parts_.size() - 2].lists <= parts_.back().lists) {
            JoinParts(length);
          }
          last = {.begin = list_.size};
        }
        waited += list->count;
        const size_t middle = list_.size;
        list = blocks_.Take(list, list_);
        DropStale(middle, list_);
        envelope_.Merge(length, front_.MayChangeOverTwice(), last.begin, middle,
                        list_);
        ++last.lists;
      }
    }
    if (parts_.empty()) return waited;
    parts_.push_back(last);
    while (parts_.size() > 1) JoinParts(length);
    parts_.clear();
    return waited;
  }

  // Makes one of the last two parts.
  void JoinParts(double length) {
    const Part last = parts_.back();
    parts_.pop_back();
    envelope_.Merge(length, front_.MayChangeOverTwice(), parts_.back().begin,
                    last.begin, list_);
    parts_.back().lists += last.lists;
  }

  void DropWinding(HalfEdge h) {
    list_.KeepIf(0, [&](size_t i) {
      return !ComesBack(mesh_, h,
                        Window::Over(list_.IntervalAt(i), list_.OriginAt(i)),
                        followed_);
    });
  }

  // Drops windows of list_ that lose all they hold to those in `passed`, and
  // keeps what is left there, too. What came of useless ones is dropped
  // wherever it has got to, so nothing may lose to these.
  void MeetPassed(HalfEdge h, WindowBlock*& passed) {
    const double length = mesh_.frame(h).length;
    MetWindows met{.all = list_.size};
    passed_.size = 0;
    if (passed != nullptr) {
      WindowBlocks::Copy(passed, passed_);
      DropStale(0, passed_);
      met.late = list_.size;
      list_.KeepIf(0, [&](size_t i) {
        return !LosesAll(
            Window::Over(list_.IntervalAt(i), list_.OriginAt(i)), length,
            front_.MayChangeOverTwice(), passed_.size, [this](size_t k) {
              return Window::Over(passed_.IntervalAt(k), passed_.OriginAt(k));
            });
      });
      met.lost = met.late - list_.size;
    }
    if (!Passed::AlwaysKeeps(mesh_, h)) met_ += met;
    if (list_.size == 0) return;
    if (passed != nullptr) blocks_.Drop(std::exchange(passed, nullptr));
    const size_t middle = passed_.size;
    if (middle + list_.size > Passed::Most(mesh_, h)) return;
    passed_.Append(list_);
    envelope_.Merge(length, front_.MayChangeOverTwice(), 0, middle, passed_);
    if (passed_.size > 0) passed = blocks_.Store(passed_);
  }

  // Drops useless windows from `first` on.
  void DropStale(size_t first, WindowColumns& windows) const {
    windows.KeepIf(first, [&](size_t i) {
      // If the pseudo-source has improved, a newer window is on its way, or
      // those of a straight path to it are. Any improvement will do: here the
      // older window is dropped before the newer one meets it, so the newer one
      // cannot have given way to it as in MmpRule::IsStale.
      return windows.sigma[i] <=
             front_.PseudoSourceDistance(windows.pseudo_source[i]);
    });
  }

  // Hands on what leaves a face across `side`.
  void Leave(HalfEdge side, Exit exit, Side from, double label,
             WindowColumns& children) {
    if (exit < kIrregularExit) {
      HandOn(exit, from, label, children);
      return;
    }
    if (kTakesWideEdges && IsWideEdge(mesh_, side)) {
      HandOn(side | kBeyond, from, label, children);
      return;
    }
    const double length = mesh_.frame(side).length;
    mesh_.ForEachBeyond(side, [&](HalfEdge to, bool is_mirrored) {
      if (!front_.MayEnter(side, to)) return;
      if (is_mirrored) children.Mirror(length);
      HandOn(to, is_mirrored ? kRight : from, label, children);
      if (is_mirrored) children.Mirror(length);
    });
  }
  void HandOn(HalfEdge to, Side from, double label,
              const WindowColumns& windows) {
    handed_on_.push_back({to, from, blocks_.Store(windows),
                          static_cast<uint32_t>(windows.size), label});
  }

  const Front& front_;
  const Mesh& mesh_;
  WindowBlocks blocks_;
  std::vector<Relaxation> relaxations_;
  std::vector<HandedOn> handed_on_;
  std::vector<Observed> observed_;
  MetWindows met_;
  uint64_t followed_ = 0;
  uint64_t faces_ = 0;

  // Scratch, kept for its memory.
  FaceCrossing<Front> crossing_;
  WindowColumns& list_;  // of crossing_
  WindowColumns opened_, passed_;
  std::vector<Part> parts_;
  Envelope envelope_;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_LIST_WORKER_H_
