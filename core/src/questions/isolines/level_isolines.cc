// The pieces of isolines put together, level by level.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "questions/isolines/level_crossings.h"
#include "surface/surface_location.h"

namespace geodesic {

// Linear: nothing but the edges of few half-edges in a row is sorted.
absl::StatusOr<std::vector<uint32_t>> LevelCrossings::InOrder(
    const Poll& poll) {
  constexpr HalfEdge kInARow = 4096;
  // The ranges of edges, by rows of half-edges.
  std::vector<std::vector<std::pair<HalfEdge, Range>>> rows(
      mesh_.half_edge_count() / kInARow + 1);
  for (const auto& [edge, range] : edges_) {
    if (absl::Status status = Work(1, poll); !status.ok()) return status;
    if (range.begin < range.end) {
      rows[edge / kInARow].push_back({edge, range});
    }
  }
  std::vector<size_t> next(levels_.size() + 1);  // by level, in the order
  for (const Crossing& crossing : crossings_) ++next[crossing.level + 1];
  for (size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  std::vector<uint32_t> in_order(crossings_.size());
  for (auto& row : rows) {
    std::ranges::sort(row, {}, &std::pair<HalfEdge, Range>::first);
    for (const auto& [edge, range] : row) {
      for (size_t c = range.begin; c < range.end; ++c) {
        in_order[next[crossings_[c].level]++] = static_cast<uint32_t>(c);
      }
      absl::Status status = Work(1 + range.end - range.begin, poll);
      if (!status.ok()) return status;
    }
  }
  return in_order;
}

absl::StatusOr<std::vector<Isoline>> LevelCrossings::Isolines(
    std::span<const double> file_levels, const Poll& poll) {
  // The place of each crossing among those of its level.
  const absl::StatusOr<std::vector<uint32_t>> ordered = InOrder(poll);
  if (!ordered.ok()) return ordered.status();
  const std::vector<uint32_t>& in_order = *ordered;
  std::vector<uint32_t> place(crossings_.size());
  std::vector<Isoline> isolines;
  uint32_t begin = 0;
  for (uint32_t level = 0; level < levels_.size(); ++level) {
    uint32_t end = begin;
    for (; end < in_order.size() && crossings_[in_order[end]].level == level;
         ++end) {
      place[in_order[end]] = end - begin;
    }
    std::vector<Segment> segments = segments_[level];
    for (Segment& segment : segments) {
      segment.from = place[segment.from];
      segment.to = place[segment.to];
    }
    absl::Status status = AddIsolines(
        file_levels[level], std::span(in_order).subspan(begin, end - begin),
        segments, poll, isolines);
    // Faces come in any order.
    std::ranges::stable_sort(loops_[level], {}, &Loop::face);
    for (const auto& [face, first, count] : loops_[level]) {
      if (!status.ok()) return status;
      std::vector<SurfacePoint> points;
      for (uint32_t i = first; i < first + count; ++i) {
        points.push_back(PointAt(samples_[i]));
      }
      AddIsoline(file_levels[level], std::move(points), true, isolines);
      status = Work(count, poll);
    }
    if (!status.ok()) return status;
    begin = end;
  }
  return isolines;
}

void LevelCrossings::AddIsoline(double level, std::vector<SurfacePoint> points,
                                bool is_closed,
                                std::vector<Isoline>& isolines) {
  while (is_closed && points.size() > 1 && points.back() == points.front()) {
    points.pop_back();
  }
  if (points.size() < 2) return;
  isoline_bytes_ += points.size() * (sizeof(SurfacePoint) + sizeof(Point));
  std::vector<Point> positions;
  positions.reserve(points.size());
  for (const SurfacePoint& point : points) {
    positions.push_back(PositionOf(point, mesh_));
  }
  isolines.push_back(
      {level, std::move(points), std::move(positions), is_closed});
}

absl::Status LevelCrossings::AddIsolines(double level,
                                         std::span<const uint32_t> of_level,
                                         std::span<const Segment> segments,
                                         const Poll& poll,
                                         std::vector<Isoline>& isolines) {
  const auto count = static_cast<uint32_t>(of_level.size());
  for (const Chain& chain : ChainsOf(count, segments)) {
    std::vector<SurfacePoint> points;
    // An isoline through a vertex crosses several edges there.
    const auto add = [&](const SurfacePoint& point) {
      if (points.empty() || points.back() != point) points.push_back(point);
    };
    for (size_t i = 0; i < chain.crossings.size(); ++i) {
      add(PointAt(crossings_[of_level[chain.crossings[i]]]));
      absl::Status status = Work(1, poll);
      if (!status.ok()) return status;
      if (i == chain.links.size()) continue;
      const auto [number, is_forward] = chain.links[i];
      const Segment& segment = segments[number];
      for (uint32_t k = 0; k < segment.sample_count; ++k) {
        const uint32_t sample = is_forward ? k : segment.sample_count - 1 - k;
        add(PointAt(samples_[segment.first_sample + sample]));
      }
      status = Work(segment.sample_count, poll);
      if (!status.ok()) return status;
    }
    AddIsoline(level, std::move(points), chain.is_closed, isolines);
  }
  return absl::OkStatus();
}

SurfacePoint LevelCrossings::PointAt(const Crossing& crossing) const {
  const auto& [level, edge, x] = crossing;
  const auto [low, high] = std::minmax({mesh_.From(edge), mesh_.To(edge)});
  return NamedIn(
      mesh_.FaceOf(edge),
      Canonicalize(
          EdgePoint{low, high, std::min(x / mesh_.frame(edge).length, 1.0)},
          mesh_),
      mesh_);
}

SurfacePoint LevelCrossings::PointAt(const FacePoint& sample) const {
  return NamedIn(sample.face, Canonicalize(sample, mesh_), mesh_);
}

}  // namespace geodesic
