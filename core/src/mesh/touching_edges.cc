#include "mesh/touching_edges.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <set>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "surface/surface_location.h"

namespace geodesic {
namespace {

constexpr uint32_t kNone = 0xffffffffu;

Point Minus(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double Length(const Point& a) { return std::hypot(a[0], a[1], a[2]); }

// A boundary edge in the unit of the file.
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

// Whether the faces of two boundary edges are one, or lie side by side: then
// the edges are the sides of a strip.
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

// Whether `edge` lies along the longer `other`.
bool LiesAlong(const Segment& edge, const Segment& other,
               const Closeness& closeness) {
  const double reach =
      std::min(closeness.distance, closeness.part * edge.length);
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
  if (from_across > reach || to_across > reach) return false;
  const double middle = from / 2 + to / 2;
  if (!(middle > 0 && middle < other.length)) return false;
  // End to end: CloseEdges finds those.
  return std::min(from, to) > reach ||
         std::max(from, to) < other.length - reach;
}

// Segments in grids of cubes, one for each power of two among their lengths.
class SegmentGrids {
 public:
  SegmentGrids(const Mesh& mesh, std::span<const Segment> segments,
               const Closeness& closeness)
      : mesh_(mesh), segments_(segments), closeness_(closeness) {
    for (uint32_t i = 0; i < segments.size(); ++i) {
      if (segments[i].length > 0) Insert(i);
    }
  }

  // Whether the segment lies along a longer one.
  bool LiesAlongAny(const Segment& segment) const {
    Point middle;
    for (int axis = 0; axis < 3; ++axis) {
      middle[axis] = segment.from[axis] / 2 + segment.to[axis] / 2;
    }
    uint32_t most = kMostCompared;
    for (auto level = levels_.lower_bound(LevelOf(segment.length));
         level != levels_.end(); ++level) {
      const auto found = last_.find(CubeOf(middle, *level));
      if (found == last_.end()) continue;
      for (uint32_t i = found->second; i != kNone && most > 0;
           i = entries_[i].before, --most) {
        const Segment& other = segments_[entries_[i].segment];
        if (other.length >= segment.length &&
            LiesAlong(segment, other, closeness_) &&
            !AreOfOneStrip(mesh_, segment.side, other.side)) {
          return true;
        }
      }
    }
    return false;
  }

 private:
  struct Entry {
    uint32_t segment = 0;
    uint32_t before = kNone;  // in the same cube
  };
  using Cube = std::array<double, 4>;  // the last one is the level

  // Cubes of 2^level are longer than a segment and what is in its reach.
  static int LevelOf(double length) { return std::ilogb(length) + 2; }

  static Cube CubeOf(const Point& point, int level) {
    Cube cube;
    for (int axis = 0; axis < 3; ++axis) {
      cube[axis] = std::floor(std::ldexp(point[axis], -level)) + 0.0;
    }
    cube[3] = level;
    return cube;
  }

  void Insert(uint32_t number) {
    const Segment& segment = segments_[number];
    const double reach =
        std::min(closeness_.distance, closeness_.part * segment.length);
    Point least, most;
    for (int axis = 0; axis < 3; ++axis) {
      const auto [low, high] =
          std::minmax(segment.from[axis], segment.to[axis]);
      least[axis] = low - reach;
      most[axis] = high + reach;
    }
    const int level = LevelOf(segment.length);
    levels_.insert(level);
    const Cube low = CubeOf(least, level), high = CubeOf(most, level);
    // At most two along an axis.
    for (int step = 0; step < 8; ++step) {
      Cube cube = low;
      bool is_new = true;
      for (int axis = 0; axis < 3; ++axis) {
        if ((step >> axis & 1) == 0) continue;
        is_new &= high[axis] != low[axis];
        cube[axis] = high[axis];
      }
      if (!is_new) continue;
      uint32_t& last = last_.try_emplace(cube, kNone).first->second;
      entries_.push_back({number, last});
      last = static_cast<uint32_t>(entries_.size() - 1);
    }
  }

  const Mesh& mesh_;
  const std::span<const Segment> segments_;
  const Closeness closeness_;
  std::set<int> levels_;
  std::vector<Entry> entries_;
  absl::flat_hash_map<Cube, uint32_t> last_;
};

// The vertices of the mesh in the places where some vertices are.
class Places {
 public:
  Places(const Mesh& mesh, std::span<const HalfEdge> edges) : mesh_(mesh) {
    for (const HalfEdge h : edges) {
      for (const uint32_t v : {mesh.From(h), mesh.To(h)}) {
        vertices_.try_emplace(mesh.positions()[v]);
      }
    }
    // Most vertices are told apart by a bit.
    std::vector<bool> marks(std::bit_ceil(16 * vertices_.size()));
    const auto mark = [&](const Point& point) {
      return marks[Hash(point) & (marks.size() - 1)];
    };
    for (const auto& [point, unused] : vertices_) mark(point) = true;
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
      const Point& point = mesh.positions()[v];
      if (!mark(point) || mesh.Outgoing(v).empty()) continue;
      const auto found = vertices_.find(point);
      if (found != vertices_.end() && found->second.size() < kMostCompared) {
        found->second.push_back(v);
      }
    }
  }

  std::span<const uint32_t> Beside(uint32_t vertex) const {
    return vertices_.at(mesh_.positions()[vertex]);
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

  const Mesh& mesh_;
  absl::flat_hash_map<Point, std::vector<uint32_t>> vertices_;
};

}  // namespace

uint64_t CountTouchingEdges(const Mesh& mesh,
                            std::span<const HalfEdge> boundary,
                            const Closeness& closeness) {
  if (boundary.empty()) return 0;
  std::vector<Segment> segments;
  segments.reserve(boundary.size());
  for (const HalfEdge h : boundary) segments.push_back(SegmentOf(mesh, h));
  const SegmentGrids grids(mesh, segments, closeness);
  const Places places(mesh, boundary);

  const auto lies_on_inner_edge = [&](HalfEdge h) {
    for (const uint32_t from : places.Beside(mesh.From(h))) {
      for (const uint32_t to : places.Beside(mesh.To(h))) {
        if (VisitSides(mesh, from, to, [&](HalfEdge other) {
              return !mesh.IsBoundaryEdge(other);
            })) {
          return true;
        }
      }
    }
    return false;
  };
  uint64_t count = 0;
  for (size_t i = 0; i < boundary.size(); ++i) {
    count += segments[i].length > 0 && (grids.LiesAlongAny(segments[i]) ||
                                        lies_on_inner_edge(boundary[i]));
  }
  return count;
}

}  // namespace geodesic
