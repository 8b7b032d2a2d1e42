#include "geodesic/open_mesh.h"

#include <vector>

namespace geodesic {
namespace {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::TriMesh;
using OpenMesh::VertexHandle;

// Links each boundary half-edge to the next along its loop: around the vertex
// it ends in, through the faces of one fan, to that fan's other boundary.
void LinkBoundary(TriMesh& kernel) {
  for (unsigned i = 0; i < kernel.n_halfedges(); ++i) {
    const HalfedgeHandle boundary(i);
    if (!kernel.is_boundary(boundary)) continue;
    HalfedgeHandle out = kernel.opposite_halfedge_handle(boundary);
    while (!kernel.is_boundary(out)) {
      // Within a triangle the previous half-edge is the next of the next; its
      // own link may not be set on a boundary.
      const HalfedgeHandle into =
          kernel.next_halfedge_handle(kernel.next_halfedge_handle(out));
      out = kernel.opposite_halfedge_handle(into);
    }
    kernel.set_next_halfedge_handle(boundary, out);
    kernel.set_halfedge_handle(kernel.from_vertex_handle(out), out);
  }
}

}  // namespace

TriMesh ToOpenMesh(const Mesh& mesh) {
  TriMesh kernel;
  kernel.reserve(mesh.vertex_count(), 3 * mesh.face_count() / 2 + 1,
                 mesh.face_count());
  for (const Point& point : mesh.positions()) {
    kernel.new_vertex({point[0], point[1], point[2]});
  }

  std::vector<HalfedgeHandle> handles(mesh.half_edge_count());
  for (HalfEdge h = 0; h < mesh.half_edge_count(); ++h) {
    const HalfEdge twin = mesh.Twin(h);
    if (twin != kNoHalfEdge && twin < h) {
      handles[h] = kernel.opposite_halfedge_handle(handles[twin]);
    } else {
      handles[h] =
          kernel.new_edge(VertexHandle(mesh.From(h)), VertexHandle(mesh.To(h)));
    }
  }
  for (uint32_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.IsLeftOut(f)) continue;
    const FaceHandle face = kernel.new_face();
    const HalfEdge first = mesh.FirstSide(f);
    kernel.set_halfedge_handle(face, handles[first]);
    for (HalfEdge h = first; h < first + 3; ++h) {
      kernel.set_face_handle(handles[h], face);
      kernel.set_next_halfedge_handle(handles[h], handles[Next(h)]);
      kernel.set_halfedge_handle(VertexHandle(mesh.From(h)), handles[h]);
    }
  }
  LinkBoundary(kernel);
  return kernel;
}

}  // namespace geodesic
