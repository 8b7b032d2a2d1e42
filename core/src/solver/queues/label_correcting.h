// The label-correcting queue of LC-MMP and LC-CH.
//
// Bertsekas: A simple and fast label correcting algorithm for shortest paths.
// Networks 23, 1993: small label first (SLF).
// Bertsekas, Guerriero, Musmanno: Parallel asynchronous label-correcting
// methods for shortest paths. JOTA 88(2), 1996: large label last (LLL). Glover,
// Klingman, Phillips, Schneider: New polynomial shortest path algorithms and
// their computational attributes. Management Science 31(9), 1985: the
// threshold.

#ifndef GEODESIC_SOLVER_QUEUES_LABEL_CORRECTING_H_
#define GEODESIC_SOLVER_QUEUES_LABEL_CORRECTING_H_

#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "solver/queues/queue.h"

namespace geodesic {

// Labels up to the threshold wait in a deque: one smaller than the first goes
// to the front, the others to the back (SLF); a first one above the deque's
// mean is sent to the back before anything pops (LLL). Larger labels wait
// outside, in no order, until the deque is empty; then the threshold rises.
//
// Nothing is kept sorted. Operations are cheap, but windows pop out of order
// and some are propagated in vain.
class LabelCorrecting {
 public:
  static constexpr bool kStrict = false;

  explicit LabelCorrecting(const Tuning&) {}

  void Push(uint32_t id, double label);
  uint32_t Pop();
  // SLF and LLL leave little that is certain beyond the next.
  uint32_t Upcoming(uint32_t k) const {
    return k <= near_.size() ? near_[k - 1].id : kNothing;
  }

  void Restart() {
    threshold_ = -1;
    settled_ = 0;
  }

  // The least label there was when the threshold last rose.
  double SettledRadius() const { return settled_; }
  uint64_t size() const { return near_.size() + far_.size(); }
  // How often the threshold rose.
  uint64_t iterations() const { return iterations_; }
  uint64_t bytes() const {
    return near_.size() * sizeof(Entry) + far_.capacity() * sizeof(Entry);
  }

 private:
  struct Entry {
    double label;
    uint32_t id;
  };

  void PushNear(const Entry& entry);
  // Moves the smaller of the far labels into the deque. False if none are left.
  bool RaiseThreshold();

  std::deque<Entry> near_;  // labels up to threshold_
  double near_sum_ = 0;     // of their labels
  std::vector<Entry> far_;
  double threshold_ = -1;
  double settled_ = 0;
  uint64_t iterations_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_QUEUES_LABEL_CORRECTING_H_
