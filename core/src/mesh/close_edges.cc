#include "mesh/close_edges.h"

#include <algorithm>
#include <cmath>

namespace geodesic {
namespace {

constexpr uint32_t kNone = 0xffffffffu;

// Some milliseconds.
constexpr uint64_t kBetweenPolls = uint64_t{1} << 16;

// The numbers of cubes along an axis stay exact.
constexpr double kMostCubes = 0x1p50;

// For the rounding of middles and cubes.
constexpr double kMargin = 1.25;

// The larger, the fewer cubes a search looks into, and the more lies in them.
constexpr double kReachesPerCube = 4;

absl::Status PollAt(uint64_t i, Checkpoint& checkpoint) {
  return i % kBetweenPolls == 0 ? checkpoint.Poll({}) : absl::OkStatus();
}

}  // namespace

double Distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

absl::StatusOr<CloseEdges> CloseEdges::Make(std::span<const Point> positions,
                                            std::span<const VertexPair> edges,
                                            const Closeness& closeness,
                                            Checkpoint& checkpoint) {
  CloseEdges made(positions, edges, closeness);
  absl::Status status = made.Measure(checkpoint);
  if (status.ok()) status = made.Sort(checkpoint);
  if (!status.ok()) return status;
  return made;
}

absl::Status CloseEdges::Measure(Checkpoint& checkpoint) {
  double longest = 0, farthest = 0;
  for (size_t i = 0; i < edges_.size(); ++i) {
    if (absl::Status status = PollAt(i, checkpoint); !status.ok()) {
      return status;
    }
    const Point& a = positions_[edges_[i].low];
    const Point& b = positions_[edges_[i].high];
    longest = std::max(longest, Distance(a, b));
    for (int axis = 0; axis < 3; ++axis) {
      farthest = std::max({farthest, std::abs(a[axis]), std::abs(b[axis])});
    }
  }
  reach_ = kMargin *
           std::max({std::min(closeness_.distance, closeness_.part * longest),
                     farthest / kMostCubes, 1e-300});
  side_ = kReachesPerCube * reach_;
  return absl::OkStatus();
}

absl::Status CloseEdges::Sort(Checkpoint& checkpoint) {
  before_.assign(edges_.size(), kNone);
  last_.reserve(edges_.size());
  for (uint32_t i = 0; i < edges_.size(); ++i) {
    if (absl::Status status = PollAt(i, checkpoint); !status.ok()) {
      return status;
    }
    const auto [entry, is_new] =
        last_.try_emplace(CubeOf(Middle(edges_[i])), i);
    if (!is_new) {
      before_[i] = entry->second;
      entry->second = i;
    }
  }
  return absl::OkStatus();
}

absl::Status CloseEdges::Find(uint32_t edge, Checkpoint& checkpoint,
                              std::vector<ClosePair>& pairs, uint32_t most) {
  // Most that are in reach lie in the same cube.
  const Point middle = Middle(edges_[edge]);
  const Point low =
      CubeOf({middle[0] - reach_, middle[1] - reach_, middle[2] - reach_});
  const Point high =
      CubeOf({middle[0] + reach_, middle[1] + reach_, middle[2] + reach_});
  for (int step = 0; step < 8; ++step) {
    Point cube;
    bool is_new = true;
    for (int axis = 0; axis < 3; ++axis) {
      const bool is_high = (step >> axis & 1) != 0;
      is_new &= !is_high || high[axis] != low[axis];
      cube[axis] = is_high ? high[axis] : low[axis];
    }
    if (!is_new) continue;
    const auto found = last_.find(cube);
    if (found == last_.end()) continue;
    for (uint32_t other = found->second; other != kNone;
         other = before_[other]) {
      if (absl::Status s = PollAt(++compared_, checkpoint); !s.ok()) return s;
      if (other == edge) continue;
      if (most-- == 0) return absl::OkStatus();
      Compare(edge, other, pairs);
    }
  }
  return absl::OkStatus();
}

Point CloseEdges::Middle(const VertexPair& edge) const {
  Point middle;
  for (int axis = 0; axis < 3; ++axis) {
    middle[axis] =
        positions_[edge.low][axis] / 2 + positions_[edge.high][axis] / 2;
  }
  return middle;
}

Point CloseEdges::CubeOf(const Point& point) const {
  return {std::floor(point[0] / side_) + 0.0,
          std::floor(point[1] / side_) + 0.0,
          std::floor(point[2] / side_) + 0.0};
}

void CloseEdges::Compare(uint32_t edge, uint32_t other,
                         std::vector<ClosePair>& pairs) {
  const auto at = [&](uint32_t v) -> const Point& { return positions_[v]; };
  const auto& [a, b] = edges_[edge];
  const auto& [c, d] = edges_[other];
  const double straight =
      std::max(Distance(at(a), at(c)), Distance(at(b), at(d)));
  const double turned =
      std::max(Distance(at(a), at(d)), Distance(at(b), at(c)));
  const double distance = std::min(straight, turned);
  const double length =
      std::min(Distance(at(a), at(b)), Distance(at(c), at(d)));
  // Edges without length are points.
  if (length > 0 && distance <= closeness_.distance &&
      distance <= closeness_.part * length) {
    pairs.push_back({.first = edge,
                     .second = other,
                     .is_turned = turned < straight,
                     .distance = distance});
  }
}

}  // namespace geodesic
