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
  Add<kLeft>({left, 0, true});
  Add<kRight>({right, 0, false});
  left_[0] = left;
  right_[0] = right;
  for (uint32_t i = 1; i < count; ++i) {
    const Portal& portal = portals[i];
    along = Product(along, portal.turn);
    const PlanePoint across{portal.length * along.x, portal.length * along.y};
    if (portal.tip_is_left) {
      left = right - across;
      Add<kLeft>({left, i, true});
    } else {
      right = {left.x + across.x, left.y + across.y};
      Add<kRight>({right, i, false});
    }
    left_[i] = left;
    right_[i] = right;
  }
  const PlanePoint to_end = Product(end, along);
  Add<kLeft>({{left.x + to_end.x, left.y + to_end.y}, count, false});
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

template <Side kSide>
void Funnel::Add(const Bend& bend) {
  // On the right all is mirrored.
  constexpr int kOut = kSide == kLeft ? -1 : 1;
  size_t& end = kSide == kLeft ? first_ : last_;
  const size_t other_end = kSide == kLeft ? last_ : first_;
  // How far the bend lies outside a side of a chain.
  const auto outside = [&](size_t begin, size_t to) {
    return -kOut *
           Cross(PointOf(to) - PointOf(begin), bend.at - PointOf(begin));
  };
  // What a straight way from the corner before passes by.
  while (end != apex_ && outside(end - kOut, end) <= 0) end -= kOut;
  if (end == apex_) {
    while (apex_ != other_end && outside(apex_, apex_ - kOut) < 0) {
      apex_ -= kOut;
    }
    end = apex_;
  }
  corners_[corner_count_] = {bend, chain_[end]};
  end += kOut;
  chain_[end] = corner_count_++;
}

}  // namespace geodesic
