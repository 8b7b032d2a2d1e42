#include "questions/isolines/level_crossings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "surface/surface_location.h"

namespace geodesic {
namespace {

struct Chain {
  std::vector<uint32_t> crossings;
  bool is_closed = false;  // its last crossing is followed by the first
};

// Puts all segments between the crossings 0 .. crossing_count - 1 together,
// each in one chain: first the open chains, then the closed ones, each kind in
// order of its first crossing. Chains end where other than two segments meet.
// They run as their segments do, but where segments that run against each other
// meet; closed ones begin at their least crossing.
class Chaining {
 public:
  Chaining(uint32_t crossing_count, std::span<const Segment> segments)
      : segments_(segments),
        begin_(crossing_count + 1, 0),
        incident_(2 * segments.size()),
        is_used_(segments.size()) {
    for (const Segment& s : segments) {
      ++begin_[s.from + 1];
      ++begin_[s.to + 1];
    }
    for (uint32_t c = 0; c < crossing_count; ++c) begin_[c + 1] += begin_[c];
    std::vector<uint32_t> fill(begin_.begin(), begin_.end() - 1);
    for (uint32_t s = 0; s < segments.size(); ++s) {
      incident_[fill[segments[s].from]++] = s;
      incident_[fill[segments[s].to]++] = s;
    }
  }

  std::vector<Chain> Run() {
    const auto count = static_cast<uint32_t>(begin_.size() - 1);
    for (const bool outgoing_alone : {true, false}) {
      for (uint32_t c = 0; c < count; ++c) {
        if (Incident(c).size() != 2) WalkFrom(c, outgoing_alone);
      }
    }
    for (const bool outgoing_alone : {true, false}) {
      for (uint32_t c = 0; c < count; ++c) WalkFrom(c, outgoing_alone);
    }
    return std::move(chains_);
  }

 private:
  std::span<const uint32_t> Incident(uint32_t crossing) const {
    return std::span(incident_).subspan(
        begin_[crossing], begin_[crossing + 1] - begin_[crossing]);
  }

  // Walks along each segment that is left here.
  void WalkFrom(uint32_t start, bool outgoing_alone) {
    for (const uint32_t first : Incident(start)) {
      if (is_used_[first]) continue;
      if (outgoing_alone && segments_[first].from != start) continue;
      Walk(start, first);
    }
  }

  void Walk(uint32_t start, uint32_t segment) {
    Chain& chain = chains_.emplace_back();
    chain.crossings = {start};
    for (uint32_t at = start;;) {
      is_used_[segment] = true;
      const auto [from, to] = segments_[segment];
      at = at == from ? to : from;
      if (at == start) {
        chain.is_closed = true;
        return;
      }
      chain.crossings.push_back(at);
      const std::span<const uint32_t> incident = Incident(at);
      if (incident.size() != 2) return;
      segment = incident[0] == segment ? incident[1] : incident[0];
    }
  }

  std::span<const Segment> segments_;
  std::vector<uint32_t> begin_;  // into incident_, of each crossing
  std::vector<uint32_t> incident_;
  std::vector<bool> is_used_;
  std::vector<Chain> chains_;
};

}  // namespace

LevelCrossings::LevelCrossings(const Mesh& mesh,
                               std::span<const Anchor> anchors,
                               std::span<const double> levels,
                               IsolineBand& band)
    : mesh_(mesh), levels_(levels), band_(band), segments_(levels.size()) {
  for (const Anchor& anchor : anchors) {
    const double sigma = std::ldexp(anchor.offset, -mesh.scale_exponent());
    if (anchor.is_segment) {
      for (const CurveSegment& segment : SegmentsOf(mesh, anchor)) {
        within_[segment.face()].segments.push_back({segment, sigma});
      }
    } else if (!std::holds_alternative<VertexPoint>(anchor.begin)) {
      for (const FacePoint& point : FacesAround(mesh, anchor.begin)) {
        within_[point.face].points.push_back({point, sigma});
      }
    }
  }
}

absl::Status LevelCrossings::Settle(std::span<const double> distances,
                                    double settled, const Poll& poll) {
  absl::Status status;
  std::erase_if(band_.faces(), [&](uint32_t face) {
    if (!status.ok()) return false;
    const HalfEdge first = mesh_.FirstSide(face);
    for (HalfEdge h = first; h < first + 3; ++h) {
      if (!(Farthest(h, distances) <= settled)) return false;
    }
    status = DealWith(face, distances, poll);
    return true;
  });
  return status;
}

absl::Status LevelCrossings::Finish(std::span<const double> distances,
                                    const Poll& poll) {
  for (uint32_t face = 0; face < mesh_.face_count(); ++face) {
    if (band_.IsClosed(face)) continue;
    // What crosses a face comes from one of its corners, from a source in it or
    // through it.
    const auto& [a, b, c] = mesh_.triangle(face);
    if (std::min({distances[a], distances[b], distances[c]}) >=
            levels_.back() &&
        !band_.HasWindows(face) && !within_.contains(face)) {
      continue;
    }
    if (absl::Status status = DealWith(face, distances, poll); !status.ok()) {
      return status;
    }
  }
  return absl::OkStatus();
}

double LevelCrossings::Farthest(HalfEdge h,
                                std::span<const double> distances) const {
  // An end at the level counts as beyond it, whatever rounding says.
  return (distances[mesh_.From(h)] + distances[mesh_.To(h)] +
          mesh_.frame(h).length) /
         2 * (1 + 4 * kAtLevel);
}

LevelCrossings::Range LevelCrossings::LevelsOn(
    HalfEdge h, std::span<const double> distances) const {
  // Unknown distances lie above the last level.
  const double from = std::min(distances[mesh_.From(h)], levels_.back());
  const double to = std::min(distances[mesh_.To(h)], levels_.back());
  const double nearest = (from + to - mesh_.frame(h).length) / 2;
  const auto begin =
      std::ranges::lower_bound(levels_, nearest * (1 - kDominance));
  const auto end = std::ranges::upper_bound(levels_, Farthest(h, distances));
  return {static_cast<size_t>(begin - levels_.begin()),
          static_cast<size_t>(std::max(begin, end) - levels_.begin())};
}

std::vector<Way> LevelCrossings::WaysTo(
    std::span<const HalfEdge> sides, uint32_t from,
    std::span<const double> distances) const {
  std::vector<Way> ways;
  for (const HalfEdge h : sides) {
    const HalfEdgeFrame& frame = mesh_.frame(h);
    const bool is_forward = mesh_.From(h) == from;
    const auto add = [&](const Way& way) {
      ways.push_back(is_forward ? way : Mirror(way, frame.length));
    };
    band_.ForEach(h, add);
    const double apex = distances[mesh_.Apex(h)];
    if (apex < levels_.back()) {
      add({{0, frame.length}, {frame.apex_x, frame.apex_y, apex}});
    }
    if (const auto found = within_.find(mesh_.FaceOf(h));
        found != within_.end()) {
      for (const auto& [point, sigma] : found->second.points) {
        const PlanePoint at = InFrame(mesh_, point, h);
        add({{0, frame.length}, {at.x, std::max(at.y, kLeastHeight), sigma}});
      }
      for (const auto& [segment, sigma] : found->second.segments) {
        const auto way = GoFromSegment(h, mesh_, segment, sigma);
        if (way.has_value()) add(*way);
      }
    }
    if (sides.size() > 1) continue;
    // No window leaves through a boundary.
    for (const HalfEdge entry : {Next(h), Prev(h)}) {
      band_.ForEach(entry, [&](const Way& way) {
        const std::optional<Way> on = GoOnTo(h, mesh_, entry, way);
        if (on.has_value()) add(Mirror(*on, frame.length));
      });
    }
  }
  return ways;
}

LevelCrossings::Range LevelCrossings::CrossingsOf(
    HalfEdge h, std::span<const double> distances) {
  const auto [low, high] = std::minmax({mesh_.From(h), mesh_.To(h)});
  const std::vector<HalfEdge> sides = SidesOf(mesh_, low, high);
  const HalfEdge edge = *std::ranges::min_element(sides);
  const auto [known, is_new] = edges_.try_emplace(edge);
  if (!is_new) return known->second;
  Range& range = known->second;
  range.begin = range.end = crossings_.size();
  const auto [begin, end] = LevelsOn(h, distances);
  if (begin == end) return range;
  const std::vector<Way> ways = WaysTo(sides, low, distances);
  for (size_t level = begin; level < end; ++level) {
    for (const double x :
         CrossingsOfEdge(levels_[level], mesh_.frame(h).length, distances[low],
                         distances[high], ways)) {
      crossings_.push_back({static_cast<uint32_t>(level), edge, x});
    }
  }
  range.end = crossings_.size();
  return range;
}

absl::Status LevelCrossings::DealWith(uint32_t face,
                                      std::span<const double> distances,
                                      const Poll& poll) {
  std::array<Range, 3> ranges;
  uint32_t first = std::numeric_limits<uint32_t>::max(), last = 0;
  for (uint32_t side = 0; side < 3; ++side) {
    ranges[side] = CrossingsOf(mesh_.FirstSide(face) + side, distances);
    const auto& [begin, end] = ranges[side];
    if (begin == end) continue;
    first = std::min(first, crossings_[begin].level);
    last = std::max(last, crossings_[end - 1].level);
  }
  for (uint32_t level = first; level <= last; ++level) {
    JoinCrossings(face, level, ranges, distances);
  }
  band_.Close(face);
  constexpr uint64_t kFacesBetweenPolls = 64;
  return ++dealt_with_ % kFacesBetweenPolls == 0 ? poll() : absl::OkStatus();
}

void LevelCrossings::JoinCrossings(uint32_t face, uint32_t level,
                                   const std::array<Range, 3>& ranges,
                                   std::span<const double> distances) {
  std::vector<PerimeterCrossing> perimeter;
  for (uint32_t side = 0; side < 3; ++side) {
    const HalfEdge h = mesh_.FirstSide(face) + side;
    const auto& [begin, end] = ranges[side];
    const bool is_forward = mesh_.From(h) < mesh_.To(h);
    for (size_t i = 0; i < end - begin; ++i) {
      const size_t c = is_forward ? begin + i : end - 1 - i;
      if (crossings_[c].level != level) continue;
      const double along = crossings_[c].x / mesh_.frame(h).length;
      perimeter.push_back(
          {side + (is_forward ? along : 1 - along), static_cast<uint32_t>(c)});
    }
  }
  if (perimeter.empty()) return;
  const uint32_t corner = mesh_.triangle(face)[0];
  FaceRegions regions(std::move(perimeter),
                      IsNearer(distances[corner], levels_[level]));
  if (regions.arc_count() > 1) {
    WaysInto(face, distances).JoinRegions(levels_[level], regions);
  }
  std::ranges::copy(regions.Segments(), std::back_inserter(segments_[level]));
}

FaceWays LevelCrossings::WaysInto(uint32_t face,
                                  std::span<const double> distances) const {
  FaceWays ways(mesh_, face);
  const HalfEdge first = mesh_.FirstSide(face);
  for (HalfEdge h = first; h < first + 3; ++h) {
    band_.ForEach(h, [&](const Way& way) { ways.AddThrough(h, way); });
    FacePoint corner{.face = face};
    corner.weights[h % 3] = 1;
    ways.AddWithin(InFrame(mesh_, corner, first), distances[mesh_.From(h)]);
  }
  if (const auto found = within_.find(face); found != within_.end()) {
    for (const auto& [point, sigma] : found->second.points) {
      ways.AddWithin(InFrame(mesh_, point, first), sigma);
    }
    for (const auto& [segment, sigma] : found->second.segments) {
      ways.AddWithin(segment, sigma);
    }
  }
  return ways;
}

SurfacePoint LevelCrossings::PointAt(const Crossing& crossing) const {
  const auto& [level, edge, x] = crossing;
  const auto [low, high] = std::minmax({mesh_.From(edge), mesh_.To(edge)});
  return Canonicalize(
      EdgePoint{low, high, std::min(x / mesh_.frame(edge).length, 1.0)}, mesh_);
}

std::vector<Isoline> LevelCrossings::Isolines(
    std::span<const double> file_levels) const {
  // The crossings in order of levels, of edges and along these; the place of
  // each among those of its level.
  std::vector<uint32_t> in_order(crossings_.size());
  std::iota(in_order.begin(), in_order.end(), 0u);
  std::ranges::sort(in_order, {}, [&](uint32_t c) {
    const auto& [level, edge, x] = crossings_[c];
    return std::tuple(level, edge, x);
  });
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
    for (auto& [from, to] : segments) {
      from = place[from];
      to = place[to];
    }
    AddIsolines(file_levels[level],
                std::span(in_order).subspan(begin, end - begin), segments,
                isolines);
    begin = end;
  }
  return isolines;
}

void LevelCrossings::AddIsolines(double level,
                                 std::span<const uint32_t> of_level,
                                 std::span<const Segment> segments,
                                 std::vector<Isoline>& isolines) const {
  const auto count = static_cast<uint32_t>(of_level.size());
  for (const auto& [crossings, is_closed] : Chaining(count, segments).Run()) {
    std::vector<SurfacePoint> points;
    // An isoline through a vertex crosses several edges there.
    for (const uint32_t c : crossings) {
      const SurfacePoint point = PointAt(crossings_[of_level[c]]);
      if (points.empty() || points.back() != point) points.push_back(point);
    }
    while (is_closed && points.size() > 1 && points.back() == points.front()) {
      points.pop_back();
    }
    if (points.size() < 2) continue;
    std::vector<Point> positions;
    for (const SurfacePoint& point : points) {
      positions.push_back(PositionOf(point, mesh_));
    }
    isolines.push_back(
        {level, std::move(points), std::move(positions), is_closed});
  }
}

uint64_t LevelCrossings::bytes() const {
  uint64_t bytes = crossings_.capacity() * sizeof(Crossing) +
                   edges_.capacity() * sizeof(std::pair<HalfEdge, Range>);
  for (const auto& segments : segments_) {
    bytes += segments.capacity() * sizeof(Segment);
  }
  return bytes;
}

}  // namespace geodesic
