#include "paths/straight_piece.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "paths/back_walk.h"
#include "tolerances.h"

namespace geodesic {
namespace {

// A vertex, and the one from which an edge without length leads to it.
struct Joined {
  uint32_t vertex;
  size_t from;
};

// The vertices that edges without length join to `vertex`, itself the first.
std::vector<Joined> JoinedTo(const Mesh& mesh, uint32_t vertex) {
  std::vector<Joined> joined = {{vertex, 0}};
  std::set<uint32_t> known = {vertex};
  for (size_t i = 0; i < joined.size(); ++i) {
    const auto reach = [&](uint32_t v, double length) {
      if (length == 0 && known.insert(v).second) joined.push_back({v, i});
    };
    for (const HalfEdge h : mesh.Outgoing(joined[i].vertex)) {
      reach(mesh.To(h), mesh.frame(h).length);
      reach(mesh.Apex(h), mesh.frame(Prev(h)).length);
    }
  }
  return joined;
}

// How long the path is whose last piece this is.
double DistanceBy(const TracedField& field, const StraightPiece& piece) {
  return piece.length + (field.IsVertex(piece.start)
                             ? field.VertexDistance(piece.start)
                             : std::ldexp(field.AnchorOf(piece.start).offset,
                                          -field.mesh().scale_exponent()));
}

// Whether a piece leads away from its end, and is as long as distances say.
bool IsSound(const TracedField& field, const PathEnd& end,
             const StraightPiece& piece) {
  if (field.IsVertex(piece.start) &&
      Coincide(field.mesh(), end.point, piece.start)) {
    // Of vertices joined without length one has to lead away.
    const std::vector<Joined> joined = JoinedTo(field.mesh(), piece.start);
    const uint32_t at = std::get<VertexPoint>(end.point).vertex;
    if (std::ranges::find(joined, at, &Joined::vertex) != joined.end()) {
      return false;
    }
  }
  return std::abs(DistanceBy(field, piece) - end.distance) <=
         kAsLong * end.distance + field.rounding();
}

// Walks from `end` in all the ways there are until the piece is sound.
std::optional<StraightPiece> WalkEveryWay(const TracedField& field,
                                          const PathEnd& end) {
  // More are as rare as several vertices at one place, beside a source in a
  // face without area.
  constexpr double kMostWays = 256;
  for (const double nearness : {kPassedVertex, kPassedNarrowly}) {
    double ways = 1;
    for (uint32_t turns = 0; turns < ways; ++turns) {
      BackWalk walk = WalkBack(field, end, turns, nearness);
      if (walk.piece.has_value() && IsSound(field, end, *walk.piece)) {
        return std::move(walk.piece);
      }
      ways = std::max(ways, std::min(walk.ways, kMostWays));
    }
  }
  return std::nullopt;
}

// The longest edge of the faces around a point.
double LongestAround(const Mesh& mesh, const SurfacePoint& point) {
  double longest = 0;
  for (const FacePoint& around : FacesAround(mesh, point)) {
    const HalfEdge h = mesh.FirstSide(around.face);
    longest =
        std::max({longest, mesh.frame(h).length, mesh.frame(Next(h)).length,
                  mesh.frame(Prev(h)).length});
  }
  return longest;
}

// Goes straight from a pseudo-source in a face around the end, however the
// trace says that the path came, if that is as long within the rounding of
// edges that are as long as `longest`.
std::optional<StraightPiece> WalkStraight(const TracedField& field, PathEnd end,
                                          uint32_t pseudo_source,
                                          double longest) {
  end.arrival = {.pseudo_source = pseudo_source};
  std::optional<StraightPiece> piece = WalkBack(field, end, 0).piece;
  if (!piece.has_value() || piece->points.empty() ||
      std::abs(DistanceBy(field, *piece) - end.distance) <=
          kRoundedPlace * longest) {
    return piece;
  }
  return std::nullopt;
}

// Likewise from the pseudo-source that the trace names, or a corner of a face
// around the end. As short as rounding, the path may have come round others.
std::optional<StraightPiece> WalkWithinFace(const TracedField& field,
                                            const PathEnd& end) {
  const Mesh& mesh = field.mesh();
  const double longest = LongestAround(mesh, end.point);
  // Between vertices it takes an edge to be there.
  const uint32_t named = end.arrival.pseudo_source;
  if (!std::holds_alternative<VertexPoint>(end.point) ||
      !field.IsVertex(named)) {
    if (auto piece = WalkStraight(field, end, named, longest)) return piece;
  }
  for (const FacePoint& around : FacesAround(mesh, end.point)) {
    for (const uint32_t corner : mesh.triangle(around.face)) {
      if (!(field.VertexDistance(corner) < end.distance)) continue;
      if (auto piece = WalkStraight(field, end, corner, longest)) return piece;
    }
  }
  return std::nullopt;
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

// The piece that leaves from some vertex at the place of `vertex`.
std::optional<StraightPiece> WalkFromJoined(const TracedField& field,
                                            uint32_t vertex) {
  const std::vector<Joined> joined = JoinedTo(field.mesh(), vertex);
  const auto first_of = [&](auto walk) -> std::optional<StraightPiece> {
    for (size_t i = 0; i < joined.size(); ++i) {
      std::optional<StraightPiece> piece = walk(field.Vertex(joined[i].vertex));
      if (!piece.has_value()) continue;
      const std::vector<SurfacePoint> way = WayBetween(joined, i);
      piece->points.insert(piece->points.begin(), way.begin(), way.end());
      return piece;
    }
    return std::nullopt;
  };
  // Between them directions mean nothing, and the trace may lead round among
  // them. The path left from one of them.
  if (auto piece = first_of(
          [&](const PathEnd& end) { return WalkEveryWay(field, end); })) {
    return piece;
  }
  // If a source is nearer than coordinates tell, the trace may lead round
  // between it and them too.
  double longest = 0;
  for (const Joined& beside : joined) {
    longest = std::max(longest,
                       LongestAround(field.mesh(), VertexPoint{beside.vertex}));
  }
  for (const Joined& beside : joined) {
    const uint32_t anchor = field.VertexArrival(beside.vertex).pseudo_source;
    if (anchor == kNoPseudoSource || field.IsVertex(anchor)) continue;
    if (auto piece = first_of([&](const PathEnd& end) {
          return WalkStraight(field, end, anchor, longest);
        })) {
      return piece;
    }
  }
  return std::nullopt;
}

}  // namespace

absl::StatusOr<StraightPiece> FollowBack(const TracedField& field,
                                         const PathEnd& end) {
  if (end.arrival.pseudo_source == kNoPseudoSource) {
    return absl::InternalError("the trace leads to where no path arrives");
  }
  if (auto piece = WalkEveryWay(field, end)) return *std::move(piece);
  if (const auto* vertex = std::get_if<VertexPoint>(&end.point)) {
    if (auto piece = WalkFromJoined(field, vertex->vertex)) {
      return *std::move(piece);
    }
  }
  if (auto piece = WalkWithinFace(field, end)) return *std::move(piece);
  // A piece about as short as the rounding of coordinates is as long as its
  // points say.
  if (auto piece = WalkBack(field, end, 0).piece) return *std::move(piece);
  return absl::InternalError(
      absl::StrCat("the trace does not lead back to pseudo-source ",
                   end.arrival.pseudo_source, " through half-edge ",
                   end.arrival.entry, ", where a path arrives"));
}

}  // namespace geodesic
