#include "approximate/intrinsic_triangulation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "surface/plane_point.h"
#include "tolerances.h"

namespace geodesic {
namespace {

// Between two polls, in edges: well below a millisecond.
constexpr uint32_t kPollPeriod = 4096;

// Turning ends by itself but for rounding; what is not Delaunay then is a
// triangulation still. Real meshes take less than one turn an edge.
constexpr uint64_t kMostFlipsPerEdge = 100;

// The corner opposite to an edge from (0, 0) to (length, 0), by the lengths of
// the sides from either end.
PlanePoint ApexOver(double length, double from_begin, double from_end) {
  const double x =
      (length + (from_begin - from_end) * (from_begin + from_end) / length) / 2;
  // Kahan's area by sorted sides loses nothing on needles.
  double a = length, b = from_begin, c = from_end;
  if (a < b) std::swap(a, b);
  if (b < c) std::swap(b, c);
  if (a < b) std::swap(a, b);
  const double square =
      (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
  return {x, std::sqrt(std::max(square, 0.0)) / (2 * length)};
}

}  // namespace

IntrinsicTriangulation::IntrinsicTriangulation(const Mesh& mesh) {
  if (mesh.HasIrregularEdges()) {
    AddTuftedCover(mesh);
  } else {
    AddFaces(mesh);
  }
  Mollify(mesh.mean_edge_length() > 0 ? mesh.mean_edge_length() : 1);
}

void IntrinsicTriangulation::AddFaces(const Mesh& mesh) {
  corners_.reserve(mesh.half_edge_count());
  twins_.reserve(mesh.half_edge_count());
  lengths_.reserve(mesh.half_edge_count());
  for (HalfEdge h = 0; h < mesh.half_edge_count(); ++h) {
    corners_.push_back(mesh.From(h));
    twins_.push_back(mesh.Twin(h));
    lengths_.push_back(mesh.frame(h).length);
  }
}

// The front of a face is numbered as in the mesh. Its back comes after all
// fronts, with its corners in the order 0, 2, 1: the back of side 0 is the
// back's last, that of side 2 its first.
void IntrinsicTriangulation::AddTuftedCover(const Mesh& mesh) {
  sheets_ = 2;
  const uint32_t count = mesh.half_edge_count();
  const auto back = [count](HalfEdge h) {
    return count + h - h % 3 + 2 - h % 3;
  };
  corners_.resize(2 * count);
  twins_.assign(2 * count, kNoHalfEdge);
  lengths_.resize(2 * count);
  for (HalfEdge h = 0; h < count; ++h) {
    corners_[h] = mesh.From(h);
    corners_[back(h)] = mesh.To(h);
    lengths_[h] = lengths_[back(h)] = mesh.frame(h).length;
  }
  std::vector<HalfEdge> around;
  for (HalfEdge h = 0; h < count; ++h) {
    if (mesh.FirstOfEdge(h) != h) continue;
    around.assign(1, h);
    mesh.ForEachBeyond(h,
                       [&](HalfEdge other, bool) { around.push_back(other); });
    // The side of each face that runs as h does, against the side of the next
    // face that runs the other way.
    for (size_t i = 0; i < around.size(); ++i) {
      const HalfEdge next = around[(i + 1) % around.size()];
      const bool runs_along = mesh.From(around[i]) == mesh.From(h);
      const bool next_runs_along = mesh.From(next) == mesh.From(h);
      const HalfEdge along = runs_along ? around[i] : back(around[i]);
      const HalfEdge against = next_runs_along ? back(next) : next;
      twins_[along] = against;
      twins_[against] = along;
    }
  }
}

void IntrinsicTriangulation::Mollify(double mean_length) {
  double more = 0;
  for (HalfEdge h = 0; h < lengths_.size(); ++h) {
    const double excess = lengths_[Next(h)] + lengths_[Prev(h)] - lengths_[h];
    more = std::max(more, kMollified * mean_length - excess);
  }
  if (more == 0) return;
  for (double& length : lengths_) length += more;
}

double IntrinsicTriangulation::Cotangent(HalfEdge h) const {
  const double left = lengths_[Prev(h)], right = lengths_[Next(h)];
  const PlanePoint apex = ApexOver(lengths_[h], left, right);
  return (left * left + right * right - lengths_[h] * lengths_[h]) /
         (2 * lengths_[h] * apex.y);
}

bool IntrinsicTriangulation::IsToTurn(HalfEdge h) const {
  const HalfEdge twin = twins_[h];
  return twin != kNoHalfEdge && twin / 3 != h / 3 &&
         Cotangent(h) + Cotangent(twin) < -kNotDelaunay;
}

// h runs from A to B, C is left of it and D right. Faces ABC and BAD become ADC
// and BCD.
void IntrinsicTriangulation::Turn(HalfEdge h) {
  const HalfEdge twin = twins_[h];
  const PlanePoint c =
      ApexOver(lengths_[h], lengths_[Prev(h)], lengths_[Next(h)]);
  const PlanePoint d =
      ApexOver(lengths_[h], lengths_[Next(twin)], lengths_[Prev(twin)]);
  const double turned = std::hypot(d.x - c.x, d.y + c.y);
  const HalfEdge first = h - h % 3, second = twin - twin % 3;

  struct Side {
    HalfEdge before, after;
    uint32_t from = 0;
    double length = 0;
    HalfEdge twin = kNoHalfEdge;
  };
  std::array<Side, 4> sides = {{{Next(twin), first},
                                {Prev(h), first + 2},
                                {Next(h), second},
                                {Prev(twin), second + 2}}};
  for (Side& side : sides) {
    side.from = corners_[side.before];
    side.length = lengths_[side.before];
    side.twin = twins_[side.before];
  }
  for (Side& side : sides) {
    for (const Side& other : sides) {
      if (side.twin == other.before) {
        side.twin = other.after;
        break;
      }
    }
  }
  for (const Side& side : sides) {
    corners_[side.after] = side.from;
    lengths_[side.after] = side.length;
    twins_[side.after] = side.twin;
    if (side.twin != kNoHalfEdge) twins_[side.twin] = side.after;
  }
  const HalfEdge down = first + 1, up = second + 1;  // D -> C and C -> D
  corners_[down] = sides[3].from;
  corners_[up] = sides[1].from;
  lengths_[down] = lengths_[up] = turned;
  twins_[down] = up;
  twins_[up] = down;
  ++flips_;
}

absl::Status IntrinsicTriangulation::FlipToDelaunay(const Mesh& mesh,
                                                    Checkpoint& checkpoint) {
  // Half-edges whose edge may have to be turned; numbers stay with their face.
  std::vector<HalfEdge> waiting;
  for (HalfEdge h = 0; h < corners_.size(); ++h) {
    if (twins_[h] != kNoHalfEdge && h < twins_[h]) waiting.push_back(h);
  }
  const uint64_t most_flips = kMostFlipsPerEdge * waiting.size();
  std::reverse(waiting.begin(), waiting.end());
  uint64_t steps = 0;
  while (!waiting.empty() && flips_ < most_flips) {
    if (steps++ % kPollPeriod == 0) {
      if (absl::Status status = checkpoint.Poll(
              {.vertices = mesh.vertex_count(), .solver_bytes = bytes()});
          !status.ok()) {
        return status;
      }
    }
    const HalfEdge h = waiting.back();
    waiting.pop_back();
    if (!IsToTurn(h)) continue;
    const HalfEdge first = h - h % 3, second = twins_[h] - twins_[h] % 3;
    Turn(h);
    for (const HalfEdge side : {first, first + 2, second, second + 2}) {
      waiting.push_back(side);
    }
  }
  return absl::OkStatus();
}

IntrinsicTriangulation::Face IntrinsicTriangulation::FaceAt(
    uint32_t face) const {
  const HalfEdge h = 3 * face;
  const PlanePoint apex =
      ApexOver(lengths_[h], lengths_[Prev(h)], lengths_[Next(h)]);
  return {.corners = {corners_[h], corners_[h + 1], corners_[h + 2]},
          .length = lengths_[h],
          .x = apex.x,
          .y = apex.y};
}

}  // namespace geodesic
