#include "mesh/touching_edges.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "polygons/pace.h"
#include "surface/surface_location.h"
#include "tolerances.h"

namespace geodesic {
namespace {

constexpr uint32_t kNone = 0xffffffffu;

// In one place, and near one edge; the rest go uncounted.
constexpr uint32_t kMostTogether = 64;
constexpr uint32_t kMostNear = 512;

// Microseconds, about, that looking for what is near an edge takes.
constexpr uint32_t kStepsAnEdge = 16;

// Edges that have no more than this part of the shorter one in common touch in
// a corner.
constexpr double kLeastCommon = 1e-2;

// Coordinates of an edge longer by more powers of two are rounded by more than
// the shorter edge.
constexpr int kMostLevels = std::numeric_limits<double>::digits;

Point Minus(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double Length(const Point& a) { return std::hypot(a[0], a[1], a[2]); }

// An edge in the unit of the file.
struct Segment {
  HalfEdge side = 0;
  Point from{};
  Point to{};
  double length = 0;  // 0 where doubles cannot hold it
};

Segment SegmentOf(const Mesh& mesh, HalfEdge h) {
  const Point& from = mesh.positions()[mesh.From(h)];
  const Point& to = mesh.positions()[mesh.To(h)];
  const double length = Length(Minus(to, from));
  return {h, from, to, std::isfinite(length) ? length : 0};
}

// Whether `edge` lies along `other`, which is no shorter, but not end to end.
bool LiesAlong(const Segment& edge, const Segment& other) {
  const double reach = kTouching * edge.length;
  // Along the other's line, and across it.
  const auto place = [&](const Point& point) -> std::array<double, 2> {
    const Point way = Minus(point, other.from);
    double along = 0;
    for (int axis = 0; axis < 3; ++axis) {
      along += way[axis] * ((other.to[axis] - other.from[axis]) / other.length);
    }
    Point across;
    for (int axis = 0; axis < 3; ++axis) {
      across[axis] = way[axis] - (other.to[axis] - other.from[axis]) *
                                     (along / other.length);
    }
    return {along, Length(across)};
  };
  const auto [from, from_across] = place(edge.from);
  const auto [to, to_across] = place(edge.to);
  if (!(from_across <= reach && to_across <= reach)) return false;
  const double common = std::min(std::max(from, to), other.length) -
                        std::max(std::min(from, to), 0.0);
  return common > kLeastCommon * edge.length &&
         (std::min(from, to) > reach ||
          std::max(from, to) < other.length - reach);
}

// Whether the faces of two boundary edges are one, or lie side by side: the
// edges are then the sides of a strip.
bool AreOfOneStrip(const Mesh& mesh, HalfEdge a, HalfEdge b) {
  bool is_one = mesh.FaceOf(a) == mesh.FaceOf(b);
  for (const HalfEdge h : {Next(a), Prev(a)}) {
    if (mesh.IsBoundaryEdge(h)) continue;
    mesh.ForEachBeyond(h, [&](HalfEdge beyond, bool) {
      is_one = is_one || mesh.FaceOf(beyond) == mesh.FaceOf(b);
    });
  }
  return is_one;
}

// Segments in grids, one for each power of two among their lengths.
class SegmentGrids {
 public:
  explicit SegmentGrids(std::span<const Segment> segments)
      : segments_(segments) {}

  // Call once.
  absl::Status Fill(Pace& pace) {
    for (uint32_t i = 0; i < segments_.size(); ++i) {
      if (!pace.Goes()) return pace.status();
      if (segments_[i].length > 0) Insert(i);
    }
    return absl::OkStatus();
  }

  // Calls visit(number) for segments near this one, among them all that it lies
  // along.
  template <typename Visit>
  void VisitNear(const Segment& segment, Visit visit) const {
    const int own = LevelOf(segment.length);
    uint32_t most = kMostNear;
    for (auto level = levels_.lower_bound(own);
         level != levels_.end() && *level <= own + kMostLevels; ++level) {
      VisitCubes(segment, *level, [&](const Cube& cube) {
        const auto found = last_.find(cube);
        if (found == last_.end()) return;
        uint32_t most_here = kMostTogether;
        for (uint32_t i = found->second;
             i != kNone && most_here > 0 && most > 0;
             i = entries_[i].before, --most_here, --most) {
          visit(entries_[i].segment);
        }
      });
    }
  }

 private:
  struct Entry {
    uint32_t segment = 0;
    uint32_t before = kNone;  // in the same cube
  };
  using Cube = std::array<double, 4>;  // the last one is the level

  // Cubes of 2^level are longer than a segment and what is in its reach.
  static int LevelOf(double length) { return std::ilogb(length) + 2; }

  // Calls visit(cube) for the cubes of a level, none smaller than its own, that
  // the box around a segment meets: at most two along an axis.
  template <typename Visit>
  static void VisitCubes(const Segment& segment, int level, Visit visit) {
    const double reach = kTouching * segment.length;
    Cube low, high;
    for (int axis = 0; axis < 3; ++axis) {
      const auto [least, most] =
          std::minmax(segment.from[axis], segment.to[axis]);
      low[axis] = std::floor(std::ldexp(least - reach, -level)) + 0.0;
      high[axis] = std::floor(std::ldexp(most + reach, -level)) + 0.0;
    }
    low[3] = level;
    for (int step = 0; step < 8; ++step) {
      Cube cube = low;
      bool is_new = true;
      for (int axis = 0; axis < 3; ++axis) {
        if ((step >> axis & 1) == 0) continue;
        is_new &= high[axis] != low[axis];
        cube[axis] = high[axis];
      }
      if (is_new) visit(cube);
    }
  }

  void Insert(uint32_t number) {
    const int level = LevelOf(segments_[number].length);
    levels_.insert(level);
    VisitCubes(segments_[number], level, [&](const Cube& cube) {
      uint32_t& last = last_.try_emplace(cube, kNone).first->second;
      entries_.push_back({number, last});
      last = static_cast<uint32_t>(entries_.size() - 1);
    });
  }

  const std::span<const Segment> segments_;
  std::set<int> levels_;
  std::vector<Entry> entries_;
  absl::flat_hash_map<Cube, uint32_t> last_;
};

// The vertices of the mesh in the places where the ends of some edges are.
class Places {
 public:
  explicit Places(const Mesh& mesh) : mesh_(mesh) {}

  // Call once.
  absl::Status Fill(std::span<const HalfEdge> edges, Pace& pace) {
    for (uint32_t i = 0; i < edges.size(); ++i) {
      if (!pace.Goes()) return pace.status();
      for (const uint32_t v : {mesh_.From(edges[i]), mesh_.To(edges[i])}) {
        vertices_.try_emplace(mesh_.positions()[v]);
      }
    }
    // Most vertices are told apart by a bit.
    std::vector<bool> marks(std::bit_ceil(16 * vertices_.size()));
    const auto mark = [&](const Point& point) {
      return marks[Hash(point) & (marks.size() - 1)];
    };
    for (const auto& [point, unused] : vertices_) mark(point) = true;
    for (uint32_t v = 0; v < mesh_.vertex_count(); ++v) {
      if (!pace.Goes()) return pace.status();
      const Point& point = mesh_.positions()[v];
      if (!mark(point) || mesh_.Outgoing(v).empty()) continue;
      const auto found = vertices_.find(point);
      if (found != vertices_.end() && found->second.size() < kMostTogether) {
        found->second.push_back(v);
      }
    }
    return absl::OkStatus();
  }

  // Whether an edge between the places of the ends of this one is no boundary.
  bool HasInnerEdge(HalfEdge h) const {
    for (const uint32_t from : Beside(mesh_.From(h))) {
      for (const uint32_t to : Beside(mesh_.To(h))) {
        if (VisitSides(mesh_, from, to, [&](HalfEdge side) {
              return !mesh_.IsBoundaryEdge(side);
            })) {
          return true;
        }
      }
    }
    return false;
  }

 private:
  static uint64_t Hash(const Point& point) {
    uint64_t hash = 0;
    for (const double x : point) {
      hash = (hash ^ std::bit_cast<uint64_t>(x + 0.0)) * 0x9e3779b97f4a7c15;
      hash ^= hash >> 32;
    }
    return hash;
  }

  std::span<const uint32_t> Beside(uint32_t vertex) const {
    return vertices_.at(mesh_.positions()[vertex]);
  }

  const Mesh& mesh_;
  absl::flat_hash_map<Point, std::vector<uint32_t>> vertices_;
};

}  // namespace

absl::StatusOr<uint64_t> CountTouchingEdges(const Mesh& mesh,
                                            std::span<const HalfEdge> boundary,
                                            Checkpoint& checkpoint) {
  if (boundary.empty()) return 0;
  std::vector<Segment> segments;
  segments.reserve(boundary.size());
  for (const HalfEdge h : boundary) segments.push_back(SegmentOf(mesh, h));
  Pace pace(&checkpoint);
  SegmentGrids grids(segments);
  absl::Status status = grids.Fill(pace);
  if (!status.ok()) return status;
  Places places(mesh);
  status = places.Fill(boundary, pace);
  if (!status.ok()) return status;
  std::vector<bool> is_touching(segments.size());
  for (uint32_t i = 0; i < segments.size(); ++i) {
    if (!pace.Goes(kStepsAnEdge)) return pace.status();
    if (!(segments[i].length > 0)) continue;
    if (places.HasInnerEdge(boundary[i])) is_touching[i] = true;
    grids.VisitNear(segments[i], [&](uint32_t other) {
      if ((is_touching[i] && is_touching[other]) ||
          segments[other].length < segments[i].length ||
          !LiesAlong(segments[i], segments[other]) ||
          AreOfOneStrip(mesh, boundary[i], boundary[other])) {
        return;
      }
      is_touching[i] = is_touching[other] = true;
    });
  }
  return static_cast<uint64_t>(
      std::count(is_touching.begin(), is_touching.end(), true));
}

}  // namespace geodesic
