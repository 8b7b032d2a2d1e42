// Garland, Heckbert: Surface simplification using quadric error metrics.
// SIGGRAPH 1997; here by collapses of half-edges, as in Kobbelt, Campagna,
// Seidel: A general framework for mesh decimation. Graphics Interface 1998, so
// that vertices stay where they are.
//
// Collapses are made in passes. A pass finds the best target of each vertex,
// then goes through the vertices in order of their errors, up to a limit, and
// touches no target twice. Legality is always that of the moment. Every step
// takes bounded time, because vertices of many faces take no part: a heap of
// vertices, or vertices of any valence, would make it slower by orders.

#include "geodesic/decimate.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

#include "geodesic_types/field_path.h"
#include "mesh/scaled_difference.h"

namespace geodesic {
namespace {

constexpr uint32_t kNone = 0xffffffffu;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// How far a boundary may move, as a share of the bounding box's diagonal: half
// a pixel of a picture with a thousand.
constexpr double kBoundaryShare = 5e-4;
// The cosine of the largest angle that a face turns by in one collapse.
constexpr double kLeastCosine = 0.3;
// A face that comes to be narrower than this, compared with its longest side,
// keeps at least that share of its width: colours are interpolated inside
// faces.
constexpr double kLeastWidth = 0.1;
constexpr double kWidthKept = 0.8;
// What the fourth power of an edge's length adds to the quadric error of its
// collapse, an area times a square of a distance: in a plane, where that is
// nothing, short edges go first.
constexpr double kEdgeShare = 1e-6;
// Vertices of more faces stay, and no vertex comes to have more.
constexpr uint32_t kMostFaces = 24;
// A pass collapses at most this share of the vertices, those of least error.
constexpr uint32_t kPassShare = 3;
// It ends when a pass over all vertices collapses less than this share.
constexpr uint32_t kLeastShare = 50;
// Faces or vertices between two polls, each about a microsecond.
constexpr uint32_t kStepsPerPoll = 1024;

// The sum of weighted squares of the distances from planes.
struct Quadric {
  // Of the plane through `point` with a normal of length sqrt(weight).
  void AddPlane(const Vector& n, const Vector& point) {
    const double d = -Dot(n, point);
    const std::array<double, 10> plane = {
        n[0] * n[0], n[0] * n[1], n[0] * n[2], n[0] * d, n[1] * n[1],
        n[1] * n[2], n[1] * d,    n[2] * n[2], n[2] * d, d * d};
    for (size_t i = 0; i < terms.size(); ++i) terms[i] += plane[i];
  }
  void Add(const Quadric& other) {
    for (size_t i = 0; i < terms.size(); ++i) terms[i] += other.terms[i];
  }
  double At(const Vector& p) const {
    const auto& [xx, xy, xz, xd, yy, yz, yd, zz, zd, dd] = terms;
    return p[0] * (xx * p[0] + 2 * (xy * p[1] + xz * p[2] + xd)) +
           p[1] * (yy * p[1] + 2 * (yz * p[2] + yd)) +
           p[2] * (zz * p[2] + 2 * zd) + dd;
  }

  std::array<double, 10> terms = {};
};

Vector Minus(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

// The distance of `point` from the segment between `a` and `b`.
double DistanceFromSegment(const Vector& point, const Vector& a,
                           const Vector& b) {
  const Vector along = Minus(b, a);
  const double square = Dot(along, along);
  const Vector offset = Minus(point, a);
  const double t =
      square > 0 ? std::clamp(Dot(offset, along) / square, 0.0, 1.0) : 0.0;
  return Norm(Minus(offset, {along[0] * t, along[1] * t, along[2] * t}));
}

// How wide a face is compared with its longest side, from 0 to 0.87: `cross` is
// twice its area, `side` and `edge` are two sides from one corner.
double Width(double cross, const Vector& side, const Vector& edge) {
  const Vector third = Minus(edge, side);
  return cross /
         std::max({Dot(side, side), Dot(edge, edge), Dot(third, third)});
}

class Decimater {
 public:
  Decimater(const Mesh& mesh, uint64_t max_faces, Checkpoint& checkpoint)
      : mesh_(mesh), max_faces_(max_faces), checkpoint_(checkpoint) {}

  absl::StatusOr<std::vector<Triangle>> Run();

 private:
  // The faces and neighbours of a vertex of at most kMostFaces faces.
  struct Ring {
    std::array<uint32_t, kMostFaces> faces;
    uint32_t face_count = 0;
    // Each with how many faces its edge has.
    std::array<std::pair<uint32_t, uint32_t>, 2 * kMostFaces> neighbours;
    uint32_t neighbour_count = 0;

    std::span<const uint32_t> Faces() const {
      return {faces.data(), face_count};
    }
    std::span<const std::pair<uint32_t, uint32_t>> Neighbours() const {
      return {neighbours.data(), neighbour_count};
    }
  };

  void PlaceVertices();
  absl::Status AddFaces();
  void KeepIrregularVertices();

  // Finds the best target of each vertex.
  absl::Status FindTargets();
  // Orders the vertices that have a target by their errors, up to 1% or so.
  void OrderByError();
  // Returns how many collapses it made.
  absl::StatusOr<uint32_t> CollapseUpTo(size_t count);

  void Propose(uint32_t from, uint32_t to);
  float ErrorOf(uint32_t from, uint32_t to) const;
  // The legal target of least error, or kNone.
  uint32_t BestLegalTarget(uint32_t from, const Ring& ring);
  bool IsLegal(uint32_t from, uint32_t to, const Ring& ring);
  bool KeepsTopology(uint32_t from, uint32_t to, const Ring& ring);
  bool SpoilsFace(uint32_t from, uint32_t to, const Ring& ring) const;
  // How far the boundary is from where it was at first, at most, after the
  // collapse. REQUIRES: `from` is on a boundary, and so is the edge.
  double BoundaryMoves(uint32_t from, uint32_t to, const Ring& ring) const;
  static uint32_t OtherOnBoundary(uint32_t to, const Ring& ring);
  void Collapse(uint32_t from, uint32_t to, const Ring& ring);

  // Forgets dead faces on the way. Nothing if there are too many.
  bool FindRing(uint32_t vertex, Ring& ring);
  bool IsDead(uint32_t face) const { return triangles_[face][0] == kNone; }
  bool Has(uint32_t face, uint32_t vertex) const {
    const Triangle& t = triangles_[face];
    return t[0] == vertex || t[1] == vertex || t[2] == vertex;
  }
  absl::Status Step() {
    return ++steps_ % kStepsPerPoll == 0 ? checkpoint_.Poll({})
                                         : absl::OkStatus();
  }

  const Mesh& mesh_;
  const uint64_t max_faces_;
  Checkpoint& checkpoint_;
  uint64_t steps_ = 0;

  // Of vertices:
  std::vector<Vector> points_;  // in the scaled unit, around the origin
  std::vector<Quadric> quadrics_;
  std::vector<uint8_t> is_kept_;     // is neither collapsed nor a target
  std::vector<uint8_t> is_touched_;  // was a target in this pass
  std::vector<float> moved_;         // how far boundary edges here have moved
  std::vector<uint32_t> first_;      // corner
  std::vector<uint32_t> targets_;
  std::vector<float> errors_;
  std::vector<uint32_t> marks_;
  uint32_t mark_ = 0;
  std::vector<uint32_t> order_;

  // Of faces, in the mesh's own order, in which neighbours are close:
  std::vector<Triangle> triangles_;  // kNone first in dead ones
  std::vector<uint32_t> next_;       // of each corner, the next at its vertex
  uint64_t face_count_ = 0;          // alive
  double tolerance_ = 0;             // for boundaries
};

void Decimater::PlaceVertices() {
  Point low = mesh_.positions()[0], high = low;
  for (const Point& point : mesh_.positions()) {
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], point[i]);
      high[i] = std::max(high[i], point[i]);
    }
  }
  const Point center = {low[0] / 2 + high[0] / 2, low[1] / 2 + high[1] / 2,
                        low[2] / 2 + high[2] / 2};
  const ScaledDifference scaled(mesh_.scale_exponent());
  points_.reserve(mesh_.vertex_count());
  for (const Point& point : mesh_.positions()) {
    points_.push_back(scaled(center, point));
  }
  tolerance_ = kBoundaryShare * Norm(scaled(low, high));
}

absl::Status Decimater::AddFaces() {
  face_count_ = mesh_.half_edge_count() / 3;
  triangles_.resize(face_count_);
  next_.resize(3 * face_count_);
  first_.assign(mesh_.vertex_count(), kNone);
  quadrics_.resize(mesh_.vertex_count());
  // Backwards, so that the corners of a vertex are in order.
  for (uint32_t f = face_count_; f-- > 0;) {
    if (absl::Status s = Step(); !s.ok()) return s;
    const Triangle& triangle = triangles_[f] = mesh_.TriangleOf(3 * f);
    for (uint32_t i = 0; i < 3; ++i) {
      next_[3 * f + i] = first_[triangle[i]];
      first_[triangle[i]] = 3 * f + i;
    }
    const Vector& a = points_[triangle[0]];
    Vector normal =
        Cross(Minus(points_[triangle[1]], a), Minus(points_[triangle[2]], a));
    const double length = Norm(normal);
    if (!(length > 0)) continue;
    // A plane counts by the area of its face.
    const double factor = std::sqrt(length / 2) / length;
    for (double& x : normal) x *= factor;
    Quadric quadric;
    quadric.AddPlane(normal, a);
    for (const uint32_t v : triangle) quadrics_[v].Add(quadric);
  }
  return absl::OkStatus();
}

void Decimater::KeepIrregularVertices() {
  is_kept_.resize(mesh_.vertex_count());
  for (uint32_t v = 0; v < mesh_.vertex_count(); ++v) {
    is_kept_[v] =
        mesh_.IsNonManifold(v) || mesh_.Outgoing(v).size() > kMostFaces;
  }
  if (!mesh_.HasIrregularEdges()) return;
  for (HalfEdge h = 0; h < mesh_.half_edge_count(); ++h) {
    if (!mesh_.IsIrregularEdge(h)) continue;
    is_kept_[mesh_.From(h)] = is_kept_[mesh_.To(h)] = true;
  }
}

absl::StatusOr<std::vector<Triangle>> Decimater::Run() {
  if (absl::Status s = checkpoint_.Poll({}); !s.ok()) return s;
  PlaceVertices();
  if (absl::Status s = AddFaces(); !s.ok()) return s;
  KeepIrregularVertices();
  is_touched_.resize(mesh_.vertex_count());
  moved_.resize(mesh_.vertex_count());
  marks_.resize(mesh_.vertex_count());
  uint32_t share = kPassShare;
  while (face_count_ > max_faces_) {
    if (absl::Status s = FindTargets(); !s.ok()) return s;
    OrderByError();
    if (absl::Status s = checkpoint_.Poll({}); !s.ok()) return s;
    const absl::StatusOr<uint32_t> made =
        CollapseUpTo(order_.size() / share + 1);
    if (!made.ok()) return made.status();
    if (*made > order_.size() / kLeastShare) continue;
    if (share == 1) break;
    share = 1;
  }
  std::vector<Triangle> triangles;
  triangles.reserve(face_count_);
  for (uint32_t f = 0; f < mesh_.face_count(); ++f) {
    if (mesh_.IsLeftOut(f)) continue;
    const uint32_t slot = mesh_.FirstSide(f) / 3;
    if (!IsDead(slot)) triangles.push_back(triangles_[slot]);
  }
  return triangles;
}

float Decimater::ErrorOf(uint32_t from, uint32_t to) const {
  const Vector along = Minus(points_[to], points_[from]);
  const double square = Dot(along, along);
  const double error =
      quadrics_[from].At(points_[to]) + quadrics_[to].At(points_[to]);
  return static_cast<float>(std::max(error, 0.0) +
                            kEdgeShare * square * square);
}

void Decimater::Propose(uint32_t from, uint32_t to) {
  if (is_kept_[from] || is_kept_[to]) return;
  if (mesh_.IsBoundary(from) && !mesh_.IsBoundary(to)) return;
  const float error = ErrorOf(from, to);
  if (error > errors_[from] || (error == errors_[from] && to > targets_[from]))
    return;
  errors_[from] = error;
  targets_[from] = to;
}

absl::Status Decimater::FindTargets() {
  targets_.assign(mesh_.vertex_count(), kNone);
  errors_.assign(mesh_.vertex_count(), kInfinity);
  for (uint32_t f = 0; f < mesh_.half_edge_count() / 3; ++f) {
    if (IsDead(f)) continue;
    if (absl::Status s = Step(); !s.ok()) return s;
    const Triangle triangle = triangles_[f];
    for (uint32_t i = 0; i < 3; ++i) {
      const uint32_t from = triangle[i], to = triangle[(i + 1) % 3];
      // The face beyond the side proposes the other direction, if there is one.
      Propose(from, to);
      if (mesh_.IsBoundary(from) && mesh_.IsBoundary(to)) Propose(to, from);
    }
  }
  return absl::OkStatus();
}

void Decimater::OrderByError() {
  // Floats from 0 on are in the order of their bits; the upper half will do.
  constexpr size_t kKeys = size_t{1} << 16;
  const auto key = [&](uint32_t v) {
    return std::bit_cast<uint32_t>(errors_[v]) >> 16;
  };
  std::vector<uint32_t> begins(kKeys + 1);
  for (uint32_t v = 0; v < mesh_.vertex_count(); ++v) {
    if (targets_[v] != kNone) ++begins[key(v) + 1];
  }
  for (size_t k = 0; k < kKeys; ++k) begins[k + 1] += begins[k];
  order_.resize(begins[kKeys]);
  for (uint32_t v = 0; v < mesh_.vertex_count(); ++v) {
    if (targets_[v] != kNone) order_[begins[key(v)]++] = v;
  }
}

absl::StatusOr<uint32_t> Decimater::CollapseUpTo(size_t count) {
  std::ranges::fill(is_touched_, 0);
  const float limit =
      errors_[order_.empty() ? 0 : order_[std::min(count, order_.size()) - 1]];
  uint32_t made = 0;
  Ring ring;
  for (size_t i = 0; i < std::min(count, order_.size()); ++i) {
    if (face_count_ <= max_faces_) break;
    if (absl::Status s = Step(); !s.ok()) return s;
    const uint32_t from = order_[i];
    if (is_touched_[from] || !FindRing(from, ring)) continue;
    uint32_t to = targets_[from];
    if (is_touched_[to] || !IsLegal(from, to, ring)) {
      to = BestLegalTarget(from, ring);
      if (to == kNone || ErrorOf(from, to) > limit) continue;
    }
    Collapse(from, to, ring);
    ++made;
  }
  return made;
}

bool Decimater::FindRing(uint32_t vertex, Ring& ring) {
  ring.face_count = ring.neighbour_count = 0;
  for (uint32_t* corner = &first_[vertex]; *corner != kNone;) {
    const uint32_t face = *corner / 3;
    if (IsDead(face)) {
      *corner = next_[*corner];
      continue;
    }
    if (ring.face_count == kMostFaces) return false;
    ring.faces[ring.face_count++] = face;
    for (const uint32_t v : triangles_[face]) {
      if (v == vertex) continue;
      const auto end = ring.neighbours.begin() + ring.neighbour_count;
      const auto it = std::find_if(ring.neighbours.begin(), end,
                                   [&](const auto& n) { return n.first == v; });
      if (it == end) {
        *end = {v, 1};
        ++ring.neighbour_count;
      } else {
        ++it->second;
      }
    }
    corner = &next_[*corner];
  }
  return true;
}

uint32_t Decimater::BestLegalTarget(uint32_t from, const Ring& ring) {
  uint32_t best = kNone;
  float best_error = kInfinity;
  for (const auto& [to, faces] : ring.Neighbours()) {
    if (is_kept_[to] || is_touched_[to]) continue;
    const float error = ErrorOf(from, to);
    if (error < best_error && IsLegal(from, to, ring)) {
      best = to;
      best_error = error;
    }
  }
  return best;
}

bool Decimater::IsLegal(uint32_t from, uint32_t to, const Ring& ring) {
  return KeepsTopology(from, to, ring) &&
         (!mesh_.IsBoundary(from) ||
          BoundaryMoves(from, to, ring) <= tolerance_) &&
         !SpoilsFace(from, to, ring);
}

bool Decimater::KeepsTopology(uint32_t from, uint32_t to, const Ring& ring) {
  uint32_t shared = 0;  // faces with both
  ++mark_;
  for (const auto& [v, faces] : ring.Neighbours()) {
    if (v == to) shared = faces;
    marks_[v] = mark_;
  }
  // The edge may be gone. Boundaries collapse along themselves only.
  if (shared != (mesh_.IsBoundary(from) ? 1 : 2)) return false;
  if (mesh_.IsBoundary(from) && !mesh_.IsBoundary(to)) return false;
  // Some face must be left, which then has another vertex than these two.
  if (ring.face_count <= shared) return false;
  Ring other;
  if (!FindRing(to, other) ||
      ring.face_count + other.face_count - 2 * shared > kMostFaces) {
    return false;
  }
  // The neighbours of both are the corners of the faces that go, and no others.
  uint32_t common = 0;
  for (const auto& [v, faces] : other.Neighbours()) {
    if (marks_[v] == mark_) ++common;
  }
  if (common != shared) return false;
  // Two faces of the same corners would be all that is left of a tetrahedron.
  std::array<uint32_t, 2> apexes = {kNone, kNone};
  uint32_t count = 0;
  for (const auto& [v, faces] : other.Neighbours()) {
    if (marks_[v] == mark_) apexes[count++] = v;
  }
  const auto closes = [&](uint32_t face) {
    return Has(face, apexes[0]) && Has(face, apexes[1]);
  };
  return shared < 2 || !std::ranges::any_of(ring.Faces(), closes) ||
         !std::ranges::any_of(other.Faces(), closes);
}

bool Decimater::SpoilsFace(uint32_t from, uint32_t to, const Ring& ring) const {
  for (const uint32_t face : ring.Faces()) {
    if (Has(face, to)) continue;
    const Triangle& t = triangles_[face];
    const uint32_t i = t[0] == from ? 0 : t[1] == from ? 1 : 2;
    const Vector& a = points_[t[(i + 1) % 3]];
    const Vector side = Minus(points_[t[(i + 2) % 3]], a);
    const Vector before = Cross(side, Minus(points_[from], a));
    const Vector after = Cross(side, Minus(points_[to], a));
    const double length = Norm(before);
    // Faces without area may become anything.
    if (!(length > 0)) continue;
    const double new_length = Norm(after);
    if (!(Dot(before, after) > kLeastCosine * length * new_length)) return true;
    const double width = Width(new_length, side, Minus(points_[to], a));
    if (width < kLeastWidth &&
        width < kWidthKept * Width(length, side, Minus(points_[from], a))) {
      return true;
    }
  }
  return false;
}

uint32_t Decimater::OtherOnBoundary(uint32_t to, const Ring& ring) {
  for (const auto& [v, faces] : ring.Neighbours()) {
    if (faces == 1 && v != to) return v;
  }
  return to;
}

double Decimater::BoundaryMoves(uint32_t from, uint32_t to,
                                const Ring& ring) const {
  const uint32_t other = OtherOnBoundary(to, ring);
  return std::max({moved_[from], moved_[to], moved_[other]}) +
         DistanceFromSegment(points_[from], points_[other], points_[to]);
}

void Decimater::Collapse(uint32_t from, uint32_t to, const Ring& ring) {
  if (mesh_.IsBoundary(from)) {
    const auto moved = static_cast<float>(BoundaryMoves(from, to, ring));
    moved_[to] = moved_[OtherOnBoundary(to, ring)] = moved;
  }
  for (uint32_t corner = first_[from]; corner != kNone;) {
    const uint32_t next = next_[corner];
    const uint32_t face = corner / 3;
    if (Has(face, to)) {
      triangles_[face][0] = kNone;
      --face_count_;
    } else {
      triangles_[face][corner % 3] = to;
      next_[corner] = first_[to];
      first_[to] = corner;
    }
    corner = next;
  }
  first_[from] = kNone;
  quadrics_[to].Add(quadrics_[from]);
  is_touched_[to] = true;
}

}  // namespace

absl::StatusOr<std::vector<Triangle>> Decimate(const Mesh& mesh,
                                               uint64_t max_faces,
                                               Checkpoint& checkpoint) {
  if (max_faces == 0) {
    return InvalidField("max_faces", "max_faces is 0; it must be at least 1");
  }
  return Decimater(mesh, max_faces, checkpoint).Run();
}

uint64_t EstimateDecimateBytes(const Mesh& mesh) {
  constexpr uint64_t kVertexBytes = sizeof(Vector) + sizeof(Quadric) + 32;
  // With the result.
  constexpr uint64_t kFaceBytes = 3 * sizeof(Triangle);
  return mesh.vertex_count() * kVertexBytes + mesh.face_count() * kFaceBytes;
}

}  // namespace geodesic
