#include "tests/support/oracles/brute_force.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

#include "tests/support/half_edges.h"
#include "tests/support/oracles/edge_paths.h"
#include "tests/support/surface_points.h"

namespace geodesic::test {
namespace {

constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

// A wedge narrower than this (radians) is given up. What lies behind it is
// also reached through the vertex that bounds it, by a path no longer than
// this fraction.
constexpr Real kLeastOpening = 1e-17L;

// A vertex this far (radians) outside the wedge still counts as hit: a ray
// through a vertex must not be lost to rounding. The path by way of the vertex
// that bounds the wedge is longer by the square of this.
constexpr Real kHitSlack = 1e-15L;

// Slack of the length bound, so that rounding never prunes a shortest path.
constexpr Real kBoundSlack = 1e-12L;

// What can be seen from the unfolded source at (0, 0) through a half-edge that
// runs from `from` to `to`, with the source on its left: the directions from
// `right` turning left to `left`, at most half a turn.
struct Window {
  uint32_t half_edge;    // a side of the face that the rays come from
  uint32_t from_vertex;  // the end of the edge that lies at `from`
  Vec2 from, to;
  Vec2 right, left;
  Real least;  // no edge that the rays have crossed is nearer
};

// Whether b lies left of a, by up to half a turn.
bool TurnsLeft(Vec2 a, Vec2 b) {
  const Real cross = Cross(a, b);
  if (cross > 0) return true;
  return Dot(a, b) < 0 && cross > -kLeastOpening * Norm(a) * Norm(b);
}

bool IsOpen(const Window& w) {
  return Dot(w.right, w.left) < 0
             ? TurnsLeft(w.right, w.left)
             : Cross(w.right, w.left) >
                   kLeastOpening * Norm(w.right) * Norm(w.left);
}

// Whether rays meet p behind the window's edge. Along the line of an edge, the
// face behind may lie before it, as one without area may: no ray that crossed
// the edge is there.
bool Sees(const Window& w, Vec2 p) {
  if (Norm(p) < w.least - kBoundSlack * (Norm(w.from) + Norm(w.to))) {
    return false;
  }
  const Real slack = kHitSlack * Norm(p);
  const Real to_right = Norm(w.right), to_left = Norm(w.left);
  if (Cross(w.right, p) < -slack * to_right) return false;
  if (Cross(p, w.left) < -slack * to_left) return false;
  // Not behind the source: one side of the wedge is within a right angle.
  return Dot(p, w.right) >= -slack * to_right ||
         Dot(p, w.left) >= -slack * to_left;
}

// The point nearest to the origin on the segment a b.
Vec2 NearestOnSegment(Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const Real length2 = Dot(d, d);
  if (length2 == 0) return a;
  return a + std::clamp<Real>(-Dot(a, d) / length2, 0, 1) * d;
}

// Where the ray from the origin along `ray` meets the line a b.
Vec2 OnRay(Vec2 ray, Vec2 a, Vec2 b) {
  const Real denominator = Cross(ray, b - a);
  if (denominator == 0) return NearestOnSegment(a, b);
  return a + std::clamp<Real>(-Cross(ray, a) / denominator, 0, 1) * (b - a);
}

Real DistanceToVisiblePart(const Window& w) {
  return Norm(NearestOnSegment(OnRay(w.right, w.from, w.to),
                               OnRay(w.left, w.from, w.to)));
}

Real DistanceToSegment(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 d = b - a;
  const Real length2 = Dot(d, d);
  const Real t =
      length2 == 0 ? 0 : std::clamp<Real>(Dot(p - a, d) / length2, 0, 1);
  return Norm(p - (a + t * d));
}

// The part of the segment a b within the window's wedge that is nearest to the
// origin; false if no part is.
bool NearestVisible(const Window& w, Vec2 a, Vec2 b, Vec2* nearest) {
  Real t0 = 0, t1 = 1;
  // Each bound of the wedge keeps what is left of it; that is linear in t.
  const auto clip = [&](Real at_a, Real at_b, Real slack) {
    if (at_a < -slack && at_b < -slack) t1 = -1;
    if (at_a < 0 && at_b > 0) t0 = std::max(t0, at_a / (at_a - at_b));
    if (at_a > 0 && at_b < 0) t1 = std::min(t1, at_a / (at_a - at_b));
  };
  const Real size = kHitSlack * std::max(Norm(a), Norm(b));
  clip(Cross(w.right, a), Cross(w.right, b), size * Norm(w.right));
  clip(Cross(a, w.left), Cross(b, w.left), size * Norm(w.left));
  if (t0 > t1) return false;
  *nearest = NearestOnSegment(a + t0 * (b - a), a + t1 * (b - a));
  return Sees(w, *nearest);
}

// The corners of a face laid into the plane, counterclockwise.
struct PlaneFace {
  uint32_t face;
  Vec2 corners[3];

  Vec2 At(const Place& place) const {
    return place.weights[0] * corners[0] + place.weights[1] * corners[1] +
           place.weights[2] * corners[2];
  }
};

// Where the third corner of the face at side h lies if that side runs from
// (0, 0) along the positive x axis. REQUIRES: the side has a length.
Vec2 ApexInFrame(const TriangleSoup& soup, const HalfEdges& edges, uint32_t h) {
  const Vec3 a = ToVec3(soup.positions[edges.From(h)]);
  const Vec3 d = ToVec3(soup.positions[edges.To(h)]) - a;
  const Vec3 e = ToVec3(soup.positions[edges.Opposite(h)]) - a;
  const Real length = Norm(d);
  return {Dot(d, e) / length, Norm(Cross(d, e)) / length};
}

// What lies in a face: nodes that are not its corners, and pieces of curves.
struct Inside {
  std::vector<std::pair<uint32_t, Place>> points;  // node
  struct Piece {
    uint32_t curve;
    Place begin, end;
  };
  std::vector<Piece> pieces;
};

class Unfolder {
 public:
  // `nodes` beyond the vertices.
  Unfolder(const TriangleSoup& soup, const std::vector<SurfacePoint>& nodes,
           const std::vector<Source>& curves)
      : soup_(soup), edges_(soup), inside_(soup.triangles.size()) {
    for (uint32_t v = 0; v < soup.positions.size(); ++v) {
      places_.push_back(PlacesOf(soup, VertexPoint{v}));
      positions_.push_back(ToVec3(soup.positions[v]));
    }
    for (const SurfacePoint& node : nodes) {
      for (const Place& place : places_.emplace_back(PlacesOf(soup, node))) {
        inside_[place.face].points.emplace_back(places_.size() - 1, place);
      }
      positions_.push_back(PositionIn(soup, node));
    }
    for (uint32_t c = 0; c < curves.size(); ++c) {
      AddCurve(c, std::get<Curve>(curves[c].place));
    }
    for (uint32_t h = 0; h < edges_.size(); ++h) {
      const Vec3 a = positions_[edges_.From(h)];
      const Vec3 b = positions_[edges_.To(h)];
      std::vector<Real>& row = straight_.emplace_back();
      for (const Vec3& p : positions_) {
        row.push_back(DistanceToSegment(p, a, b));
      }
    }
    for (uint32_t v = 0; v < soup.positions.size(); ++v) {
      along_edges_.push_back(EdgeDistances(soup, v));
    }
  }

  // The least lengths of straight lines and edges from a node to all nodes,
  // and to all curves. False if that takes more windows than are left.
  bool Unfold(uint32_t node, std::vector<Real>* direct,
              std::vector<Real>* to_curves, uint64_t* windows_left) {
    direct_.assign(positions_.size(), kInfinity);
    direct_[node] = 0;
    to_curves_.assign(curve_nodes_.size(), kInfinity);
    BoundByEdges(node);
    for (const Place& place : places_[node]) OpenFace(place);
    while (!windows_.empty()) {
      if ((*windows_left)-- == 0) return false;
      const Window window = windows_.back();
      windows_.pop_back();
      Propagate(window);
    }
    *direct = direct_;
    *to_curves = to_curves_;
    return true;
  }

 private:
  // Also where a curve is one point or stands still. Its points are pieces by
  // themselves in every face around them: seen from beyond an edge, a piece
  // that ends on it is seen all but edge-on there.
  void AddCurve(uint32_t number, const Curve& curve) {
    std::vector<std::vector<Place>> places;
    for (const SurfacePoint& point : curve.points) {
      places.push_back(PlacesOf(soup_, point));
    }
    curve_nodes_.push_back(places);
    for (size_t i = 0; i < places.size(); ++i) {
      for (const Place& at : places[i]) {
        inside_[at.face].pieces.push_back({number, at, at});
      }
      if (i == 0) continue;
      for (const Place& begin : places[i - 1]) {
        for (const Place& end : places[i]) {
          if (begin.face != end.face) continue;
          inside_[begin.face].pieces.push_back({number, begin, end});
        }
      }
    }
  }

  // Upper bounds on all distances from the node: straight to a corner of its
  // face, along edges, and straight from a corner.
  void BoundByEdges(uint32_t node) {
    bound_.assign(positions_.size(), kInfinity);
    for (const Place& place : places_[node]) {
      for (const uint32_t corner : soup_.triangles[place.face]) {
        const Real to_corner = Norm(positions_[node] - positions_[corner]);
        for (size_t v = 0; v < along_edges_.size(); ++v) {
          bound_[v] = std::min(bound_[v], to_corner + along_edges_[corner][v]);
        }
      }
    }
    if (node < along_edges_.size()) bound_[node] = 0;
    for (size_t p = along_edges_.size(); p < positions_.size(); ++p) {
      bound_[p] = BoundAt(places_[p], positions_[p]);
    }
    curve_bound_.clear();
    for (const std::vector<std::vector<Place>>& curve : curve_nodes_) {
      Real least = kInfinity;
      for (const std::vector<Place>& places : curve) {
        if (places.empty()) continue;
        Vec3 at;
        for (int i = 0; i < 3; ++i) {
          const uint32_t v = soup_.triangles[places[0].face][i];
          at = at + places[0].weights[i] * positions_[v];
        }
        least = std::min(least, BoundAt(places, at));
      }
      curve_bound_.push_back(least);
    }
  }

  Real BoundAt(const std::vector<Place>& places, Vec3 at) const {
    Real least = kInfinity;
    for (const Place& place : places) {
      for (const uint32_t corner : soup_.triangles[place.face]) {
        least = std::min(least, bound_[corner] + Norm(at - positions_[corner]));
      }
    }
    return least;
  }

  void Reach(uint32_t node, Real distance) {
    direct_[node] = std::min(direct_[node], distance);
    bound_[node] = std::min(bound_[node], distance);
  }
  void ReachCurve(uint32_t curve, Real distance) {
    to_curves_[curve] = std::min(to_curves_[curve], distance);
    curve_bound_[curve] = std::min(curve_bound_[curve], distance);
  }

  Real LengthOf(uint32_t h) const {
    return Norm(positions_[edges_.To(h)] - positions_[edges_.From(h)]);
  }
  uint32_t LongestSide(uint32_t face) const {
    uint32_t longest = 3 * face;
    for (uint32_t h = 3 * face + 1; h < 3 * face + 3; ++h) {
      if (LengthOf(h) > LengthOf(longest)) longest = h;
    }
    return longest;
  }

  // The face laid into the plane by one of its sides, with `place` at the
  // origin.
  PlaneFace LayDown(const Place& place, uint32_t base) const {
    PlaneFace plane{.face = place.face, .corners = {}};
    if (LengthOf(base) == 0) return plane;
    plane.corners[NextSide(base) % 3] = {LengthOf(base), 0};
    plane.corners[PreviousSide(base) % 3] = ApexInFrame(soup_, edges_, base);
    const Vec2 origin = plane.At(place);
    for (Vec2& corner : plane.corners) corner = corner - origin;
    // Exactly, where the place is a corner or coincides with one.
    Vec3 at;
    for (int i = 0; i < 3; ++i) {
      at = at + place.weights[i] * positions_[soup_.triangles[place.face][i]];
    }
    for (int i = 0; i < 3; ++i) {
      if (Norm(positions_[soup_.triangles[place.face][i]] - at) == 0) {
        plane.corners[i] = {0, 0};
      }
    }
    return plane;
  }

  // A face that holds the source: all of it is seen.
  void OpenFace(const Place& place) {
    // By the longest, since others may have no length.
    const uint32_t longest = LongestSide(place.face);
    const PlaneFace plane = LayDown(place, longest);
    const Triangle& corners = soup_.triangles[place.face];
    for (int i = 0; i < 3; ++i) Reach(corners[i], Norm(plane.corners[i]));
    for (const auto& [node, at] : inside_[place.face].points) {
      Reach(node, Norm(plane.At(at)));
    }
    for (const Inside::Piece& piece : inside_[place.face].pieces) {
      ReachCurve(piece.curve, Norm(NearestOnSegment(plane.At(piece.begin),
                                                    plane.At(piece.end))));
    }
    for (uint32_t i = 0; i < 3; ++i) {
      // Across a side that holds the source lies another face around it. A
      // corner that coincides with the source opens the faces beyond itself.
      if (place.weights[(i + 2) % 3] == 0) continue;
      // By that side: the height of the source over it, which rounding must not
      // turn over, then is a product.
      const uint32_t side = 3 * place.face + i;
      const PlaneFace by_side =
          LengthOf(side) > 0 ? LayDown(place, side) : plane;
      const Vec2 from = by_side.corners[i], to = by_side.corners[(i + 1) % 3];
      if (Norm(from) == 0 || Norm(to) == 0) continue;
      Push({side, corners[i], from, to, from, to, 0});
    }
  }

  // Through the window's edge into the faces beyond.
  void Propagate(const Window& w) {
    if (!CanImprove(w)) return;
    for (const uint32_t h : edges_.Others(w.half_edge)) Enter(w, h);
  }

  void Enter(const Window& w, uint32_t h) {
    const Vec2 in_frame = ApexInFrame(soup_, edges_, h);
    const Vec2 along = (1 / Norm(w.from - w.to)) * (w.from - w.to);
    // Seen from beyond the edge runs from w.to to w.from, unless the face is
    // turned over.
    const bool is_turned = edges_.From(h) == w.from_vertex;
    const Real x = is_turned ? Norm(w.from - w.to) - in_frame.x : in_frame.x;
    const Vec2 apex = w.to + x * along + in_frame.y * Perpendicular(along);
    if (Sees(w, apex)) Reach(edges_.Opposite(h), ThroughEdge(w, apex));
    LookInside(w, h, apex);
    // An apex where the source is opens the faces beyond by itself.
    if (Norm(apex) <= kLeastOpening * Norm(w.from - w.to)) return;
    const uint32_t at_from = is_turned ? PreviousSide(h) : NextSide(h);
    const uint32_t at_to = is_turned ? NextSide(h) : PreviousSide(h);
    const Vec2 left_end = TurnsLeft(apex, w.left) ? apex : w.left;
    Push({at_from, w.from_vertex, w.from, apex, w.right, left_end, w.least});
    const Vec2 right_end = TurnsLeft(w.right, apex) ? apex : w.right;
    Push({at_to, edges_.Opposite(h), apex, w.to, right_end, w.left, w.least});
  }

  // By way of the edge, lest a window seen edge-on lets the line reach a point
  // that lies before it. The crossing divides the way along the edge by the
  // heights of both over it: seen edge-on, the ray itself would meet the edge
  // anywhere, also beyond a point that lies on it.
  static Real ThroughEdge(const Window& w, Vec2 p) {
    const Real length = Norm(w.to - w.from);
    if (length == 0) return Norm(w.from) + Norm(p - w.from);
    const Vec2 along = (1 / length) * (w.to - w.from);
    const Real before = std::max<Real>(Cross(w.from, along), 0);
    const Real beyond = std::max<Real>(Cross(p - w.from, along), 0);
    const Real here = -Dot(w.from, along), there = Dot(p - w.from, along);
    const Real share = before + beyond > 0 ? before / (before + beyond) : 1;
    const Vec2 crossing =
        w.from +
        std::clamp<Real>(here + share * (there - here), 0, length) * along;
    return Norm(crossing) + Norm(p - crossing);
  }

  // What the window shows in the face at side h.
  void LookInside(const Window& w, uint32_t h, Vec2 apex) {
    const Inside& inside = inside_[h / 3];
    if (inside.points.empty() && inside.pieces.empty()) return;
    const bool is_turned = edges_.From(h) == w.from_vertex;
    PlaneFace plane{.face = h / 3, .corners = {}};
    plane.corners[h % 3] = is_turned ? w.from : w.to;
    plane.corners[NextSide(h) % 3] = is_turned ? w.to : w.from;
    plane.corners[PreviousSide(h) % 3] = apex;
    for (const auto& [node, place] : inside.points) {
      const Vec2 at = plane.At(place);
      if (Sees(w, at)) Reach(node, ThroughEdge(w, at));
    }
    for (const Inside::Piece& piece : inside.pieces) {
      Vec2 nearest;
      if (NearestVisible(w, plane.At(piece.begin), plane.At(piece.end),
                         &nearest)) {
        ReachCurve(piece.curve, ThroughEdge(w, nearest));
      }
    }
  }

  void Push(Window w) {
    if (!IsOpen(w)) return;
    w.least = std::max(w.least, Norm(NearestOnSegment(w.from, w.to)));
    windows_.push_back(w);
  }

  // Whether a path through the window might be shorter than a known one, for
  // some node: it cannot be shorter than the way to the visible part of the
  // edge and a straight line in space from the edge on.
  bool CanImprove(const Window& w) const {
    const Real least = DistanceToVisiblePart(w);
    const std::vector<Real>& onward = straight_[w.half_edge];
    for (size_t v = 0; v < bound_.size(); ++v) {
      if (bound_[v] == kInfinity) continue;  // out of reach altogether
      if (least + onward[v] <= bound_[v] * (1 + kBoundSlack)) return true;
    }
    return std::ranges::any_of(curve_bound_, [&](Real bound) {
      return bound != kInfinity && least <= bound * (1 + kBoundSlack);
    });
  }

  const TriangleSoup& soup_;
  const HalfEdges edges_;
  std::vector<Inside> inside_;              // one per face
  std::vector<std::vector<Place>> places_;  // of nodes
  std::vector<Vec3> positions_;             // of nodes
  std::vector<std::vector<std::vector<Place>>> curve_nodes_;
  std::vector<std::vector<Real>> straight_;     // side to node, in space
  std::vector<std::vector<Real>> along_edges_;  // vertex to vertex
  // From the current source.
  std::vector<Real> direct_, bound_, to_curves_, curve_bound_;
  std::vector<Window> windows_;
};

}  // namespace

BruteForce::BruteForce(const TriangleSoup& soup,
                       const std::vector<SurfacePoint>& points,
                       const std::vector<Source>& curves, uint64_t most_windows)
    : vertex_count_(static_cast<uint32_t>(soup.positions.size())),
      points_(points) {
  for (const Source& curve : curves) {
    curve_offsets_.push_back(curve.offset);
  }
  Unfolder unfolder(soup, points, curves);
  for (uint32_t v = 0; is_complete_ && v < vertex_count_ + points.size(); ++v) {
    is_complete_ = unfolder.Unfold(v, &direct_.emplace_back(),
                                   &to_curves_.emplace_back(), &most_windows);
  }
}

uint32_t BruteForce::NodeAt(const SurfacePoint& point) const {
  if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
    return vertex->vertex;
  }
  const auto at = std::ranges::find(points_, point);
  assert(at != points_.end());
  return vertex_count_ + static_cast<uint32_t>(at - points_.begin());
}

std::vector<double> BruteForce::Spread(std::vector<Real> distances) const {
  // Dijkstra on the complete graph of direct distances.
  std::vector<bool> settled(direct_.size(), false);
  while (true) {
    size_t nearest = direct_.size();
    for (size_t v = 0; v < direct_.size(); ++v) {
      if (settled[v] || distances[v] == kInfinity) continue;
      if (nearest == direct_.size() || distances[v] < distances[nearest]) {
        nearest = v;
      }
    }
    if (nearest == direct_.size()) break;
    settled[nearest] = true;
    for (size_t v = 0; v < direct_.size(); ++v) {
      distances[v] =
          std::min(distances[v], distances[nearest] + direct_[nearest][v]);
    }
  }
  return {distances.begin(), distances.end()};
}

std::vector<Real> BruteForce::Seeds(std::span<const Source> sources) const {
  std::vector<Real> distances(direct_.size(), kInfinity);
  for (const Source& s : sources) {
    Real& distance = distances[NodeAt(std::get<SurfacePoint>(s.place))];
    distance = std::min<Real>(distance, s.offset);
  }
  return distances;
}

std::vector<double> BruteForce::Distances(
    std::span<const Source> sources) const {
  return Spread(Seeds(sources));
}

std::vector<double> BruteForce::Distances(uint32_t source) const {
  const Source sources[] = {{VertexPoint{source}}};
  return Distances(sources);
}

std::vector<double> BruteForce::DistancesFromAll(
    std::span<const Source> sources) const {
  std::vector<Real> distances = Seeds(sources);
  for (size_t v = 0; v < distances.size(); ++v) {
    for (size_t c = 0; c < curve_offsets_.size(); ++c) {
      distances[v] =
          std::min(distances[v], curve_offsets_[c] + to_curves_[v][c]);
    }
  }
  return Spread(std::move(distances));
}

}  // namespace geodesic::test
