#include "questions/first_path/funnel.h"

#include <algorithm>

namespace geodesic {

void Funnel::Find(std::span<const Portal> portals, const PlanePoint& begin,
                  const PlanePoint& end) {
  const auto count = static_cast<uint32_t>(portals.size());
  left_.resize(count);
  right_.resize(count);
  corners_.resize(2 * count + 2);
  corners_[0] = {{begin, 0, false}, 0};
  corner_count_ = 1;
  chain_.resize(2 * count + 3);
  first_ = apex_ = last_ = count + 1;
  chain_[apex_] = 0;
  PlanePoint along{1, 0};  // the portal
  PlanePoint left{0, 0}, right{portals[0].length, 0};
  AddLeft({left, 0, true});
  AddRight({right, 0, false});
  left_[0] = left;
  right_[0] = right;
  for (uint32_t i = 1; i < count; ++i) {
    const Portal& portal = portals[i];
    along = {along.x * portal.turn.x - along.y * portal.turn.y,
             along.x * portal.turn.y + along.y * portal.turn.x};
    const PlanePoint across{portal.length * along.x, portal.length * along.y};
    if (portal.tip_is_left) {
      left = right - across;
      AddLeft({left, i, true});
    } else {
      right = {left.x + across.x, left.y + across.y};
      AddRight({right, i, false});
    }
    left_[i] = left;
    right_[i] = right;
  }
  AddLeft({{left.x + end.x * along.x - end.y * along.y,
            left.y + end.x * along.y + end.y * along.x},
           count,
           false});
  bends_.clear();
  for (uint32_t k = corner_count_ - 1; k != 0; k = corners_[k].before) {
    bends_.push_back(corners_[k].bend);
  }
  std::ranges::reverse(bends_);
}

uint64_t Funnel::bytes() const {
  return (left_.capacity() + right_.capacity()) * sizeof(PlanePoint) +
         corners_.capacity() * sizeof(Corner) +
         chain_.capacity() * sizeof(uint32_t) +
         bends_.capacity() * sizeof(Bend);
}

void Funnel::AddLeft(const Bend& bend) {
  // What a straight way from the corner before passes on its left.
  while (first_ < apex_ && Cross(PointOf(first_) - PointOf(first_ + 1),
                                 bend.at - PointOf(first_ + 1)) <= 0) {
    ++first_;
  }
  if (first_ == apex_) {
    while (apex_ < last_ && Cross(PointOf(apex_ + 1) - PointOf(apex_),
                                  bend.at - PointOf(apex_)) < 0) {
      ++apex_;
    }
    first_ = apex_;
  }
  corners_[corner_count_] = {bend, chain_[first_]};
  chain_[--first_] = corner_count_++;
}

void Funnel::AddRight(const Bend& bend) {
  while (last_ > apex_ && Cross(PointOf(last_) - PointOf(last_ - 1),
                                bend.at - PointOf(last_ - 1)) >= 0) {
    --last_;
  }
  if (last_ == apex_) {
    while (apex_ > first_ && Cross(PointOf(apex_ - 1) - PointOf(apex_),
                                   bend.at - PointOf(apex_)) > 0) {
      --apex_;
    }
    last_ = apex_;
  }
  corners_[corner_count_] = {bend, chain_[last_]};
  chain_[++last_] = corner_count_++;
}

}  // namespace geodesic
