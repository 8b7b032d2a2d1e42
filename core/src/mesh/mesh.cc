#include "geodesic/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "absl/strings/str_cat.h"
#include "geodesic/checkpoint.h"
#include "mesh/connectivity.h"
#include "mesh/large_pages.h"
#include "mesh/locality.h"
#include "mesh/same_edges.h"
#include "mesh/scaled_difference.h"
#include "tolerances.h"

namespace geodesic {

// The sum of the angles of the faces around each vertex. A direction is turned
// by one face's angle after another: a rotation costs four products where the
// angle itself would cost an arc tangent, and errs as little (about 2e-16 a
// face).
class ConeAngles {
 public:
  explicit ConeAngles(uint32_t vertices) : cones_(vertices) {}

  void Prefetch(uint32_t v) const { __builtin_prefetch(&cones_[v]); }

  // Adds the angle of the unit vector (x, y), y >= 0: from 0 to pi.
  void Add(uint32_t v, double x, double y) {
    Cone& cone = cones_[v];
    const bool was_below = cone.IsBelow();
    cone = {cone.x * x - cone.y * y, cone.x * y + cone.y * x, cone.turns};
    // By pi at the most: out of the lower half only past 2 pi.
    cone.turns += was_below & !cone.IsBelow();
  }

  // Whether the angle exceeds this one. Most need no arc tangent.
  bool Exceeds(uint32_t v, double angle) const {
    return kTurn * (cones_[v].turns + 1) > angle && Of(v) > angle;
  }

  // In radians.
  double Of(uint32_t v) const {
    const Cone& cone = cones_[v];
    const double angle = std::atan2(std::abs(cone.y), cone.x);
    return kTurn * cone.turns + (cone.IsBelow() ? kTurn - angle : angle);
  }

 private:
  static constexpr double kTurn = 2 * std::numbers::pi;

  struct Cone {
    double x = 1, y = 0;
    uint32_t turns = 0;

    // Whether the direction is at pi or beyond. Without a branch, for it cannot
    // be foreseen.
    bool IsBelow() const { return (y < 0) | ((y == 0) & (x < 0)); }
  };

  std::vector<Cone> cones_;
};

namespace {

// Joined vertices of a soup that another program may have sent.
absl::Status CheckJoined(const TriangleSoup& soup) {
  const std::vector<JoinedVertex>& joined = soup.reading.joined;
  for (size_t i = 0; i < joined.size(); ++i) {
    const auto& [vertex, into] = joined[i];
    if (vertex >= soup.positions.size() || into >= vertex ||
        (i > 0 && joined[i - 1].vertex >= vertex)) {
      return absl::InvalidArgumentError(
          absl::StrCat("joined vertex ", i, " (", vertex, " into ", into,
                       ") is out of order or out of range"));
    }
  }
  return absl::OkStatus();
}

absl::Status CheckSoup(const TriangleSoup& soup) {
  constexpr uint64_t kMostVertices = std::numeric_limits<uint32_t>::max() / 2;
  constexpr uint64_t kMostFaces = (kIrregularExit - 1) / 3;
  const uint64_t vertices = soup.positions.size();
  const uint64_t faces = soup.triangles.size();
  if (vertices > kMostVertices || faces > kMostFaces) {
    return absl::ResourceExhaustedError(
        absl::StrCat("a mesh of ", vertices, " vertices and ", faces,
                     " faces is too large: at most ", kMostVertices,
                     " vertices and ", kMostFaces, " faces are possible"));
  }
  if (faces == 0) {
    return absl::InvalidArgumentError(
        absl::StrCat("the mesh has no faces (", vertices,
                     " vertices): there is no surface to measure on"));
  }
  for (uint64_t v = 0; v < vertices; ++v) {
    for (double x : soup.positions[v]) {
      if (!std::isfinite(x)) {
        return absl::InvalidArgumentError(absl::StrCat(
            "vertex ", v, " has a coordinate that is not finite (", x, ")"));
      }
    }
  }
  for (uint64_t f = 0; f < faces; ++f) {
    for (const uint32_t v : soup.triangles[f]) {
      if (v >= vertices) {
        return absl::InvalidArgumentError(
            absl::StrCat("face ", f, " names vertex ", v, ", but there are ",
                         vertices, " vertices"));
      }
    }
  }
  return CheckJoined(soup);
}

// Lets the faces name the vertices that others were joined into. Returns what
// they named before; nothing if none were.
std::vector<Triangle> NameJoined(TriangleSoup& soup) {
  if (soup.reading.joined.empty()) return {};
  std::vector<Triangle> named = soup.triangles;
  std::vector<uint32_t> into(soup.positions.size());
  std::iota(into.begin(), into.end(), 0u);
  for (const JoinedVertex& joined : soup.reading.joined) {
    into[joined.vertex] = joined.into;
  }
  for (Triangle& corners : soup.triangles) {
    for (uint32_t& v : corners) v = into[v];
  }
  return named;
}

absl::Status CheckSurface(const TriangleSoup& soup) {
  if (!std::ranges::all_of(soup.triangles, RepeatsVertex)) {
    return absl::OkStatus();
  }
  return absl::InvalidArgumentError(
      absl::StrCat("each of the mesh's ", soup.triangles.size(),
                   " faces names a vertex twice",
                   soup.reading.joined.empty() ? "" : ", as joined",
                   ": there is no surface to measure on"));
}

// The exponent e for which the mesh's longest extent lies in [2^(e-1), 2^e).
int ScaleExponent(std::span<const Point> positions) {
  const auto [low, high] = BoxAround(positions);
  double longest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    longest = std::max(longest, high[axis] / 4 - low[axis] / 4);
  }
  if (longest == 0) return 0;
  // 2^(2 - e) must stay a normal number.
  return std::clamp(std::ilogb(longest) + 3, -1000, 1027);
}

// A face laid into the plane, once from each of its sides: The frames of the
// face's sides, the first of which runs from the first corner to the second,
// but for where they lead.
std::array<HalfEdgeFrame, 3> LayOutFace(
    const std::array<const Point*, 3>& corners,
    const ScaledDifference& difference) {
  std::array<HalfEdgeFrame, 3> frames;
  const std::array<Vector, 3> sides = {difference(*corners[0], *corners[1]),
                                       difference(*corners[1], *corners[2]),
                                       difference(*corners[2], *corners[0])};
  const std::array<double, 3> lengths = {Norm(sides[0]), Norm(sides[1]),
                                         Norm(sides[2])};
  // From side i to the next.
  const std::array<double, 3> dots = {Dot(sides[0], sides[1]),
                                      Dot(sides[1], sides[2]),
                                      Dot(sides[2], sides[0])};
  // Coordinates rather than the three lengths: a cap's height is far below one
  // rounding of its lengths. And from the two shorter sides: the product of
  // long ones cancels in a needle. Compared without a branch, for which side is
  // longest cannot be foreseen.
  int longest = lengths[1] > lengths[0] ? 1 : 0;
  longest = lengths[2] > lengths[longest] ? 2 : longest;
  const double twice_area =
      Norm(Cross(sides[(longest + 1) % 3], sides[(longest + 2) % 3]));
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3, previous = (i + 2) % 3;
    const double length = lengths[i], left = lengths[previous],
                 right = lengths[next];
    HalfEdgeFrame& frame = frames[i];
    frame.length = length;
    if (length > 0) {
      frame.apex_x = -dots[previous] / length;
      frame.apex_y = std::max(twice_area / length, kLeastHeight);
    } else {
      frame.apex_x = 0;
      frame.apex_y = std::max(left, kLeastHeight);
    }
    // Each direction from its own side's coordinates: apex_x - length cancels
    // where the side is short. A side without length carries no window, and
    // any unit vector will do.
    frame.left_x = left > 0 ? frame.apex_x / left : 0;
    frame.left_y = left > 0 ? frame.apex_y / left : 1;
    frame.right_x = right > 0 && length > 0 ? dots[i] / length / right : -1;
    frame.right_y = right > 0 && length > 0 ? frame.apex_y / right : 0;
  }
  return frames;
}

}  // namespace

absl::StatusOr<std::shared_ptr<const Mesh>> Mesh::Build(TriangleSoup soup) {
  NoCheckpoint checkpoint;
  return Build(std::move(soup), checkpoint);
}

absl::StatusOr<std::shared_ptr<const Mesh>> Mesh::Build(
    TriangleSoup soup, Checkpoint& checkpoint) {
  if (absl::Status status = CheckSoup(soup); !status.ok()) return status;
  std::vector<Triangle> named = NameJoined(soup);
  if (absl::Status status = CheckSurface(soup); !status.ok()) return status;
  if (absl::Status status = checkpoint.Poll({}); !status.ok()) return status;
  std::shared_ptr<Mesh> mesh(new Mesh(std::move(soup), std::move(named)));
  if (absl::Status status = checkpoint.Poll({}); !status.ok()) return status;
  Connectivity connectivity = FindConnectivity(
      {std::span(mesh->triangles_).first(mesh->half_edge_count() / 3),
       mesh->outgoing_begin_, mesh->outgoing_, mesh->named_, mesh->faces_});
  mesh->irregular_begin_ = std::move(connectivity.irregular_begin);
  mesh->irregular_half_edges_ = std::move(connectivity.irregular_half_edges);
  mesh->irregular_begin_.shrink_to_fit();
  mesh->irregular_half_edges_.shrink_to_fit();
  if (absl::Status status = checkpoint.Poll({}); !status.ok()) return status;
  ConeAngles angles(mesh->vertex_count());
  if (absl::Status status =
          mesh->BuildFrames(connectivity.exits, angles, checkpoint);
      !status.ok()) {
    return status;
  }
  mesh->FindCopies();
  if (absl::Status status = checkpoint.Poll({}); !status.ok()) return status;
  mesh->ClassifyVertices(connectivity.is_closed_fan, angles);
  return mesh;
}

uint64_t Mesh::EstimateResidentBytes(uint64_t vertices, uint64_t faces) {
  return sizeof(Mesh) +
         faces * (3 * sizeof(HalfEdgeFrame) + sizeof(Triangle) +
                  3 * sizeof(HalfEdge) + 2 * sizeof(uint32_t)) +
         // At irregular edges: as many half-edges, half as many edges.
         faces * (3 * sizeof(HalfEdge) + 3 * sizeof(uint32_t) / 2) + faces / 8 +
         vertices * (sizeof(Point) + sizeof(uint32_t) + sizeof(uint8_t)) +
         sizeof(uint32_t);
}

uint64_t Mesh::EstimateBuildBytes(uint64_t vertices, uint64_t faces) {
  // While frames are built; what the earlier steps need is gone by then.
  constexpr uint64_t kAnglesPerVertex = sizeof(double) * 3;
  return EstimateResidentBytes(vertices, faces) + 3 * faces * sizeof(Exit) +
         vertices * (kAnglesPerVertex + sizeof(uint8_t));
}

uint32_t Mesh::MostFacesAtEdge() const {
  uint32_t most = 2;
  for (size_t i = 1; i < irregular_begin_.size(); ++i) {
    most = std::max(most, irregular_begin_[i] - irregular_begin_[i - 1]);
  }
  return most;
}

void Mesh::FindCopies() {
  // Faces with an edge and the apex over it in common.
  std::vector<std::pair<uint32_t, HalfEdge>> over_edge;
  for (size_t i = 1; i < irregular_begin_.size(); ++i) {
    over_edge.clear();
    for (uint32_t j = irregular_begin_[i - 1]; j < irregular_begin_[i]; ++j) {
      const HalfEdge h = irregular_half_edges_[j];
      over_edge.emplace_back(Apex(h), h);
    }
    std::ranges::sort(over_edge);
    for (size_t j = 1; j < over_edge.size(); ++j) {
      if (over_edge[j].first != over_edge[j - 1].first ||
          !HaveSameEdges(*this, over_edge[j].second, over_edge[j - 1].second)) {
        continue;
      }
      copies_.resize(face_count());
      copies_[over_edge[j].second / 3] = true;
    }
  }
}

uint64_t Mesh::resident_bytes() const {
  return sizeof(Mesh) + reading_.joined.capacity() * sizeof(JoinedVertex) +
         named_.capacity() * sizeof(Triangle) +
         positions_.capacity() * sizeof(Point) +
         (faces_.capacity() + slots_.capacity()) * sizeof(uint32_t) +
         triangles_.capacity() * sizeof(Triangle) +
         half_edge_count() * sizeof(HalfEdgeFrame) +
         outgoing_begin_.capacity() * sizeof(uint32_t) +
         outgoing_.capacity() * sizeof(HalfEdge) + kinds_.capacity() +
         irregular_begin_.capacity() * sizeof(uint32_t) +
         irregular_half_edges_.capacity() * sizeof(HalfEdge) +
         copies_.capacity() / 8;
}

Mesh::Mesh(TriangleSoup soup, std::vector<Triangle> named)
    : named_(std::move(named)),
      faces_(FacesAlongCurve(soup)),
      slots_(MakeLargeVector<uint32_t>(faces_.size())),
      scale_exponent_(ScaleExponent(soup.positions)) {
  half_edge_count_ = 3 * static_cast<uint32_t>(faces_.size());
  if (std::ranges::any_of(soup.triangles, RepeatsVertex)) {
    // What is left out has the last slots, which hold no half-edge.
    const auto left_out = std::stable_partition(
        faces_.begin(), faces_.end(),
        [&](uint32_t face) { return !RepeatsVertex(soup.triangles[face]); });
    half_edge_count_ = 3 * static_cast<uint32_t>(left_out - faces_.begin());
  }
  ReserveLarge(faces_.size(), triangles_);
  for (const uint32_t face : faces_) {
    slots_[face] = static_cast<uint32_t>(triangles_.size());
    triangles_.push_back(soup.triangles[face]);
  }
  BuildOutgoing(soup);
  positions_ = std::move(soup.positions);
  positions_.shrink_to_fit();
  reading_ = std::move(soup.reading);
  reading_.joined.shrink_to_fit();
}

uint32_t Mesh::JoinedInto(uint32_t v) const {
  const auto found =
      std::ranges::lower_bound(reading_.joined, v, {}, &JoinedVertex::vertex);
  return found != reading_.joined.end() && found->vertex == v ? found->into : v;
}

absl::Status Mesh::BuildFrames(std::span<const Exit> exits, ConeAngles& angles,
                               Checkpoint& checkpoint) {
  constexpr HalfEdge kAhead = 3 * 8;
  // Some 20 ms.
  constexpr HalfEdge kBetweenPolls = 3 * 50'000;
  const ScaledDifference difference(scale_exponent_);
  frames_ = MakeLargeArray<HalfEdgeFrame>(half_edge_count());
  kinds_.assign(vertex_count(), 0);
  double sum = 0;
  uint64_t edges = 0;
  for (HalfEdge first = 0; first < half_edge_count(); first += 3) {
    if (first % kBetweenPolls == 0 && first > 0) {
      absl::Status status = checkpoint.Poll({});
      if (!status.ok()) return status;
    }
    const Triangle& corners = TriangleOf(first);
    // Vertices lie in the caller's order: far apart.
    if (first + kAhead < half_edge_count()) {
      for (const uint32_t v : TriangleOf(first + kAhead)) {
        __builtin_prefetch(&positions_[v]);
        angles.Prefetch(v);
      }
    }
    const std::array<HalfEdgeFrame, 3> frames =
        LayOutFace({&positions_[corners[0]], &positions_[corners[1]],
                    &positions_[corners[2]]},
                   difference);
    std::ranges::copy(frames, &frames_[first]);
    for (int i = 0; i < 3; ++i) {
      frames_[first + i].left_exit = exits[first + (i + 2) % 3];
      frames_[first + i].right_exit = exits[first + (i + 1) % 3];
      angles.Add(corners[i], frames[i].left_x, frames[i].left_y);
      const HalfEdge h = first + i;
      const Exit exit = exits[h];
      if (exit == kNoHalfEdge) {
        kinds_[corners[i]] |= kBoundary;
        kinds_[corners[(i + 1) % 3]] |= kBoundary;
      }
      // Once an edge, with its first side. Without a branch: what comes first
      // cannot be foreseen.
      const bool is_first = exit < kIrregularExit || exit == kNoHalfEdge
                                ? h < exit
                                : IrregularEdgeAt(exit)[0] == h;
      sum += is_first ? frames[i].length : 0;
      edges += is_first;
    }
    if (!IsThinner(first, kThinFace)) continue;
    has_thin_faces_ = true;
    if (IsCollapsed(first)) {
      for (const uint32_t v : corners) kinds_[v] |= kPseudoSource;
      has_collapsed_faces_ = true;
    }
  }
  mean_edge_length_ = sum / static_cast<double>(edges);
  return absl::OkStatus();
}

void Mesh::BuildOutgoing(const TriangleSoup& soup) {
  outgoing_begin_.assign(soup.positions.size() + 1, 0);
  for (const Triangle& corners :
       std::span(triangles_).first(half_edge_count() / 3)) {
    for (const uint32_t v : corners) ++outgoing_begin_[v + 1];
  }
  std::partial_sum(outgoing_begin_.begin(), outgoing_begin_.end(),
                   outgoing_begin_.begin());
  outgoing_ = MakeLargeVector<HalfEdge>(half_edge_count());
  std::vector<uint32_t> fill(outgoing_begin_.begin(),
                             outgoing_begin_.end() - 1);
  // In order of faces, wherever these are kept.
  for (uint32_t face = 0; face < face_count(); ++face) {
    if (IsLeftOut(face)) continue;
    HalfEdge h = FirstSide(face);
    for (const uint32_t v : soup.triangles[face]) outgoing_[fill[v]++] = h++;
  }
}

bool Mesh::IsCollapsed(HalfEdge h) const {
  return IsThinner(h, kCollapsedFace);
}

bool Mesh::IsThinner(HalfEdge h, double part) const {
  const HalfEdgeFrame& side = frames_[h - h % 3];
  const double longest = LongestSide(h);
  return side.length * side.apex_y <= part * longest * longest;
}

bool Mesh::IsDisk(uint32_t v) const {
  // The two edges at v of the face that `outgoing` leaves into.
  struct Wedge {
    HalfEdge outgoing;
    bool leaves_by_previous;  // the walk goes on across Prev(outgoing)
  };
  const std::span<const HalfEdge> outgoing = Outgoing(v);
  const auto step = [&](Wedge wedge) -> std::optional<Wedge> {
    std::optional<Wedge> next;
    int faces = 0;
    ForEachBeyond(
        wedge.leaves_by_previous ? Prev(wedge.outgoing) : wedge.outgoing,
        [&](HalfEdge other, bool) {
          ++faces;
          next =
              From(other) == v ? Wedge{other, true} : Wedge{Next(other), false};
        });
    return faces == 1 ? next : std::nullopt;
  };
  // From the first face one way round, and if that ends, the other way.
  size_t wedges = 1;
  for (const bool by_previous : {true, false}) {
    std::optional<Wedge> wedge = Wedge{outgoing[0], by_previous};
    while (wedges <= outgoing.size() && (wedge = step(*wedge))) {
      if (wedge->outgoing == outgoing[0]) return wedges == outgoing.size();
      ++wedges;
    }
  }
  return wedges == outgoing.size() &&
         std::ranges::all_of(outgoing, [&](HalfEdge h) {
           return !IsNonManifoldEdge(h) && !IsNonManifoldEdge(Prev(h));
         });
}

void Mesh::ClassifyVertices(std::span<const uint8_t> is_closed_fan,
                            const ConeAngles& angles) {
  for (uint32_t v = 0; v < vertex_count(); ++v) {
    if (Outgoing(v).empty()) continue;
    if (!is_closed_fan[v] && !IsDisk(v)) {
      kinds_[v] |= kNonManifold | kPseudoSource;
    }
    // A path may bend where it has an angle of pi or more on every side that
    // lies in the surface: one side at a boundary, two elsewhere.
    const bool is_boundary = kinds_[v] & kBoundary;
    const double flat = is_boundary ? std::numbers::pi : 2 * std::numbers::pi;
    if (angles.Exceeds(v, flat + kFlatAngle)) {
      kinds_[v] |= kPseudoSource | (is_boundary ? 0 : kSaddle);
    }
  }
}

}  // namespace geodesic
