#include "geodesic/mesh_summary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "geodesic/open_mesh.h"
#include "tolerances.h"

namespace geodesic {
namespace {

using OpenMesh::HalfedgeHandle;
using OpenMesh::TriConnectivity;

uint64_t CountBoundaryLoops(const TriConnectivity& kernel) {
  uint64_t loops = 0;
  std::vector<bool> seen(kernel.n_halfedges(), false);
  for (const auto start : kernel.halfedges()) {
    if (!kernel.is_boundary(start) || seen[start.idx()]) continue;
    ++loops;
    for (HalfedgeHandle h = start; !seen[h.idx()];
         h = kernel.next_halfedge_handle(h)) {
      seen[h.idx()] = true;
    }
  }
  return loops;
}

// Fans of faces around vertices: one for an ordinary vertex, more where parts
// of the surface touch in a point.
uint64_t CountFans(const Mesh& mesh) {
  uint64_t fans = 0;
  std::vector<bool> seen(mesh.half_edge_count(), false);
  const auto walk = [&](HalfEdge start) {
    ++fans;
    for (HalfEdge h = start; h != kNoHalfEdge && !seen[h];
         h = mesh.Twin(Prev(h))) {
      seen[h] = true;
    }
  };
  // An open fan starts at a boundary; what it does not reach is closed.
  for (HalfEdge h = 0; h < mesh.half_edge_count(); ++h) {
    if (mesh.Twin(h) == kNoHalfEdge) walk(h);
  }
  for (HalfEdge h = 0; h < mesh.half_edge_count(); ++h) {
    if (!seen[h]) walk(h);
  }
  return fans;
}

// Faces in disjoint sets (union by halving paths).
class FaceSets {
 public:
  explicit FaceSets(uint32_t faces) : parent_(faces), count_(faces) {
    std::iota(parent_.begin(), parent_.end(), 0u);
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
  uint32_t Find(uint32_t f) {
    while (parent_[f] != f) f = parent_[f] = parent_[parent_[f]];
    return f;
  }

  std::vector<uint32_t> parent_;
  uint64_t count_;
};

struct Pieces {
  uint64_t through_edges = 0;     // a shared vertex alone does not connect
  uint64_t through_vertices = 0;  // it does
};

Pieces CountPieces(const Mesh& mesh) {
  FaceSets sets(mesh.face_count());
  for (HalfEdge h = 0; h < mesh.half_edge_count(); ++h) {
    if (mesh.Twin(h) != kNoHalfEdge) sets.Join(h / 3, mesh.Twin(h) / 3);
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

  const TriConnectivity kernel = ToOpenMesh(mesh);
  summary.edges = kernel.n_edges();
  for (const auto edge : kernel.edges()) {
    summary.boundary_edges += kernel.is_boundary(edge);
  }
  summary.boundary_loops = CountBoundaryLoops(kernel);
  const Pieces pieces = CountPieces(mesh);
  summary.components = pieces.through_vertices;
  // Euler's formula for the surface with touching fans pulled apart.
  summary.genus = (2 * static_cast<int64_t>(pieces.through_edges) -
                   static_cast<int64_t>(summary.boundary_loops +
                                        CountFans(mesh) + summary.faces) +
                   static_cast<int64_t>(summary.edges)) /
                  2;

  summary.bounding_box_min.fill(std::numeric_limits<double>::infinity());
  summary.bounding_box_max.fill(-std::numeric_limits<double>::infinity());
  for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    summary.isolated_vertices += mesh.Outgoing(v).empty();
    summary.saddle_vertices += mesh.IsSaddle(v);
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
