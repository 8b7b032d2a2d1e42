#include "questions/first_path/route_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mesh/prefetch.h"
#include "solver/queues/queue.h"
#include "solver/windows/window.h"
#include "surface/surface_location.h"

namespace geodesic {
namespace {

// How many times bounds count. More than once, they leave out most of the
// routes that are as good as equal, for one that is hardly longer. Those of
// landmarks are so near the truth that less does.
constexpr double kGreed = 1.3;
constexpr double kGreedWithLandmarks = 1.04;

constexpr uint64_t kPollPeriod = 4096;

}  // namespace

RouteSearch::RouteSearch(const Mesh& mesh)
    : mesh_(mesh), known_(mesh.vertex_count()) {}

uint64_t RouteSearch::bytes() const {
  return known_.capacity() * sizeof(Known) +
         touched_.capacity() * sizeof(uint32_t) + queue_.bytes();
}

absl::Status RouteSearch::Find(std::span<const RouteStart> starts,
                               const Place& end, const Goal& goal,
                               absl::FunctionRef<absl::Status()> poll,
                               Route& route) {
  Restart();
  greed_ = goal.has_landmarks() ? kGreedWithLandmarks : kGreed;
  route.steps.clear();
  route.portals.clear();
  for (uint32_t s = 0; s < starts.size(); ++s) {
    ForEachCorner(starts[s].place, [&](uint32_t v, double distance) {
      Relax(v, starts[s].offset + distance, {.start = s}, goal);
    });
  }
  std::array<std::pair<uint32_t, double>, 3> ends;
  size_t end_count = 0;
  ForEachCorner(end, [&](uint32_t v, double distance) {
    ends[end_count++] = {v, distance};
  });
  uint32_t last = Place::kNoVertex;
  double best = std::numeric_limits<double>::infinity();
  uint64_t expanded = 0;
  while (queue_.size() > 0 && queue_.SettledRadius() < best) {
    const uint32_t v = queue_.Pop();
    if (known_[v].is_closed) continue;
    const uint32_t next = queue_.Upcoming(1);
    if (next != kNothing) PrefetchFan(mesh_, next);
    for (const auto& [corner, rest] : std::span(ends).first(end_count)) {
      if (v != corner || !(known_[v].distance + rest < best)) continue;
      best = known_[v].distance + rest;
      last = v;
    }
    Expand(v, goal);
    if (++expanded % kPollPeriod != 0) continue;
    if (absl::Status status = poll(); !status.ok()) return status;
  }
  route.exists = last != Place::kNoVertex;
  if (route.exists) TraceBack(last, starts, route);
  return absl::OkStatus();
}

void RouteSearch::Restart() {
  for (const uint32_t v : touched_) known_[v] = {};
  touched_.clear();
  queue_.Clear();
}

template <typename Visit>
void RouteSearch::ForEachCorner(const Place& place, Visit visit) const {
  if (place.is_vertex()) {
    visit(place.vertex, 0.0);
    return;
  }
  for (uint32_t corner = 0; corner < 3; ++corner) {
    visit(mesh_.triangle(place.point.face)[corner],
          DistanceToCorner(mesh_, place.point, corner));
  }
}

void RouteSearch::Relax(uint32_t v, double distance, const Known& by,
                        const Goal& goal) {
  Known& known = known_[v];
  if (known.is_closed || !(distance < known.distance)) return;
  const double key = distance + greed_ * goal.Bound(v);
  if (std::isinf(key)) return;
  if (std::isinf(known.distance)) touched_.push_back(v);
  known = by;
  known.distance = distance;
  queue_.Push(v, key);
}

// Straight through the edge of h from a place in the plane that is as far from
// both ends as they are known to be from a start.
void RouteSearch::RelaxApex(HalfEdge h, uint32_t start, const Goal& goal) {
  if (known_[mesh_.Apex(h)].is_closed) return;
  const std::optional<PlanePoint> source = SourceBelow(h);
  if (!source.has_value()) return;
  const HalfEdgeFrame& frame = mesh_.frame(h);
  const PlanePoint apex = ApexOf(frame);
  const double height = apex.y - source->y;
  const double crossing = source->x * apex.y - apex.x * source->y;  // by height
  if (!(crossing > 0 && crossing < frame.length * height)) return;
  Relax(mesh_.Apex(h), Norm(apex - *source), {.across = h, .start = start},
        goal);
}

void RouteSearch::Expand(uint32_t v, const Goal& goal) {
  Known& known = known_[v];
  known.is_closed = true;
  const uint32_t start = known.start;
  const Known along{.from = v, .start = start};
  for (const HalfEdge h : mesh_.Outgoing(v)) {
    Relax(mesh_.To(h), known.distance + mesh_.frame(h).length, along, goal);
    if (mesh_.Twin(Prev(h)) == kNoHalfEdge) {
      // No other face around v has this side.
      Relax(mesh_.Apex(h), known.distance + mesh_.frame(Prev(h)).length, along,
            goal);
    }
    RelaxApex(h, start, goal);
    RelaxApex(Prev(h), start, goal);
  }
}

// The place in the plane of the face of h, below h, that is as far from both
// ends as they are known to be; nothing where there is none.
std::optional<PlanePoint> RouteSearch::SourceBelow(HalfEdge h) const {
  const double from = known_[mesh_.From(h)].distance;
  const double to = known_[mesh_.To(h)].distance;
  if (std::isinf(from) || std::isinf(to)) return std::nullopt;
  const PlanePoint above = PlaceOver(mesh_.frame(h).length, from, to);
  if (above.y == 0) return std::nullopt;
  return PlanePoint{above.x, -above.y};
}

// That of two vertices by which a place is nearer which is so far from either.
uint32_t RouteSearch::NearestBy(uint32_t a, double to_a, uint32_t b,
                                double to_b) const {
  return known_[a].distance + to_a <= known_[b].distance + to_b ? a : b;
}

// Goes back from the apex of h across that and on, in each face straight toward
// where the distances say that the way comes from. Returns the vertex it comes
// to; kNoVertex for a start within a face.
uint32_t RouteSearch::TraceAcross(HalfEdge h, const Place& start,
                                  Route& route) const {
  std::optional<PlanePoint> source = SourceBelow(h);
  double crossing =
      CrossingTo({.x = source->x, .depth = -source->y}, ApexOf(mesh_.frame(h)));
  for (;;) {
    route.portals.push_back(h);
    const double length = mesh_.frame(h).length;
    const HalfEdge beyond = mesh_.Twin(h);
    if (beyond == kNoHalfEdge) {
      return NearestBy(mesh_.From(h), crossing, mesh_.To(h), length - crossing);
    }
    if (!start.is_vertex() && start.LiesAcross(mesh_, beyond)) {
      return Place::kNoVertex;
    }
    // In the frame of the half-edge beyond.
    const PlanePoint at{length - crossing, 0};
    const PlanePoint way{crossing - source->x, -source->y};
    const PlanePoint apex = ApexOf(mesh_.frame(beyond));
    const bool passes_left = Cross(way, apex - at) < 0;
    h = passes_left ? Prev(beyond) : Next(beyond);
    source = SourceBelow(h);
    if (source.has_value()) {
      const PlanePoint from = passes_left ? apex : PlanePoint{length, 0};
      const PlanePoint side = (passes_left ? PlanePoint{} : apex) - from;
      const double part = Cross(at - from, way) / Cross(side, way);
      crossing = std::clamp(part, 0.0, 1.0) * mesh_.frame(h).length;
      // Each face is nearer to the start than the one before.
      if (Norm(PlanePoint{crossing - source->x, source->y}) < Norm(way)) {
        continue;
      }
    }
    const uint32_t left = mesh_.From(beyond), right = mesh_.To(beyond);
    const uint32_t end = NearestBy(left, at.x, right, length - at.x);
    return NearestBy(end, end == left ? at.x : length - at.x,
                     mesh_.Apex(beyond), Norm(apex - at));
  }
}

// The way to vertex `last` from a start; none if it winds.
void RouteSearch::TraceBack(uint32_t last, std::span<const RouteStart> starts,
                            Route& route) const {
  uint32_t v = last;
  while (v != Place::kNoVertex) {
    if (route.steps.size() > touched_.size()) {
      route.steps.clear();
      return;
    }
    route.start = known_[v].start;
    const auto first = static_cast<uint32_t>(route.portals.size());
    const uint32_t from =
        known_[v].across == kNoHalfEdge
            ? known_[v].from
            : TraceAcross(known_[v].across, starts[route.start].place, route);
    std::reverse(route.portals.begin() + first, route.portals.end());
    route.steps.push_back(
        {.to = v,
         .first = first,
         .last = static_cast<uint32_t>(route.portals.size())});
    v = from;
  }
  std::ranges::reverse(route.steps);
}

}  // namespace geodesic
