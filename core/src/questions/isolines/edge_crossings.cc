#include "questions/isolines/edge_crossings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace geodesic {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool IsAt(double level, double distance) {
  return std::abs(distance - level) <= level * kAtLevel;
}

}  // namespace

EdgeCrossings::EdgeCrossings(double level, double length, double p, double q)
    : level_(level), length_(length), p_(p), q_(q) {
  if (IsNearer(p, level)) {
    parts_.push_back({-kInfinity, std::min(level - p, length)});
  }
  if (IsNearer(q, level)) {
    parts_.push_back({std::max(length - (level - q), 0.0), kInfinity});
  }
}

void EdgeCrossings::Add(const Way& way) {
  const std::optional<Interval> part = NearerPart(way, level_);
  if (!part.has_value() || part->end < 0 || part->begin > length_) return;
  parts_.push_back({std::max(part->begin, 0.0), std::min(part->end, length_)});
}

std::vector<double> EdgeCrossings::Find() {
  std::ranges::sort(parts_, {}, &Interval::begin);
  std::vector<Interval> pieces;
  for (const Interval& part : parts_) {
    if (!pieces.empty() &&
        part.begin <= pieces.back().end + kLeastWidth * length_) {
      pieces.back().end = std::max(pieces.back().end, part.end);
    } else {
      pieces.push_back(part);
    }
  }
  const double snap = kNearMiss * length_;
  std::vector<double> crossings;
  for (Interval& piece : pieces) {
    for (double* end : {&piece.begin, &piece.end}) {
      if (*end <= snap && std::isfinite(*end) && IsAt(level_, p_)) *end = 0;
      if (*end >= length_ - snap && std::isfinite(*end) && IsAt(level_, q_)) {
        *end = length_;
      }
    }
    if (!(piece.width() > 0)) continue;
    if (std::isfinite(piece.begin)) crossings.push_back(piece.begin);
    if (std::isfinite(piece.end)) crossings.push_back(piece.end);
  }
  return crossings;
}

}  // namespace geodesic
