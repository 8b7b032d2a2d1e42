#include "questions/isolines/level_crossings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "absl/strings/str_cat.h"
#include "geodesic_types/field_path.h"
#include "questions/isolines/arc_sampler.h"
#include "surface/surface_location.h"
#include "tolerances.h"

namespace geodesic {
namespace {

// In all faces and levels together: 320 MB of them.
constexpr uint64_t kMostSamples = 10'000'000;

// An isoline leaves a face so near to one of its crossings, as a part of the
// face: where it all but touches the edge, rounding moves it by the root of
// kAtLevel.
constexpr double kNearCrossing = 1e-5;

// So many ways are compared with another in the time of one step.
constexpr size_t kWaysAStep = 8;

// A face that is no higher has hardly a plane, and no room for arcs.
constexpr double kFlatFace = 1e-9;

}  // namespace

LevelCrossings::LevelCrossings(const Mesh& mesh, std::vector<Anchor> anchors,
                               std::span<const double> levels,
                               const Accuracy& accuracy, IsolineBand& band)
    : mesh_(mesh),
      levels_(levels),
      accuracy_(accuracy),
      band_(band),
      anchors_(std::move(anchors)),
      sources_(mesh, anchors_),
      segments_(levels.size()),
      loops_(levels.size()),
      doubts_(levels.size()) {}

absl::Status LevelCrossings::Work(uint64_t amount, const Poll& poll) {
  constexpr uint64_t kBetweenPolls = 4096;
  const uint64_t before = work_ / kBetweenPolls;
  work_ += amount;
  return work_ / kBetweenPolls != before ? poll() : absl::OkStatus();
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
    if (absl::Status status = Work(1, poll); !status.ok()) return status;
    if (mesh_.IsLeftOut(face) || band_.IsClosed(face)) continue;
    // What crosses a face comes from one of its corners, from a source in it
    // or through it.
    const auto& [a, b, c] = mesh_.triangle(face);
    if (std::min({distances[a], distances[b], distances[c]}) >=
            levels_.back() &&
        !band_.HasWindows(face) && !sources_.HasAny(face)) {
      continue;
    }
    if (absl::Status status = DealWith(face, distances, poll); !status.ok()) {
      return status;
    }
  }
  return absl::OkStatus();
}

uint64_t LevelCrossings::bytes() const {
  uint64_t bytes = crossings_.capacity() * sizeof(Crossing) +
                   edges_.capacity() * sizeof(std::pair<HalfEdge, Range>) +
                   samples_.size() * sizeof(FacePoint) + isoline_bytes_;
  for (const auto& segments : segments_) {
    bytes += segments.capacity() * sizeof(Segment);
  }
  for (const auto& loops : loops_) bytes += loops.capacity() * sizeof(Loop);
  return bytes;
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

LevelCrossings::Range LevelCrossings::LevelsIn(
    uint32_t face, std::span<const double> distances) const {
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
  const HalfEdge first = mesh_.FirstSide(face);
  for (HalfEdge h = first; h < first + 3; ++h) {
    nearest = std::min(nearest, distances[mesh_.From(h)]);
    farthest = std::max(farthest, Farthest(h, distances));
  }
  const FaceSources::Within within = sources_.In(face);
  for (const auto& [point, sigma] : within.points) {
    nearest = std::min(nearest, sigma);
  }
  for (const auto& [segment, sigma] : within.segments) {
    nearest = std::min(nearest, sigma);
  }
  farthest += InradiusOf(mesh_, first);
  const auto begin = std::ranges::upper_bound(levels_, nearest);
  const auto end = std::ranges::lower_bound(levels_, farthest);
  return {static_cast<size_t>(begin - levels_.begin()),
          static_cast<size_t>(std::max(begin, end) - levels_.begin())};
}

absl::StatusOr<LevelCrossings::Range> LevelCrossings::CrossingsOf(
    HalfEdge h, std::span<const double> distances, const Poll& poll) {
  const auto [begin, end] = LevelsOn(h, distances);
  if (begin == end) return Range();
  const uint32_t low = std::min(mesh_.From(h), mesh_.To(h));
  const uint32_t high = std::max(mesh_.From(h), mesh_.To(h));
  const HalfEdge edge = mesh_.FirstOfEdge(h);
  const auto [known, is_new] = edges_.try_emplace(edge);
  if (!is_new) return known->second;
  const double length = mesh_.frame(h).length;
  std::vector<LevelOnEdge> on_edge;
  for (size_t level = begin; level < end; ++level) {
    on_edge.emplace_back(levels_[level], length, distances[low],
                         distances[high]);
  }
  std::vector<Way> ways;
  absl::Status status;
  const auto add_side = [&](HalfEdge side) {
    if (!status.ok()) return;
    ways.clear();
    AddWaysTo(side, low, distances, ways);
    for (LevelOnEdge& level : on_edge) {
      level.Add(ways);
      status.Update(Work(1 + ways.size(), poll));
    }
  };
  add_side(h);
  mesh_.ForEachBeyond(h, [&](HalfEdge other, bool) { add_side(other); });
  if (!status.ok()) return status;
  Range& range = known->second;
  range.begin = crossings_.size();
  for (size_t level = begin; level < end; ++level) {
    bool have_met = false;
    for (const double x : on_edge[level - begin].Crossings(have_met)) {
      crossings_.push_back({static_cast<uint32_t>(level), edge, x});
    }
    if (have_met) SetDoubt(level, Doubt::kMeeting);
  }
  range.end = crossings_.size();
  return range;
}

void LevelCrossings::AddWaysTo(HalfEdge h, uint32_t from,
                               std::span<const double> distances,
                               std::vector<Way>& ways) const {
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
  const FaceSources::Within within = sources_.In(mesh_.FaceOf(h));
  for (const auto& [point, sigma] : within.points) {
    const PlanePoint at = InFrame(mesh_, point, h);
    add({{0, frame.length}, {at.x, std::max(at.y, kLeastHeight), sigma}});
  }
  for (const auto& [segment, sigma] : within.segments) {
    const auto way = GoFromSegment(h, mesh_, segment, sigma);
    if (way.has_value()) add(*way);
  }
  if (!mesh_.IsBoundaryEdge(h)) return;
  // No window leaves through a boundary.
  for (const HalfEdge entry : {Next(h), Prev(h)}) {
    band_.ForEach(entry, [&](const Way& way) {
      const std::optional<Way> on = GoOnTo(h, mesh_, entry, way);
      if (on.has_value()) add(Mirror(*on, frame.length));
    });
  }
}

absl::Status LevelCrossings::AddWays(uint32_t face,
                                     std::span<const double> distances,
                                     FaceWays& ways, const Poll& poll) {
  absl::Status status;
  // Each looks at those that are there.
  const auto add = [&](const auto& add_one) {
    if (!status.ok()) return;
    add_one();
    status = Work(ways.ways().size() / kWaysAStep, poll);
  };
  const HalfEdge first = mesh_.FirstSide(face);
  for (HalfEdge h = first; h < first + 3; ++h) {
    ways.AddCorner(h % 3, distances[mesh_.From(h)]);
  }
  for (HalfEdge h = first; h < first + 3; ++h) {
    band_.ForEach(h, [&](const Way& way) {
      add([&] {
        ways.AddThrough(h, way,
                        {distances[mesh_.From(h)], distances[mesh_.To(h)]});
      });
    });
  }
  const FaceSources::Within within = sources_.In(face);
  for (const auto& [point, sigma] : within.points) {
    add([&, &point = point, sigma = sigma] { ways.AddWithin(point, sigma); });
  }
  for (const auto& [segment, sigma] : within.segments) {
    add([&, &segment = segment, sigma = sigma] {
      ways.AddWithin(segment, sigma);
    });
  }
  return status;
}

absl::Status LevelCrossings::DealWith(uint32_t face,
                                      std::span<const double> distances,
                                      const Poll& poll) {
  std::array<Range, 3> ranges;
  auto [begin, end] = LevelsIn(face, distances);
  if (begin == end) {
    begin = std::numeric_limits<size_t>::max();
    end = 0;
  }
  for (uint32_t side = 0; side < 3; ++side) {
    const absl::StatusOr<Range> found =
        CrossingsOf(mesh_.FirstSide(face) + side, distances, poll);
    if (!found.ok()) return found.status();
    const Range& range = ranges[side] = *found;
    if (range.begin == range.end) continue;
    begin = std::min<size_t>(begin, crossings_[range.begin].level);
    end = std::max<size_t>(end, crossings_[range.end - 1].level + 1);
  }
  if (begin < end) {
    FaceWays ways(mesh_, face);
    const bool has_sources = sources_.HasAny(face);
    for (size_t level = begin; level < end; ++level) {
      auto [entries, exits] = Perimeter(
          ways, face, static_cast<uint32_t>(level), ranges, distances);
      // What is nearer comes over the perimeter or starts inside.
      if (entries.empty() && exits.empty() && !has_sources &&
          !IsNearer(distances[mesh_.triangle(face)[0]], levels_[level])) {
        continue;
      }
      absl::Status status;
      if (ways.ways().empty()) status = AddWays(face, distances, ways, poll);
      if (status.ok()) {
        status = DrawLevel(ways, face, static_cast<uint32_t>(level),
                           std::move(entries), std::move(exits), poll);
      }
      if (!status.ok()) return status;
    }
  }
  band_.Close(face);
  return Work(64, poll);
}

LevelCrossings::Range LevelCrossings::AtLevel(const Range& range,
                                              uint32_t level) const {
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

std::array<std::vector<LevelCrossings::Place>, 2> LevelCrossings::Perimeter(
    const FaceWays& ways, uint32_t face, uint32_t level,
    const std::array<Range, 3>& ranges,
    std::span<const double> distances) const {
  std::array<std::vector<Place>, 2> places;
  // Going round anticlockwise: what is nearer lies on the left of an isoline
  // that enters where it ends.
  bool is_nearer = IsNearer(distances[mesh_.triangle(face)[0]], levels_[level]);
  for (uint32_t side = 0; side < 3; ++side) {
    const HalfEdge h = mesh_.FirstSide(face) + side;
    const auto [begin, end] = AtLevel(ranges[side], level);
    const bool is_forward = mesh_.From(h) < mesh_.To(h);
    for (size_t i = 0; i < end - begin; ++i) {
      const size_t c = is_forward ? begin + i : end - 1 - i;
      const double x = crossings_[c].x;
      places[is_nearer ? 0 : 1].push_back(
          {ways.OnSide(side, is_forward ? x : mesh_.frame(h).length - x),
           static_cast<uint32_t>(c)});
      is_nearer = !is_nearer;
    }
  }
  return places;
}

void LevelCrossings::Join(uint32_t level, const Place& entry, Place& exit,
                          uint32_t first_sample) {
  exit.is_taken = true;
  segments_[level].push_back(
      {entry.crossing, exit.crossing, first_sample,
       static_cast<uint32_t>(samples_.size()) - first_sample});
}

absl::StatusOr<bool> LevelCrossings::IsChordEnough(
    FaceWays& ways, uint32_t level, const DirectionCone& directions,
    const Place& entry, const Place& exit, const FaceWays::Step& step) const {
  const PlanePoint chord = exit.place - entry.place;
  double distance = ways.size();
  std::optional<DirectionCone> there = directions;
  while (distance > ChordError(level)) {
    // What does not lead there does not count.
    const double farthest = there->FarthestFrom(chord);
    if (farthest > distance / 2 && farthest > ChordError(level)) return false;
    distance = farthest;
    const auto found = ways.DirectionsAt(
        levels_[level], {entry.place, exit.place, distance}, step);
    if (!found.ok()) return found.status();
    there = *found;
    if (!there.has_value()) return false;
  }
  return true;
}

absl::Status LevelCrossings::DrawLevel(FaceWays& ways, uint32_t face,
                                       uint32_t level,
                                       std::vector<Place> entries,
                                       std::vector<Place> exits,
                                       const Poll& poll) {
  const double at_level = levels_[level];
  const FaceWays::Step step = [&](uint64_t amount) {
    return Work(amount, poll);
  };
  const ArcSampler::Emit emit = [&](const PlanePoint& place) {
    if (samples_.size() == kMostSamples) {
      return InvalidField(
          "chord_error",
          absl::StrCat(
              "chord_error asks for more than ", kMostSamples,
              " points inside faces: name a larger one, or fewer levels"));
    }
    samples_.push_back(ways.PointAt(place));
    return Work(1, poll);
  };
  const ArcSampler sampler(ChordError(level), emit, step);
  const auto next_sample = [&] {
    return static_cast<uint32_t>(samples_.size());
  };
  const auto nearest_exit = [&](const PlanePoint& place) {
    return std::ranges::min_element(exits, {}, [&](const Place& exit) {
      return exit.is_taken ? std::numeric_limits<double>::infinity()
                           : Norm(exit.place - place);
    });
  };

  // Whether an isoline may run from a corner of the face and back there.
  const auto leads_back = [&](const PlanePoint& place) {
    const auto is_here = [&](const PlanePoint& other) {
      return Norm(other - place) <= kRoundedPlace;
    };
    return std::ranges::any_of(ways.corners(), is_here) &&
           std::ranges::any_of(exits, is_here, &Place::place);
  };

  absl::Status status = step(64);
  std::optional<DirectionCone> directions;
  if (!ways.has_sources()) {
    auto found = ways.DirectionsAt(at_level, {{}, {}, ways.size()}, step);
    if (!found.ok()) return found.status();
    directions = *found;
  }
  const bool may_have_loops = !directions.has_value();
  if (!may_have_loops && entries.size() == 1 && exits.size() == 1) {
    const absl::StatusOr<bool> is_enough =
        IsChordEnough(ways, level, *directions, entries[0], exits[0], step);
    if (!is_enough.ok()) return is_enough.status();
    if (*is_enough) {
      Join(level, entries[0], exits[0], next_sample());
      return status;
    }
  }
  const bool is_flat = !(ways.height() > kFlatFace * ways.size());
  const double near =
      kNearCrossing * ways.size() + 2 * accuracy_.share * at_level;
  if ((may_have_loops || !entries.empty()) && !is_flat) {
    LevelTracer tracer(ways, at_level, step);
    bool may_be_lost = false, is_astray = false;
    for (Place& entry : entries) {
      // Which exit is nearest, and whether it leads back.
      status.Update(step(2 * exits.size()));
      if (!status.ok()) return status;
      absl::StatusOr<LevelTracer::Trace> trace = tracer.TraceFrom(entry.place);
      if (!trace.ok()) return trace.status();
      may_be_lost |= leads_back(entry.place) && trace->arcs.empty();
      if (!trace->exit.has_value()) {
        is_astray |= !trace->arcs.empty();
        continue;
      }
      const auto exit = nearest_exit(*trace->exit);
      if (exit == exits.end() || exit->is_taken ||
          Norm(exit->place - *trace->exit) > near) {
        continue;
      }
      const uint32_t first_sample = next_sample();
      status.Update(sampler.Between(trace->arcs));
      Join(level, entry, *exit, first_sample);
      entry.is_taken = true;
    }
    if (!is_astray && may_be_lost) {
      const absl::StatusOr<bool> has_untraced = tracer.HasUntraced();
      if (!has_untraced.ok()) return has_untraced.status();
      is_astray = *has_untraced;
    }
    if (is_astray) SetDoubt(level, Doubt::kRounded);
    std::vector<std::vector<FrontArc>> loops;
    if (may_have_loops) {
      absl::StatusOr<std::vector<std::vector<FrontArc>>> found = tracer.Loops();
      if (!found.ok()) return found.status();
      loops = *std::move(found);
      if (tracer.has_lost_some()) SetDoubt(level, Doubt::kRounded);
    }
    for (const std::vector<FrontArc>& loop : loops) {
      const uint32_t first_sample = next_sample();
      status.Update(sampler.Around(loop));
      loops_[level].push_back(
          {face, first_sample, next_sample() - first_sample});
    }
  }
  // Where rounding decides.
  for (const Place& entry : entries) {
    if (entry.is_taken) continue;
    status.Update(step(exits.size()));
    if (!status.ok()) return status;
    const auto exit = nearest_exit(entry.place);
    const bool has_exit = exit != exits.end() && !exit->is_taken;
    if (!is_flat && !(has_exit && Norm(exit->place - entry.place) <= near)) {
      SetDoubt(level, Doubt::kRounded);
    }
    if (!has_exit) break;
    Join(level, entry, *exit, next_sample());
  }
  return status;
}

}  // namespace geodesic
