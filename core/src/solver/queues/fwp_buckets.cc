#include "solver/queues/fwp_buckets.h"

#include <algorithm>
#include <bit>

namespace geodesic {

FwpBuckets::FwpBuckets(const Tuning& tuning)
    : inverse_width_(1 / tuning.bucket_width),
      width_(tuning.bucket_width),
      max_batch_(tuning.max_batch),
      adaptive_batch_(tuning.adaptive_batch) {}

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
    AddToRing(bucket, id);
  } else {
    beyond_.push_back({bucket, id});
    std::push_heap(beyond_.begin(), beyond_.end(), After());
  }
}

void FwpBuckets::Clear() {
  batch_.clear();
  while (in_ring_ > 0) TakeFromRing(Occupied(first_));
  batch_.clear();
  beyond_.clear();
  next_ = 0;
  entries_ = iterations_ = 0;
  Restart();
}

bool FwpBuckets::StartIteration() {
  if (entries_ == 0) return false;
  Advance();
  SetLeast();
  ++iterations_;
  batch_.clear();
  next_ = 0;
  // The ring holds every bucket below first_ + kRing, and no iteration reaches
  // further.
  end_ = first_;
  while (in_ring_ > 0 && static_cast<int64_t>(batch_.size()) < least_) {
    const int64_t bucket = Occupied(end_);
    TakeFromRing(bucket);
    end_ = bucket + 1;
  }
  return true;
}

int64_t FwpBuckets::Occupied(int64_t bucket) const {
  const auto from = static_cast<uint32_t>(bucket % kBits);
  int64_t word = bucket / kBits;
  uint64_t bits = occupied_[word % kWords] >> from << from;
  while (bits == 0) bits = occupied_[++word % kWords];
  return word * kBits + std::countr_zero(bits);
}

void FwpBuckets::SetLeast() {
  // The first K is the whole front of the seeds: c_large starts as its size.
  least_ += iterations_ == 0 ? far_ : far_ - near_;
  if (!adaptive_batch_) least_ = max_batch_;
  const int64_t most =
      std::min(std::max(static_cast<int64_t>(size()), int64_t{1}), max_batch_);
  least_ = std::clamp(least_, int64_t{1}, most);
  near_ = far_ = 0;
}

void FwpBuckets::Advance() {
  first_ = in_ring_ > 0 ? Occupied(first_) : beyond_.front().bucket;
  while (!beyond_.empty() && beyond_.front().bucket < first_ + kRing) {
    AddToRing(beyond_.front().bucket, beyond_.front().id);
    std::pop_heap(beyond_.begin(), beyond_.end(), After());
    beyond_.pop_back();
  }
}

}  // namespace geodesic
