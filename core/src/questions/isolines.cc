// The isolines of exact distances. On an edge distance is the least over the
// windows on both its sides, the ways along it from its ends and those straight
// from sources in the faces around: in closed form, so crossings are exact.

#include "geodesic/isolines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"
#include "questions/isolines/face_regions.h"
#include "questions/isolines/face_ways.h"
#include "questions/isolines/isoline_band.h"
#include "questions/isolines/way.h"
#include "solver/accuracy.h"
#include "solver/curve_segment.h"
#include "solver/start_computation.h"
#include "surface/anchors.h"
#include "surface/surface_location.h"
#include "tolerances.h"

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

// Where levels of the distance cross the edges of a mesh, and which crossings
// are joined across its faces.
//
// Gathers the crossings face by face, as soon as a face is settled. All lengths
// are in the mesh's scaled unit.
class LevelCrossings {
 public:
  // `levels` rise and outlive this object, as does `band`, which hears of all
  // windows.
  LevelCrossings(const Mesh& mesh, std::span<const Anchor> anchors,
                 std::span<const double> levels, IsolineBand& band)
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

  // Called after every few faces, and every few levels in a face.
  using Poll = std::function<absl::Status()>;

  // Deals with the faces that have windows and lie wholly within `settled`,
  // and lets the band forget them.
  // Errors: whatever `poll` returns; this object is of no use then.
  absl::Status Settle(std::span<const double> distances, double settled,
                      const Poll& poll) {
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

  // Deals with all other faces. Distances above the last level may be missing
  // (infinite).
  // Errors: as Settle.
  absl::Status Finish(std::span<const double> distances, const Poll& poll) {
    for (uint32_t face = 0; face < mesh_.face_count(); ++face) {
      if (mesh_.IsLeftOut(face) || band_.IsClosed(face)) continue;
      // What crosses a face comes from one of its corners, from a source in it
      // or through it.
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

  // The isolines, level by level; of each the open ones first. `file_levels`
  // are the levels in the unit of the file. REQUIRES: Finish is OK.
  std::vector<Isoline> Isolines(std::span<const double> file_levels) const {
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

  uint64_t bytes() const {
    uint64_t bytes = crossings_.capacity() * sizeof(Crossing) +
                     edges_.capacity() * sizeof(std::pair<HalfEdge, Range>);
    for (const auto& segments : segments_) {
      bytes += segments.capacity() * sizeof(Segment);
    }
    return bytes;
  }

 private:
  struct Crossing {
    uint32_t level;
    HalfEdge edge;  // the lowest half-edge of the edge
    double x;       // from the end with the lower number
  };
  // Of crossings_: those of an edge, by level, in order along it. Or of
  // levels_.
  struct Range {
    size_t begin = 0;
    size_t end = 0;
  };
  // What starts in one face, and its distance there.
  struct Within {
    std::vector<std::pair<FacePoint, double>> points;
    std::vector<std::pair<CurveSegment, double>> segments;
  };

  double Farthest(HalfEdge h, std::span<const double> distances) const {
    // An end at the level counts as beyond it, whatever rounding says.
    return (distances[mesh_.From(h)] + distances[mesh_.To(h)] +
            mesh_.frame(h).length) /
           2 * (1 + 4 * kAtLevel);
  }

  // The levels that may be found on an edge.
  Range LevelsOn(HalfEdge h, std::span<const double> distances) const {
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

  Range CrossingsOf(HalfEdge h, std::span<const double> distances) {
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
           CrossingsOfEdge(levels_[level], mesh_.frame(h).length,
                           distances[low], distances[high], ways)) {
        crossings_.push_back({static_cast<uint32_t>(level), edge, x});
      }
    }
    range.end = crossings_.size();
    return range;
  }

  // All ways to the points of an edge but those along it from its ends, as seen
  // from its end `from`.
  std::vector<Way> WaysTo(std::span<const HalfEdge> sides, uint32_t from,
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

  absl::Status DealWith(uint32_t face, std::span<const double> distances,
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
    constexpr uint64_t kStepsBetweenPolls = 64;
    const auto step = [&] {
      return ++steps_ % kStepsBetweenPolls == 0 ? poll() : absl::OkStatus();
    };
    for (uint32_t level = first; level <= last; ++level) {
      JoinCrossings(face, level, ranges, distances);
      if (absl::Status status = step(); !status.ok()) return status;
    }
    band_.Close(face);
    return step();
  }

  // Those of a range of crossings_ that are at the level.
  Range AtLevel(const Range& range, uint32_t level) const {
    const auto all =
        std::span(crossings_).subspan(range.begin, range.end - range.begin);
    const auto first = std::partition_point(
        all.begin(), all.end(),
        [level](const Crossing& crossing) { return crossing.level < level; });
    const auto last = std::partition_point(
        first, all.end(),
        [level](const Crossing& crossing) { return crossing.level == level; });
    return {range.begin + static_cast<size_t>(first - all.begin()),
            range.begin + static_cast<size_t>(last - all.begin())};
  }

  void JoinCrossings(uint32_t face, uint32_t level,
                     const std::array<Range, 3>& ranges,
                     std::span<const double> distances) {
    std::vector<PerimeterCrossing> perimeter;
    for (uint32_t side = 0; side < 3; ++side) {
      const HalfEdge h = mesh_.FirstSide(face) + side;
      const auto [begin, end] = AtLevel(ranges[side], level);
      const bool is_forward = mesh_.From(h) < mesh_.To(h);
      for (size_t i = 0; i < end - begin; ++i) {
        const size_t c = is_forward ? begin + i : end - 1 - i;
        const double along = crossings_[c].x / mesh_.frame(h).length;
        perimeter.push_back({side + (is_forward ? along : 1 - along),
                             static_cast<uint32_t>(c)});
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

  FaceWays WaysInto(uint32_t face, std::span<const double> distances) const {
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

  // Adds the isolines that `segments` make between the crossings of one level.
  void AddIsolines(double level, std::span<const uint32_t> of_level,
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
      while (is_closed && points.size() > 1 &&
             points.back() == points.front()) {
        points.pop_back();
      }
      if (points.size() < 2) continue;
      std::vector<Point> positions;
      positions.reserve(points.size());
      for (const SurfacePoint& point : points) {
        positions.push_back(PositionOf(point, mesh_));
      }
      isolines.push_back(
          {level, std::move(points), std::move(positions), is_closed});
    }
  }

  SurfacePoint PointAt(const Crossing& crossing) const {
    const auto& [level, edge, x] = crossing;
    const auto [low, high] = std::minmax({mesh_.From(edge), mesh_.To(edge)});
    return Canonicalize(
        EdgePoint{low, high, std::min(x / mesh_.frame(edge).length, 1.0)},
        mesh_);
  }

  const Mesh& mesh_;
  const std::span<const double> levels_;
  IsolineBand& band_;
  // Sources that are no vertices, in the faces around them.
  absl::flat_hash_map<uint32_t, Within> within_;
  absl::flat_hash_map<HalfEdge, Range> edges_;
  std::vector<Crossing> crossings_;
  uint64_t steps_ = 0;                          // faces, and levels in them
  std::vector<std::vector<Segment>> segments_;  // of each level
};

// The caller's checkpoint, at which faces behind the wavefront are dealt with
// so that their windows need not be kept.
class SettlingCheckpoint final : public Checkpoint {
 public:
  SettlingCheckpoint(Checkpoint& callers, IsolineBand& band,
                     LevelCrossings& crossings)
      : callers_(callers), band_(band), crossings_(crossings) {}

  absl::Status Poll(const Progress& progress) override {
    last_ = progress;
    if (kept_radius_.has_value() &&
        progress.settled_radius / progress.unit >= *kept_radius_) {
      kept_.assign(progress.distances.begin(), progress.distances.end());
      for (double& distance : kept_) {
        if (distance > *kept_radius_) {
          distance = std::numeric_limits<double>::infinity();
        }
      }
    }
    last_.solver_bytes +=
        band_.bytes() + crossings_.bytes() + kept_.capacity() * sizeof(double);
    if (band_.size() >= next_settling_) {
      if (absl::Status status = crossings_.Settle(
              progress.distances, progress.settled_radius / progress.unit,
              [this] { return callers_.Poll(last_); });
          !status.ok()) {
        return status;
      }
      next_settling_ = std::max(2 * band_.size(), kLeastSettling);
    }
    return callers_.Poll(last_);
  }

  // Keeps the distances that are final up to `radius`, in the scaled unit, once
  // they are; others are infinite.
  void KeepUpTo(double radius) { kept_radius_ = radius; }
  const std::vector<double>& kept() const { return kept_; }

  // The same progress once more, when there are no distances to show.
  absl::Status PollAgain() {
    last_.distances = {};
    return callers_.Poll(last_);
  }

 private:
  // Settling comes when the band has doubled, so each window pays for one
  // visit; below this many there is little to gain.
  static constexpr uint64_t kLeastSettling = 16384;

  Checkpoint& callers_;
  IsolineBand& band_;
  LevelCrossings& crossings_;
  uint64_t next_settling_ = kLeastSettling;
  Progress last_;
  std::optional<double> kept_radius_;
  std::vector<double> kept_;
};

absl::Status CheckLevels(const std::vector<double>& levels) {
  if (levels.empty()) {
    return absl::InvalidArgumentError("levels is empty: name at least one");
  }
  for (size_t i = 0; i < levels.size(); ++i) {
    if (levels[i] > 0 && std::isfinite(levels[i])) continue;
    return absl::InvalidArgumentError(absl::StrCat(
        "levels[", i, "] ", levels[i], " is not a finite number > 0"));
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<std::vector<Isoline>> ComputeIsolines(
    const Mesh& mesh, const ValidQuery& query, std::vector<double> levels,
    const SolveOptions& options, Checkpoint& checkpoint) {
  if (absl::Status status = CheckLevels(levels); !status.ok()) return status;
  std::ranges::sort(levels);
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  const ValidQuery distances_alone = query.Sorted().query.DistancesAlone();
  const double tolerance = distances_alone->tolerance;
  // Within a tolerance, windows and the distances that propagate are lower
  // bounds, and the truth is at most so much above them. The lines are drawn
  // where fields would answer the level.
  const double share = tolerance > 0 ? WithinTolerance(tolerance).share() : 0;
  std::vector<double> scaled_levels;
  scaled_levels.reserve(levels.size());
  for (double level : levels) {
    scaled_levels.push_back(std::ldexp(level, -mesh.scale_exponent()) *
                            (1 - kAnswerInAccount * share));
  }

  IsolineBand band(mesh, scaled_levels);
  LevelCrossings crossings(mesh, AnchorsOf(distances_alone), scaled_levels,
                           band);
  SettlingCheckpoint settling(checkpoint, band, crossings);
  absl::StatusOr<std::unique_ptr<Computation>> computation =
      StartComputation(mesh, distances_alone, options, &band);
  if (!computation.ok()) return computation.status();
  // A little further, to know what is at the last level.
  const double radius = levels.back() * (1 + 2 * kAtLevel);
  if (tolerance > 0) {
    settling.KeepUpTo(std::ldexp(radius, -mesh.scale_exponent()));
  }
  if (absl::Status status = (*computation)->Advance({radius}, settling);
      !status.ok()) {
    return status;
  }
  std::vector<double> distances;
  if (tolerance > 0) {
    // The field has answers above the lower bounds, which are on the other side
    // of some levels than the windows are.
    distances = settling.kept();
  } else {
    distances = (*computation)->Field().distances;
    for (double& distance : distances) {
      distance = std::ldexp(distance, -mesh.scale_exponent());
    }
  }
  if (absl::Status status =
          crossings.Finish(distances, [&] { return settling.PollAgain(); });
      !status.ok()) {
    return status;
  }
  return crossings.Isolines(levels);
}

}  // namespace geodesic
