// The bucket queue of Fast Wavefront Propagation.
//
// Xu, Wang, Liu, Liu, He: Fast Wavefront Propagation (FWP) for Computing Exact
// Geodesic Distances on Meshes. IEEE TVCG 21(7), 2015, section 4, Algorithm 1.
//
//   paper            here
//   l                width_           bucket width
//   P_first, P_end   first_, end_     buckets of an iteration, [first_, end_)
//   K                least_           windows an iteration takes at the least
//   c_small, c_large near_, far_      windows born below / beyond end_
//   K_max            max_batch_
//
// Without adaptation K is max_batch_ throughout (the fixed K of the paper's
// Fig. 10); with 1 the buckets are drained one by one.
//
// Where the listing leaves questions, this is what holds here: near_ and far_
// are counted per iteration; [first_, end_) is half open; a window whose label
// rounds below the current bucket goes into the current bucket.

#ifndef GEODESIC_SOLVER_QUEUES_FWP_BUCKETS_H_
#define GEODESIC_SOLVER_QUEUES_FWP_BUCKETS_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/queues/id_lists.h"
#include "solver/queues/queue.h"

namespace geodesic {

// A ring of first-in-first-out buckets, with a heap for labels beyond its
// reach (the number of buckets a mesh asks for has no bound). An iteration
// first moves its windows into one batch, so that what comes next is known.
// Push and Pop take constant time while labels stay within the ring.
class FwpBuckets {
 public:
  static constexpr bool kStrict = false;

  explicit FwpBuckets(const Tuning& tuning);

  void Push(uint32_t id, double label);
  uint32_t Pop() {
    if (next_ == batch_.size() && !StartIteration()) return kNothing;
    --entries_;
    return batch_[next_++];
  }
  uint32_t Upcoming(uint32_t k) const {
    return next_ + k <= batch_.size() ? batch_[next_ + k - 1] : kNothing;
  }

  void Restart() { first_ = end_ = least_ = near_ = far_ = 0; }

  // The lower edge of the first bucket that is not empty.
  double SettledRadius() const { return static_cast<double>(first_) * width_; }
  uint64_t size() const { return entries_; }
  uint64_t iterations() const { return iterations_; }
  // K of the current iteration.
  int64_t least() const { return least_; }
  uint64_t bytes() const {
    return ring_.bytes() + beyond_.capacity() * sizeof(Far) +
           batch_.capacity() * sizeof(uint32_t);
  }

 private:
  static constexpr int64_t kRing = 16384;
  static constexpr int64_t kMask = kRing - 1;

  struct Far {
    int64_t bucket;
    uint32_t id;
  };

  struct After {
    bool operator()(const Far& a, const Far& b) const {
      return a.bucket != b.bucket ? a.bucket > b.bucket : a.id > b.id;
    }
  };

  int64_t BucketOf(double label) const;
  // Takes the windows of at least K smallest labels. False if none are left.
  bool StartIteration();
  void SetLeast();
  // Moves first_ to the first bucket with entries and draws in far ones.
  void Advance();

  const double inverse_width_;
  const double width_;
  const int64_t max_batch_;
  const bool adaptive_batch_;

  IdLists ring_{kRing};  // buckets
  uint64_t in_ring_ = 0;
  std::vector<Far> beyond_;  // heap by bucket

  std::vector<uint32_t> batch_;  // the iteration's windows, in order
  size_t next_ = 0;              // of the batch

  uint64_t entries_ = 0;  // in the ring, beyond it and left in the batch
  uint64_t iterations_ = 0;

  int64_t first_ = 0;
  int64_t end_ = 0;
  int64_t least_ = 0;
  int64_t near_ = 0;
  int64_t far_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_QUEUES_FWP_BUCKETS_H_
