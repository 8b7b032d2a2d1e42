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

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/queues/queue.h"

namespace geodesic {

// Many first-in-first-out lists of 32-bit ids that share their memory. Ids lie
// in chunks of half a cache line, recycled most recently freed first: memory
// goes with what is in the lists at once, not with what each has ever held.
class IdLists {
 public:
  explicit IdLists(size_t lists) : lists_(lists) {}

  void Append(size_t list, uint32_t id) {
    List& ids = lists_[list];
    if (ids.first == kNone) {
      ids.first = ids.last = Allocate();
    } else if (ids.in_last == kIdsPerChunk) {
      const uint32_t chunk = Allocate();
      chunks_[ids.last].next = chunk;
      ids.last = chunk;
      ids.in_last = 0;
    }
    chunks_[ids.last].ids[ids.in_last++] = id;
  }

  // Moves the ids of `list`, in order, to the end of `to`. Returns how many.
  size_t MoveTo(size_t list, std::vector<uint32_t>& to) {
    List& ids = lists_[list];
    const size_t before = to.size();
    for (uint32_t chunk = ids.first; chunk != kNone;) {
      const Chunk& from = chunks_[chunk];
      const bool is_last = chunk == ids.last;
      to.insert(to.end(), from.ids.begin(),
                from.ids.begin() + (is_last ? ids.in_last : kIdsPerChunk));
      const uint32_t next = is_last ? kNone : from.next;
      Free(chunk);
      chunk = next;
    }
    ids = {};
    return to.size() - before;
  }

  uint64_t bytes() const {
    return lists_.capacity() * sizeof(List) +
           chunks_.capacity() * sizeof(Chunk);
  }

 private:
  static constexpr uint32_t kNone = 0xffffffffu;
  static constexpr uint32_t kIdsPerChunk = 7;

  struct alignas(32) Chunk {
    std::array<uint32_t, kIdsPerChunk> ids;
    uint32_t next;  // of the list, or of those that are free
  };
  struct List {
    uint32_t first = kNone;
    uint32_t last = kNone;
    uint32_t in_last = 0;
  };

  uint32_t Allocate() {
    if (free_ == kNone) {
      chunks_.emplace_back();
      return static_cast<uint32_t>(chunks_.size() - 1);
    }
    const uint32_t chunk = free_;
    free_ = chunks_[chunk].next;
    return chunk;
  }
  void Free(uint32_t chunk) {
    chunks_[chunk].next = free_;
    free_ = chunk;
  }

  std::vector<List> lists_;
  std::vector<Chunk> chunks_;
  uint32_t free_ = kNone;  // the first chunk that is free
};

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
  // Forgets all ids, and restarts. O(ids).
  void Clear();

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
  static constexpr int64_t kBits = 64;  // of a word
  static constexpr int64_t kWords = kRing / kBits;

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
  void AddToRing(int64_t bucket, uint32_t id) {
    ring_.Append(bucket & kMask, id);
    Word(bucket) |= Bit(bucket);
    ++in_ring_;
  }
  // Moves the ids of a bucket to the end of the batch.
  void TakeFromRing(int64_t bucket) {
    in_ring_ -= ring_.MoveTo(bucket & kMask, batch_);
    Word(bucket) &= ~Bit(bucket);
  }
  uint64_t& Word(int64_t bucket) { return occupied_[bucket / kBits % kWords]; }
  static uint64_t Bit(int64_t bucket) {
    return uint64_t{1} << static_cast<uint32_t>(bucket % kBits);
  }
  // The first bucket from `bucket` on, of those in the ring, that has entries.
  // REQUIRES: there is one.
  int64_t Occupied(int64_t bucket) const;

  const double inverse_width_;
  const double width_;
  const int64_t max_batch_;
  const bool adaptive_batch_;

  IdLists ring_{kRing};                         // buckets
  std::array<uint64_t, kWords> occupied_ = {};  // a bit for each
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
