#include "geodesic/mesh_summary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "tolerances.h"

namespace geodesic {
namespace {

// Numbers in disjoint sets (union by halving paths).
class DisjointSets {
 public:
  explicit DisjointSets(uint32_t size) : parent_(size), count_(size) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  uint32_t Find(uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void Join(uint32_t a, uint32_t b) {
    a = Find(a);
    b = Find(b);
    if (a == b) return;
    parent_[std::max(a, b)] = std::min(a, b);
    --count_;
  }

  uint64_t count() const { return count_; }

 private:
  std::vector<uint32_t> parent_;
  uint64_t count_;
};

void CountEdges(const Mesh& mesh, MeshSummary& summary) {
  for (HalfEdge h = 0; h < mesh.half_edge_count(); ++h) {
    if (mesh.FirstOfEdge(h) != h) continue;
    ++summary.edges;
    summary.boundary_edges += mesh.IsBoundaryEdge(h);
    if (mesh.IsCrowdedEdge(h)) {
      ++summary.non_manifold_edges;
    } else {
      summary.inconsistent_edges += mesh.IsIrregularEdge(h);
    }
  }
}

// Whether faces can be turned over so that all agree. O(F).
bool IsOrientable(const Mesh& mesh) {
  if (!mesh.HasIrregularEdges()) return true;
  enum : uint8_t { kUnseen, kAsIs, kTurned };
  std::vector<uint8_t> sides(mesh.face_count(), kUnseen);
  std::vector<uint32_t> stack;
  bool is_orientable = true;
  for (uint32_t start = 0; start < mesh.face_count(); ++start) {
    if (sides[start] != kUnseen) continue;
    sides[start] = kAsIs;
    stack.push_back(start);
    while (!stack.empty() && is_orientable) {
      const uint32_t face = stack.back();
      stack.pop_back();
      for (HalfEdge h = 3 * face; h < 3 * face + 3; ++h) {
        if (mesh.IsCrowdedEdge(h)) continue;
        mesh.ForEachBeyond(h, [&](HalfEdge other, bool is_mirrored) {
          const uint8_t side =
              is_mirrored ? kAsIs + kTurned - sides[face] : sides[face];
          uint8_t& there = sides[other / 3];
          if (there == kUnseen) {
            there = side;
            stack.push_back(other / 3);
          }
          is_orientable = is_orientable && there == side;
        });
      }
    }
  }
  return is_orientable;
}

// Fans of faces around vertices: one for an ordinary vertex, more where parts
// of the surface touch in a point. Numbers are those of outgoing half-edges,
// one a face and corner.
DisjointSets FindFans(const Mesh& mesh) {
  DisjointSets fans(mesh.half_edge_count());
  for (HalfEdge h = 0; h < mesh.half_edge_count(); ++h) {
    if (mesh.IsCrowdedEdge(h)) continue;
    mesh.ForEachBeyond(h, [&](HalfEdge other, bool is_mirrored) {
      fans.Join(h, is_mirrored ? other : Next(other));
      fans.Join(Next(h), is_mirrored ? Next(other) : other);
    });
  }
  return fans;
}

// Boundary edges follow each other where they bound the same fan.
uint64_t CountBoundaryLoops(const Mesh& mesh, DisjointSets& fans) {
  DisjointSets loops(mesh.half_edge_count());
  std::vector<uint32_t> edges;
  for (HalfEdge h = 0; h < mesh.half_edge_count(); ++h) {
    if (!mesh.IsBoundaryEdge(h)) continue;
    edges.push_back(fans.Find(h));
    loops.Join(fans.Find(h), fans.Find(Next(h)));
  }
  for (uint32_t& edge : edges) edge = loops.Find(edge);
  std::ranges::sort(edges);
  return std::unique(edges.begin(), edges.end()) - edges.begin();
}

struct Pieces {
  uint64_t through_edges = 0;     // a shared vertex alone does not connect
  uint64_t through_vertices = 0;  // it does
};

Pieces CountPieces(const Mesh& mesh) {
  DisjointSets sets(mesh.face_count());
  for (HalfEdge h = 0; h < mesh.half_edge_count(); ++h) {
    sets.Join(h / 3, mesh.FirstOfEdge(h) / 3);
  }
  Pieces pieces{.through_edges = sets.count()};
  for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    const std::span<const HalfEdge> outgoing = mesh.Outgoing(v);
    for (HalfEdge h : outgoing) sets.Join(h / 3, outgoing[0] / 3);
  }
  pieces.through_vertices = sets.count();
  return pieces;
}

struct Shape {
  double mean_edge_length = 0;
  double anisotropy = 0;
  uint64_t degenerate_faces = 0;
};

Shape MeasureShape(const Mesh& mesh) {
  Shape shape;
  double sum = 0;
  for (uint32_t f = 0; f < mesh.face_count(); ++f) {
    const HalfEdgeFrame& frame = mesh.frame(3 * f);
    const double a = frame.length, b = mesh.frame(3 * f + 1).length,
                 c = mesh.frame(3 * f + 2).length;
    const double area = frame.length * frame.apex_y / 2;
    const double longest = std::max({a, b, c});
    if (area <= kLeastHeight * longest) {
      ++shape.degenerate_faces;
      continue;
    }
    sum += (a + b + c) / 2 * longest / (2 * std::sqrt(3.0) * area);
  }
  const uint64_t with_area = mesh.face_count() - shape.degenerate_faces;
  if (with_area > 0) shape.anisotropy = sum / static_cast<double>(with_area);
  shape.mean_edge_length =
      std::ldexp(mesh.mean_edge_length(), mesh.scale_exponent());
  return shape;
}

}  // namespace

MeshSummary Summarize(const Mesh& mesh) {
  MeshSummary summary;
  summary.vertices = mesh.vertex_count();
  summary.faces = mesh.face_count();

  CountEdges(mesh, summary);
  summary.is_orientable = IsOrientable(mesh);
  DisjointSets fans = FindFans(mesh);
  summary.boundary_loops = CountBoundaryLoops(mesh, fans);
  const Pieces pieces = CountPieces(mesh);
  summary.components = pieces.through_vertices;
  if (summary.is_orientable && summary.non_manifold_edges == 0) {
    // Euler's formula for the surface with touching fans pulled apart.
    summary.genus = (2 * static_cast<int64_t>(pieces.through_edges) -
                     static_cast<int64_t>(summary.boundary_loops +
                                          fans.count() + summary.faces) +
                     static_cast<int64_t>(summary.edges)) /
                    2;
  }

  summary.bounding_box_min.fill(std::numeric_limits<double>::infinity());
  summary.bounding_box_max.fill(-std::numeric_limits<double>::infinity());
  for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    summary.isolated_vertices += mesh.Outgoing(v).empty();
    summary.saddle_vertices += mesh.IsSaddle(v);
    summary.non_manifold_vertices += mesh.IsNonManifold(v);
    for (int axis = 0; axis < 3; ++axis) {
      const double x = mesh.positions()[v][axis];
      summary.bounding_box_min[axis] =
          std::min(summary.bounding_box_min[axis], x);
      summary.bounding_box_max[axis] =
          std::max(summary.bounding_box_max[axis], x);
    }
  }
  const Shape shape = MeasureShape(mesh);
  summary.mean_edge_length = shape.mean_edge_length;
  summary.anisotropy = shape.anisotropy;
  summary.degenerate_faces = shape.degenerate_faces;
  return summary;
}

}  // namespace geodesic
