#include "solver/queues/label_correcting.h"

#include <algorithm>
#include <limits>

namespace geodesic {
namespace {

// Where the threshold goes between the least (0) and the mean (1) of the far
// labels: Glover et al. leave the weight to the user. At 1 half the wavefront
// enters at once, and a tenth more windows are propagated.
constexpr double kThresholdWeight = 0.5;

}  // namespace

void LabelCorrecting::Push(uint32_t id, double label) {
  if (label <= threshold_) {
    PushNear({label, id});
  } else {
    far_.push_back({label, id});
  }
}

void LabelCorrecting::PushNear(const Entry& entry) {
  if (!near_.empty() && entry.label < near_.front().label) {
    near_.push_front(entry);
  } else {
    near_.push_back(entry);
  }
  near_sum_ += entry.label;
}

uint32_t LabelCorrecting::Pop() {
  if (near_.empty() && !RaiseThreshold()) return kNothing;
  // Some label is not above the mean; the count is for sums that rounded down.
  const double mean = near_sum_ / static_cast<double>(near_.size());
  for (size_t i = 1; i < near_.size() && near_.front().label > mean; ++i) {
    near_.push_back(near_.front());
    near_.pop_front();
  }
  const Entry first = near_.front();
  near_.pop_front();
  near_sum_ -= first.label;
  return first.id;
}

bool LabelCorrecting::RaiseThreshold() {
  if (far_.empty()) return false;
  double least = std::numeric_limits<double>::infinity();
  double sum = 0;
  for (const Entry& entry : far_) {
    least = std::min(least, entry.label);
    sum += entry.label;
  }
  const double mean = sum / static_cast<double>(far_.size());
  threshold_ = std::max(least, least + kThresholdWeight * (mean - least));
  settled_ = std::max(settled_, least);
  near_sum_ = 0;
  size_t kept = 0;
  for (const Entry& entry : far_) {
    if (entry.label <= threshold_) {
      PushNear(entry);
    } else {
      far_[kept++] = entry;
    }
  }
  far_.resize(kept);
  ++iterations_;
  return true;
}

}  // namespace geodesic
