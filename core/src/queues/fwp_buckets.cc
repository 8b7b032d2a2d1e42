#include "queues/fwp_buckets.h"

#include <algorithm>

namespace geodesic {

FwpBuckets::FwpBuckets(const QueueTuning& tuning)
    : inverse_width_(1 / tuning.bucket_width),
      width_(tuning.bucket_width),
      max_batch_(tuning.max_batch) {}

int64_t FwpBuckets::BucketOf(double label) const {
  constexpr double kLast = 4e18;  // within int64_t
  const int64_t bucket =
      static_cast<int64_t>(std::min(label * inverse_width_, kLast));
  return std::max(bucket, first_);
}

void FwpBuckets::Push(uint32_t id, double label) {
  const int64_t bucket = BucketOf(label);
  ++entries_;
  ++(bucket < end_ ? near_ : far_);
  if (bucket < first_ + kRing) {
    Append(bucket, id);
  } else {
    beyond_.push_back({bucket, id});
    std::push_heap(beyond_.begin(), beyond_.end(), After);
  }
}

void FwpBuckets::Append(int64_t bucket, uint32_t id) {
  std::vector<uint32_t>& ids = ring_[bucket & kMask].ids;
  const size_t before = ids.capacity();
  ids.push_back(id);
  ring_bytes_ += (ids.capacity() - before) * sizeof(uint32_t);
  ++in_ring_;
}

uint32_t FwpBuckets::Pop() {
  while (position_ == taken_) {
    CloseBucket();
    if (current_ + 1 < end_) {
      OpenBucket(current_ + 1);
    } else if (!StartIteration()) {
      return kNothing;
    }
  }
  --entries_;
  --in_ring_;
  Bucket& bucket = ring_[current_ & kMask];
  ++bucket.begin;
  return bucket.ids[position_++];
}

void FwpBuckets::OpenBucket(int64_t bucket) {
  current_ = bucket;
  position_ = ring_[bucket & kMask].begin;
  taken_ = position_ + sizes_[bucket - batch_first_];
}

void FwpBuckets::CloseBucket() {
  Bucket& bucket = ring_[current_ & kMask];
  if (bucket.begin < bucket.ids.size()) return;
  bucket.ids.clear();
  bucket.begin = 0;
}

bool FwpBuckets::Advance() {
  if (entries_ == 0) return false;
  if (in_ring_ == 0) first_ = beyond_.front().bucket;
  for (;; ++first_) {
    while (!beyond_.empty() && beyond_.front().bucket < first_ + kRing) {
      std::pop_heap(beyond_.begin(), beyond_.end(), After);
      Append(beyond_.back().bucket, beyond_.back().id);
      beyond_.pop_back();
    }
    if (!ring_[first_ & kMask].ids.empty()) return true;
  }
}

void FwpBuckets::AdaptBatch() {
  // The first K is the whole front of the seeds (trap 3).
  batch_ += iterations_ == 0 ? far_ : far_ - near_;
  const int64_t most = std::min(std::max<int64_t>(size(), 1), max_batch_);
  batch_ = std::clamp<int64_t>(batch_, 1, most);
  near_ = far_ = 0;
}

bool FwpBuckets::StartIteration() {
  if (!Advance()) return false;
  AdaptBatch();
  ++iterations_;
  sizes_.clear();
  int64_t counted = 0;
  // Beyond the ring's reach nothing is counted: the ring holds every bucket
  // below first_ + kRing.
  for (end_ = first_; counted < batch_ && end_ < first_ + kRing; ++end_) {
    const Bucket& bucket = ring_[end_ & kMask];
    sizes_.push_back(bucket.ids.size() - bucket.begin);
    counted += static_cast<int64_t>(sizes_.back());
    if (counted == static_cast<int64_t>(in_ring_)) {
      ++end_;
      break;
    }
  }
  batch_first_ = first_;
  OpenBucket(first_);
  return true;
}

}  // namespace geodesic
