// The queue of Chen and Han: windows in the order of their birth, which is that
// of the faces crossed.

#ifndef GEODESIC_SOLVER_QUEUES_FIFO_H_
#define GEODESIC_SOLVER_QUEUES_FIFO_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "solver/queues/queue.h"

namespace geodesic {

// First in, first out, in rounds: what is born in one round pops in the next.
// Nothing is sorted. The least label of a round is a bound for all that come
// after, because no child has a smaller label than its parent. O(1).
class Fifo {
 public:
  static constexpr bool kStrict = false;

  explicit Fifo(const Tuning&) {}

  void Push(uint32_t id, double label) {
    born_.push_back(id);
    least_born_ = std::min(least_born_, label);
  }

  uint32_t Pop() {
    if (next_ == round_.size() && !StartRound()) return kNothing;
    return round_[next_++];
  }

  uint32_t Upcoming(uint32_t k) const {
    return next_ + k <= round_.size() ? round_[next_ + k - 1] : kNothing;
  }

  void Restart() {
    settled_ = 0;
    least_born_ = std::numeric_limits<double>::infinity();
  }

  // The least label of the round.
  double SettledRadius() const { return settled_; }
  uint64_t size() const { return round_.size() - next_ + born_.size(); }
  uint64_t iterations() const { return iterations_; }
  uint64_t bytes() const {
    return (round_.capacity() + born_.capacity()) * sizeof(uint32_t);
  }

 private:
  bool StartRound() {
    if (born_.empty()) return false;
    round_.clear();
    round_.swap(born_);
    next_ = 0;
    settled_ = std::max(settled_, least_born_);
    least_born_ = std::numeric_limits<double>::infinity();
    ++iterations_;
    return true;
  }

  std::vector<uint32_t> round_;
  size_t next_ = 0;             // of the round
  std::vector<uint32_t> born_;  // for the next round
  double least_born_ = std::numeric_limits<double>::infinity();
  double settled_ = 0;
  uint64_t iterations_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_QUEUES_FIFO_H_
