// A vertex of very many faces, which becomes a pseudo-source by and by: some of
// its faces at a time, so that a computation can be stopped in between.

#ifndef GEODESIC_SOLVER_RULES_HUB_H_
#define GEODESIC_SOLVER_RULES_HUB_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "geodesic/mesh.h"
#include "solver/queues/queue.h"
#include "solver/rules/expansion.h"
#include "solver/rules/sight.h"
#include "solver/windows/window.h"

namespace geodesic {

// Whether v has so many faces that to open all takes a millisecond and more.
inline bool IsHub(const Mesh& mesh, uint32_t v) {
  constexpr size_t kMany = 4096;
  return mesh.Outgoing(v).size() > kMany;
}

// Does what Expand does, in the same order. Sink: as there. The front
// outlives it.
template <typename Front, typename Sink>
class Hub {
 public:
  Hub(const Front& front, uint32_t v, Sink sink)
      : front_(front), v_(v), sink_(std::move(sink)) {}
  Hub(const Hub&) = delete;
  Hub& operator=(const Hub&) = delete;

  bool is_done() const { return sight_.has_value() && next_ == seen_.size(); }

  // Goes on. Returns how many faces were looked at.
  uint64_t GoOn() {
    if (!sight_.has_value()) {
      Begin();
      return front_.mesh().Outgoing(v_).size();
    }
    const uint64_t before = sight_->faces();
    const size_t end = std::min(next_ + kAtATime, seen_.size());
    for (; next_ < end; ++next_) {
      LookAcross(front_.mesh(), seen_[next_].half_edge, seen_[next_].part,
                 sigma_, *sight_);
    }
    return kAtATime + sight_->faces() - before;
  }

  uint64_t bytes() const { return seen_.capacity() * sizeof(Seen); }

 private:
  static constexpr size_t kAtATime = 1024;

  // As ForEachSeen says.
  struct Seen {
    HalfEdge half_edge;
    Interval part;
  };

  void Begin() {
    RelaxAround(front_, v_, sink_);
    sight_.emplace(front_, v_, sink_);
    sigma_ = front_.distance(v_);
    ForEachSeen(front_, v_, [this](HalfEdge h, const Interval& part) {
      seen_.push_back({h, part});
    });
  }

  const Front& front_;
  const uint32_t v_;
  Sink sink_;
  std::optional<Sight<Front, Sink>> sight_;  // once it has begun
  double sigma_ = 0;
  std::vector<Seen> seen_;
  size_t next_ = 0;  // of seen_
};

// The hubs that a front has come to. Front and rule outlive it.
template <typename Front, typename Rule>
class Hubs {
 public:
  Hubs(Front& front, Rule& rule) : front_(front), rule_(rule) {}

  bool empty() const { return hubs_.empty(); }

  // Whether an id of the queue is a hub's event, which it then takes.
  bool Take(uint32_t id) {
    if (!(id & kVertexEvent)) return false;
    const uint32_t v = id & ~kVertexEvent;
    if (!IsHub(front_.mesh(), v)) return false;
    if (front_.TakeEvent(v)) {
      hubs_.emplace_back(front_, v, DirectSink(front_, rule_));
    }
    return true;
  }

  // Goes on with the first. Returns how many faces were looked at.
  // REQUIRES: !empty().
  uint64_t GoOn() {
    const uint64_t faces = hubs_.front().GoOn();
    if (hubs_.front().is_done()) hubs_.pop_front();
    return faces;
  }

  void Clear() { hubs_.clear(); }

  uint64_t bytes() const {
    uint64_t bytes = 0;
    for (const auto& hub : hubs_) bytes += hub.bytes();
    return bytes;
  }

 private:
  Front& front_;
  Rule& rule_;
  std::deque<Hub<Front, DirectSink<Front, Rule>>> hubs_;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_RULES_HUB_H_
