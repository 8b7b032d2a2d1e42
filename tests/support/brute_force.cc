#include "tests/support/brute_force.h"

#include <algorithm>
#include <limits>

#include "tests/support/edge_dijkstra.h"
#include "tests/support/half_edges.h"

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
  uint32_t half_edge;
  Vec2 from, to;
  Vec2 right, left;
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

bool Sees(const Window& w, Vec2 p) {
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

// The apex of the face left of half-edge h, in the frame with the half-edge's
// start at the origin and its end on the positive x axis. REQUIRES: the
// half-edge has a length.
Vec2 ApexInFrame(const TriangleSoup& soup, const HalfEdges& edges, uint32_t h) {
  const Vec3 a = ToVec3(soup.positions[edges.From(h)]);
  const Vec3 d = ToVec3(soup.positions[edges.To(h)]) - a;
  const Vec3 e = ToVec3(soup.positions[edges.Opposite(h)]) - a;
  const Real length = Norm(d);
  return {Dot(d, e) / length, Norm(Cross(d, e)) / length};
}

class Unfolder {
 public:
  explicit Unfolder(const TriangleSoup& soup)
      : soup_(soup), edges_(soup), outgoing_(soup.positions.size()) {
    const size_t vertices = soup.positions.size();
    for (uint32_t h = 0; h < edges_.size(); ++h) {
      outgoing_[edges_.From(h)].push_back(h);
      const Vec3 a = ToVec3(soup.positions[edges_.From(h)]);
      const Vec3 b = ToVec3(soup.positions[edges_.To(h)]);
      std::vector<Real>& row = straight_.emplace_back(vertices);
      for (size_t v = 0; v < vertices; ++v) {
        row[v] = DistanceToSegment(ToVec3(soup.positions[v]), a, b);
      }
    }
  }

  // The least lengths of straight lines and edges from `source`.
  std::vector<Real> DirectDistances(uint32_t source) {
    direct_.assign(soup_.positions.size(), kInfinity);
    direct_[source] = 0;
    bound_ = EdgeDistances(soup_, source);
    for (const uint32_t h : outgoing_[source]) OpenFace(source, h);
    while (!windows_.empty()) {
      const Window window = windows_.back();
      windows_.pop_back();
      Propagate(window);
    }
    return direct_;
  }

 private:
  void Reach(uint32_t v, Real distance) {
    direct_[v] = std::min(direct_[v], distance);
    bound_[v] = std::min(bound_[v], distance);
  }

  // The face left of h, which leaves the source, gives the first window.
  void OpenFace(uint32_t source, uint32_t h) {
    const uint32_t b = edges_.To(h), c = edges_.Opposite(h);
    const Real length = Distance(soup_.positions[source], soup_.positions[b]);
    Reach(b, length);
    Reach(c, Distance(soup_.positions[source], soup_.positions[c]));
    if (length == 0) return;  // b opens the faces on the other side
    const Vec2 right{length, 0}, left = ApexInFrame(soup_, edges_, h);
    Push({NextSide(h), right, left, right, left});
  }

  // Through the window's half-edge into the face beyond.
  void Propagate(const Window& w) {
    const uint32_t h = edges_.Twin(w.half_edge);  // runs from w.to to w.from
    if (h == kBorder || !CanImprove(w)) return;
    const Vec2 in_frame = ApexInFrame(soup_, edges_, h);
    const Vec2 along = (1 / Norm(w.from - w.to)) * (w.from - w.to);
    const Vec2 apex =
        w.to + in_frame.x * along + in_frame.y * Perpendicular(along);
    if (Sees(w, apex)) {
      // By way of the half-edge, lest a window seen edge-on lets the line reach
      // an apex that lies before it.
      const Vec2 crossing = OnRay(apex, w.from, w.to);
      Reach(edges_.Opposite(h), Norm(crossing) + Norm(apex - crossing));
    }
    // An apex where the source is opens the faces beyond by itself.
    if (Norm(apex) <= kLeastOpening * Norm(w.from - w.to)) return;
    const Vec2 left_end = TurnsLeft(apex, w.left) ? apex : w.left;
    Push({NextSide(h), w.from, apex, w.right, left_end});
    const Vec2 right_end = TurnsLeft(w.right, apex) ? apex : w.right;
    Push({PreviousSide(h), apex, w.to, right_end, w.left});
  }

  void Push(const Window& w) {
    if (IsOpen(w)) windows_.push_back(w);
  }

  // Whether a path through the window might be shorter than a known one, for
  // some vertex: it cannot be shorter than the way to the visible part of the
  // half-edge and a straight line in space from the half-edge on.
  bool CanImprove(const Window& w) const {
    const Real least = DistanceToVisiblePart(w);
    const std::vector<Real>& onward = straight_[w.half_edge];
    for (size_t v = 0; v < bound_.size(); ++v) {
      if (bound_[v] == kInfinity) continue;  // out of reach altogether
      if (least + onward[v] <= bound_[v] * (1 + kBoundSlack)) return true;
    }
    return false;
  }

  const TriangleSoup& soup_;
  const HalfEdges edges_;
  std::vector<std::vector<uint32_t>> outgoing_;
  std::vector<std::vector<Real>> straight_;  // half-edge to vertex, in space
  std::vector<Real> direct_, bound_;         // from the current source
  std::vector<Window> windows_;
};

}  // namespace

BruteForce::BruteForce(const TriangleSoup& soup) {
  Unfolder unfolder(soup);
  for (uint32_t v = 0; v < soup.positions.size(); ++v) {
    direct_.push_back(unfolder.DirectDistances(v));
  }
}

std::vector<double> BruteForce::Distances(
    std::span<const Source> sources) const {
  std::vector<Real> distances(direct_.size(), kInfinity);
  for (const Source& s : sources) {
    Real& distance = distances[std::get<VertexPoint>(s.point).vertex];
    distance = std::min<Real>(distance, s.offset);
  }
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

std::vector<double> BruteForce::Distances(uint32_t source) const {
  const Source sources[] = {{VertexPoint{source}}};
  return Distances(sources);
}

}  // namespace geodesic::test
