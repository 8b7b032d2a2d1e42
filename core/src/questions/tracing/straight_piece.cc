#include "questions/tracing/straight_piece.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <optional>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "tolerances.h"

namespace geodesic {
namespace {

// A vertex, and the one from which an edge without length leads to it.
struct Joined {
  uint32_t vertex;
  size_t from;
};

// The vertices that edges without length join to `vertex`, itself the first;
// not all if the meter says stop.
std::vector<Joined> JoinedTo(const Mesh& mesh, uint32_t vertex,
                             WorkMeter& meter) {
  std::vector<Joined> joined = {{vertex, 0}};
  std::unordered_set<uint32_t> known = {vertex};
  for (size_t i = 0; i < joined.size(); ++i) {
    const auto reach = [&](uint32_t v, double length) {
      if (length == 0 && known.insert(v).second) joined.push_back({v, i});
    };
    for (const HalfEdge h : mesh.Outgoing(joined[i].vertex)) {
      if (!meter.Do()) return joined;
      reach(mesh.To(h), mesh.frame(h).length);
      reach(mesh.Apex(h), mesh.frame(Prev(h)).length);
    }
  }
  return joined;
}

// By how much the path whose last piece this is misses the distance of `end`.
double Misses(const TracedField& field, const PathEnd& end,
              const StraightPiece& piece) {
  const double before = field.IsVertex(piece.start)
                            ? field.VertexDistance(piece.start)
                            : std::ldexp(field.AnchorOf(piece.start).offset,
                                         -field.mesh().scale_exponent());
  return std::abs(piece.length + before - end.distance);
}

// Whether a piece leads away from its end: of vertices joined without length
// one has to.
bool LeadsAway(const TracedField& field, const PathEnd& end,
               const StraightPiece& piece, WorkMeter& meter) {
  if (!field.IsVertex(piece.start) ||
      !Coincide(field.mesh(), end.point, piece.start)) {
    return true;
  }
  const std::vector<Joined> joined = JoinedTo(field.mesh(), piece.start, meter);
  const uint32_t at = std::get<VertexPoint>(end.point).vertex;
  return std::ranges::find(joined, at, &Joined::vertex) == joined.end();
}

// Whether the path to `end` may come by way of a vertex. No path leads on from
// what is no vertex; otherwise from a nearer one, or as the trace says, or the
// path might lead in circles.
bool MayPrecede(const TracedField& field, uint32_t vertex, const PathEnd& end) {
  if (!std::holds_alternative<VertexPoint>(end.point)) return true;
  const double distance = field.VertexDistance(vertex);
  return distance < end.distance ||
         (vertex == end.arrival.pseudo_source && distance == end.distance);
}

// Calls take(piece) for what walks from `end` in all the ways there are arrive
// by, until it returns true.
template <typename Take>
bool WalkEveryWay(const TracedField& field, const PathEnd& end,
                  WorkMeter& meter, Take take) {
  // No more are tried. Walks that go astray end soon (back_walk.cc), so that
  // few are needed.
  constexpr size_t kMostWalks = 1024;
  for (const double nearness : {kPassedVertex, kPassedNarrowly}) {
    // Walks that take the first way nearly everywhere come before others.
    std::deque<std::vector<Fork>> untried = {{}};
    for (size_t walks = 0;
         walks < kMostWalks && !untried.empty() && meter.status().ok();
         ++walks) {
      std::vector<Fork> forks = std::move(untried.front());
      untried.pop_front();
      size_t next = forks.size();
      std::optional<StraightPiece> piece =
          WalkBack(field, end, forks, meter, nearness);
      if (piece.has_value() && LeadsAway(field, end, *piece, meter) &&
          take(*piece)) {
        return true;
      }
      for (; next < forks.size() && untried.size() < kMostWalks; ++next) {
        std::vector<Fork> other(forks.begin(), forks.begin() + next + 1);
        for (uint32_t way = 1;
             way < forks[next].ways && untried.size() < kMostWalks; ++way) {
          other.back().taken = way;
          untried.push_back(other);
        }
      }
    }
  }
  return false;
}

// As long as distances say.
std::optional<StraightPiece> WalkSoundly(const TracedField& field,
                                         const PathEnd& end, WorkMeter& meter) {
  std::optional<StraightPiece> found;
  WalkEveryWay(field, end, meter, [&](StraightPiece& piece) {
    if (!(Misses(field, end, piece) <=
          kAsLong * end.distance + field.rounding())) {
      return false;
    }
    found = std::move(piece);
    return true;
  });
  return found;
}

// Calls take(piece) for every piece that may lead to `end` if the way is so
// short that rounding has bent it: by all walks, however long, and straight
// from the pseudo-source that the trace names and from the corners around.
template <typename Take>
void TryEverything(const TracedField& field, const PathEnd& end,
                   WorkMeter& meter, Take take) {
  const Mesh& mesh = field.mesh();
  WalkEveryWay(field, end, meter, [&](StraightPiece& piece) {
    take(piece);
    return false;
  });
  const auto go_straight = [&](uint32_t pseudo_source) {
    PathEnd straight = end;
    straight.arrival = {.pseudo_source = pseudo_source};
    std::vector<Fork> forks;
    if (auto piece = WalkBack(field, straight, forks, meter)) take(*piece);
  };
  // Between vertices it takes an edge to be there.
  const uint32_t named = end.arrival.pseudo_source;
  if (!std::holds_alternative<VertexPoint>(end.point) ||
      !field.IsVertex(named)) {
    go_straight(named);
  }
  VisitFacesAround(mesh, end.point, [&](const FacePoint& around) {
    for (const uint32_t corner : mesh.triangle(around.face)) {
      if (MayPrecede(field, corner, end)) go_straight(corner);
    }
    return !meter.Do();
  });
}

// The way from the first of `joined` to number `i`.
std::vector<SurfacePoint> WayBetween(const std::vector<Joined>& joined,
                                     size_t i) {
  std::vector<SurfacePoint> way;
  for (; i != 0; i = joined[i].from) {
    way.push_back(VertexPoint{joined[i].vertex});
  }
  std::ranges::reverse(way);
  return way;
}

// Of all pieces that may lead to `end` or, if that is a vertex, to one joined
// to it without length: the one whose length is nearest to what distances say.
// Nothing if all miss that by more than rounding.
std::optional<StraightPiece> FindNearest(const TracedField& field,
                                         const PathEnd& end, WorkMeter& meter) {
  std::optional<StraightPiece> nearest;
  double least = kAsLong * end.distance + kRoundedPlace + field.rounding();
  const auto* vertex = std::get_if<VertexPoint>(&end.point);
  const std::vector<Joined> joined =
      vertex != nullptr ? JoinedTo(field.mesh(), vertex->vertex, meter)
                        : std::vector<Joined>(1);
  for (size_t i = 0; i < joined.size() && meter.status().ok(); ++i) {
    const PathEnd from =
        vertex != nullptr ? field.Vertex(joined[i].vertex) : end;
    TryEverything(field, from, meter, [&](StraightPiece& piece) {
      if (field.IsVertex(piece.start) && !MayPrecede(field, piece.start, end)) {
        return;
      }
      const double misses = Misses(field, end, piece);
      if (!(misses <= least)) return;
      least = misses;
      nearest = std::move(piece);
      const std::vector<SurfacePoint> way = WayBetween(joined, i);
      nearest->points.insert(nearest->points.begin(), way.begin(), way.end());
    });
  }
  return nearest;
}

}  // namespace

absl::StatusOr<StraightPiece> FollowBack(const TracedField& field,
                                         const PathEnd& end, WorkMeter& meter) {
  if (end.arrival.pseudo_source == kNoPseudoSource) {
    return absl::InternalError("the trace leads to where no path arrives");
  }
  std::optional<StraightPiece> piece = WalkSoundly(field, end, meter);
  if (!piece.has_value()) piece = FindNearest(field, end, meter);
  if (!meter.status().ok()) return meter.status();
  if (piece.has_value()) return *std::move(piece);
  return absl::InternalError(
      absl::StrCat("the trace does not lead back to pseudo-source ",
                   end.arrival.pseudo_source, " through half-edge ",
                   end.arrival.entry, ", where a path arrives"));
}

}  // namespace geodesic
