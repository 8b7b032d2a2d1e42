// Short lists of windows that have crossed a face, kept to be compared with
// those that come to their half-edge later.
//
// Lists forget what has crossed. Where wavefronts meet along a line of edges
// (all meridians of a sphere do, around its pole), windows that crossed the
// line come a round late to the edges beyond. They lose there, to windows that
// are gone, by too little for a filter to see, and follow the wavefront as far
// as it goes. MMP's rule, which forgets nothing, trims them away.
//
// To keep all lists takes more than it saves on most meshes. So those of one
// half-edge in 256 are kept, of more on small meshes; once many windows come
// late there and lose all that they hold, those of every half-edge are. (Around
// poles 0.2 to 0.6 of all windows do, elsewhere 0.12 was the most.)
//
// Where the faces around a vertex have hardly any angle, windows that pass it
// go round it, and come to the same half-edges in every turn. They lose to
// those of the turn before, but after a million turns at the soonest to a
// filter, and where a turn is less than a rounding never. So what crosses at a
// half-edge for the 64th time is kept from then on, whatever half-edge it is.
// (There the lines of windows are followed back, too: winding.h.)
//
// What comes through an edge of three faces or more goes on into all others,
// also back beside the face that it has come from. That is late everywhere, and
// where most edges have so many faces it would double with each of them. So all
// lists are kept that enter a face through such an edge, also longer ones,
// until the wavefront has passed it.

#ifndef GEODESIC_SOLVER_RULES_PASSED_WINDOWS_H_
#define GEODESIC_SOLVER_RULES_PASSED_WINDOWS_H_

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "geodesic/mesh.h"
#include "solver/rules/crossing_counter.h"
#include "solver/trimming/trimming.h"
#include "solver/windows/window.h"

namespace geodesic {

// Windows that came to half-edges whose lists are kept as a sample: all of
// them, those that found a list there, and those of them that lost all to it.
struct MetWindows {
  uint64_t all = 0, late = 0, lost = 0;

  MetWindows& operator+=(const MetWindows& other) {
    all += other.all;
    late += other.late;
    lost += other.lost;
    return *this;
  }
};

// List: what names a list; a List() names none.
template <typename List>
class PassedWindows {
 public:
  // The mesh outlives it.
  explicit PassedWindows(const Mesh& mesh)
      : mesh_(mesh),
        log_sample_(LogSampleOf(mesh.half_edge_count())),
        sample_((mesh.half_edge_count() >> log_sample_) + 1) {}

  // Whether the list of a half-edge is kept however seldom lists cross there.
  // Of other half-edges a sample is.
  static bool AlwaysKeeps(const Mesh& mesh, HalfEdge h) {
    return mesh.HasIrregularEdges() && mesh.IsNonManifoldEdge(h);
  }
  // The most windows of a list that is kept; longer ones are not.
  static size_t Most(const Mesh& mesh, HalfEdge h) {
    return AlwaysKeeps(mesh, h) ? kMostAlways : kMostOfSample;
  }

  // Where the list of h is kept, List() in it if there is none; nullptr if it
  // is not kept. `times`: how often lists have crossed there, this one
  // included. Valid until Count or Sweep. Threads may use different half-edges'
  // lists at once.
  List* At(HalfEdge h, uint32_t times) {
    if (AlwaysKeeps(mesh_, h)) return &others_[h];
    List* const kept = Kept(h);
    return kept != nullptr || times < kManyCrossings ? kept : &others_[h];
  }

  // Forgets what was kept at these half-edges, which are all that lists have
  // crossed, and is as new. `drop` takes each list.
  template <typename Drop>
  void Clear(std::span<const HalfEdge> crossed, Drop drop) {
    for (const auto& [h, list] : others_) drop(list);
    others_.clear();
    next_sweep_ = kLeastSweep;
    for (const HalfEdge h : crossed) {
      List* const kept = Kept(h);
      if (kept != nullptr && *kept != List()) {
        drop(std::exchange(*kept, List()));
      }
    }
    keeps_all_ = false;
    met_ = {};
  }

  // Forgets what was kept at edges of many faces that the wavefront has passed,
  // now and then: each list pays for a few visits. is_passed(half_edge); `drop`
  // takes each list.
  template <typename IsPassed, typename Drop>
  void Sweep(IsPassed is_passed, Drop drop) {
    if (others_.size() < next_sweep_) return;
    std::erase_if(others_, [&](const auto& kept) {
      if (!AlwaysKeeps(mesh_, kept.first) || !is_passed(kept.first))
        return false;
      drop(kept.second);
      return true;
    });
    next_sweep_ = std::max(2 * others_.size(), kLeastSweep);
  }

  // Says what windows have met since the last time.
  void Count(const MetWindows& met) {
    if (keeps_all_ || log_sample_ == 0) return;  // all of them, or none
    met_ += met;
    if (met_.late < std::max<uint64_t>(kDecided, mesh_.half_edge_count() /
                                                     kHalfEdgesByDecided)) {
      return;
    }
    if (static_cast<double>(met_.lost) >
        kMany * static_cast<double>(met_.all)) {
      all_.resize(mesh_.half_edge_count());
      keeps_all_ = true;
    }
    met_ = {};
  }

  uint64_t bytes() const {
    // A node of a hash table: what it holds, the next one, and the allocator's
    // own word.
    constexpr uint64_t kNode =
        sizeof(std::pair<const HalfEdge, List>) + 2 * sizeof(void*);
    return std::span(sample_).size_bytes() + std::span(all_).size_bytes() +
           others_.size() * kNode + others_.bucket_count() * sizeof(void*);
  }

 private:
  static constexpr size_t kMostOfSample = 4;
  // What winds round edges of three faces would make a list longer with every
  // turn.
  static constexpr size_t kMostAlways = 64;
  static constexpr size_t kLeastSweep = 1024;
  static constexpr uint32_t kMostLogSample = 8;
  static constexpr uint32_t kLeastSample = 8192;
  // Late windows of the sample that decide, more on large meshes, and the part
  // of all windows that lost everything to those before.
  static constexpr uint64_t kDecided = 128;
  static constexpr uint32_t kHalfEdgesByDecided = 32768;
  static constexpr double kMany = 0.15;

  static uint32_t LogSampleOf(uint32_t half_edges) {
    return std::min<uint32_t>(std::bit_width(half_edges / kLeastSample),
                              kMostLogSample);
  }

  // Where the list of h is if it is kept, however seldom lists cross there.
  List* Kept(HalfEdge h) {
    const uint32_t others = (uint32_t{1} << log_sample_) - 1;
    if ((h & others) == 0) return &sample_[h >> log_sample_];
    return keeps_all_ ? &all_[h] : nullptr;
  }

  const Mesh& mesh_;
  uint32_t log_sample_;
  std::vector<List> sample_;  // lists of the sample
  std::vector<List> all_;     // of all others, by half-edge, once they are kept
  // Of half-edges that are always kept, or crossed often.
  std::unordered_map<HalfEdge, List> others_;
  size_t next_sweep_ = kLeastSweep;  // when so many lists are in there
  bool keeps_all_ = false;
  MetWindows met_;
};

// Whether older windows of the half-edge are nearer on all that a window holds,
// but for what is too narrow to hold. `may_split`: as for
// WindowEnvelope::Start. older_at(k): window k of `count`, which are disjoint
// and sorted.
template <typename OlderAt>
bool LosesAll(const Window& window, double length, bool may_split, size_t count,
              OlderAt older_at) {
  double reached = window.interval.begin;
  for (size_t k = 0; k < count; ++k) {
    const Window older = older_at(k);
    const Interval overlap{
        std::max(older.interval.begin, window.interval.begin),
        std::min(older.interval.end, window.interval.end)};
    if (overlap.width() <= 0) continue;
    if (!IsLost({reached, overlap.begin}, window.origin, length)) return false;
    if (WonByNewer(older, window).width() > 0) return false;
    if (may_split && SplitBeforeContest(older, window).has_value()) {
      return false;
    }
    reached = overlap.end;
  }
  return IsLost({reached, window.interval.end}, window.origin, length);
}

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_PASSED_WINDOWS_H_
