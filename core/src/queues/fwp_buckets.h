// The bucket queue of Fast Wavefront Propagation.
//
// Xu, Wang, Liu, Liu, He: Fast Wavefront Propagation (FWP) for Computing Exact
// Geodesic Distances on Meshes. IEEE TVCG 21(7), 2015, section 4, Algorithm 1.
//
//   paper            here
//   l                width_           bucket width
//   P_first, P_end   first_, end_     buckets of an iteration, [first_, end_)
//   K                batch_           windows an iteration takes at the least
//   c_small, c_large near_, far_      windows born below / beyond end_
//   K_max            max_batch_
//
// Where the listing leaves questions, this is what holds here: near_ and far_
// are counted per iteration; [first_, end_) is half open; a window whose label
// rounds below the current bucket goes into the current bucket.

#ifndef GEODESIC_QUEUES_FWP_BUCKETS_H_
#define GEODESIC_QUEUES_FWP_BUCKETS_H_

#include <cstdint>
#include <vector>

#include "queues/queue.h"

namespace geodesic {

// A ring of first-in-first-out buckets, with a heap for labels beyond its
// reach (the number of buckets a mesh asks for has no bound). Push and Pop
// take constant time while labels stay within the ring.
class FwpBuckets {
 public:
  explicit FwpBuckets(const QueueTuning& tuning);

  void Push(uint32_t id, double label);
  uint32_t Pop();
  uint32_t Upcoming(uint32_t k) const {
    const uint64_t at = position_ + k - 1;
    return at < taken_ ? ring_[current_ & kMask].ids[at] : kNothing;
  }

  void MarkVoid() { ++void_; }
  void DropVoid() { --void_; }

  // The lower edge of the first bucket that is not empty.
  double SettledRadius() const { return static_cast<double>(first_) * width_; }
  uint64_t size() const { return entries_ - void_; }
  uint64_t iterations() const { return iterations_; }
  uint64_t bytes() const {
    return ring_bytes_ + beyond_.capacity() * sizeof(Far);
  }

 private:
  static constexpr int64_t kRing = 4096;
  static constexpr int64_t kMask = kRing - 1;

  struct Bucket {
    std::vector<uint32_t> ids;
    uint64_t begin = 0;  // ids before it have been popped
  };
  struct Far {
    int64_t bucket;
    uint32_t id;
  };

  static bool After(const Far& a, const Far& b) {
    return a.bucket != b.bucket ? a.bucket > b.bucket : a.id > b.id;
  }

  int64_t BucketOf(double label) const;
  bool StartIteration();
  // Moves first_ to the first bucket with entries and draws in far ones.
  bool Advance();
  void AdaptBatch();
  void OpenBucket(int64_t bucket);
  void CloseBucket();
  void Append(int64_t bucket, uint32_t id);

  const double inverse_width_;
  const double width_;
  const int64_t max_batch_;

  std::vector<Bucket> ring_{kRing};
  uint64_t ring_bytes_ = kRing * sizeof(Bucket);
  std::vector<Far> beyond_;  // heap by bucket
  uint64_t entries_ = 0;
  uint64_t in_ring_ = 0;
  uint64_t void_ = 0;
  uint64_t iterations_ = 0;

  int64_t first_ = 0;
  int64_t end_ = 0;
  int64_t batch_ = 0;  // K; 0 before the first iteration
  int64_t near_ = 0;
  int64_t far_ = 0;

  // The part of the iteration in hand: bucket current_, entries
  // [position_, taken_) of it; sizes_[b - first bucket] were born earlier.
  int64_t current_ = 0;
  int64_t batch_first_ = 0;
  uint64_t position_ = 0;
  uint64_t taken_ = 0;
  std::vector<uint64_t> sizes_;
};

}  // namespace geodesic

#endif  // GEODESIC_QUEUES_FWP_BUCKETS_H_
