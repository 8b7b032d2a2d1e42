// Converts meshes to and from OpenMesh, which has subdividers, decimaters and
// smoothers.
//
//   #include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
//
//   OpenMesh::TriMesh smooth = ToOpenMesh(*mesh);
//   OpenMesh::Subdivider::Uniform::LoopT<OpenMesh::TriMesh> loop;
//   loop.attach(smooth);
//   loop(2);  // Each face becomes sixteen.
//   loop.detach();
//   absl::StatusOr<std::shared_ptr<const Mesh>> finer =
//       Mesh::Build(FromOpenMesh(smooth));

#ifndef GEODESIC_OPEN_MESH_H_
#define GEODESIC_OPEN_MESH_H_

#include <OpenMesh/Core/Mesh/DefaultTriMesh.hh>
#include <cstdint>

#include "geodesic/mesh.h"
#include "geodesic/triangle_soup.h"

namespace geodesic {

// The mesh in OpenMesh. Vertices, faces and the half-edges inside faces are
// those of `mesh`, in its order, and positions are the same doubles. Boundary
// half-edges are linked along their boundary loops. A vertex where several
// boundary loops touch lies on each of them. At irregular edges
// (Mesh::IsIrregularEdge) the surface is cut: every face gets an edge of its
// own there.
//
// O(V + F) whatever the valence: the kernel is filled directly, because
// OpenMesh's add_face searches around vertices. About 100 bytes a face.
OpenMesh::TriMesh ToOpenMesh(const Mesh& mesh);

// The positions and triangles of an OpenMesh mesh with any traits, in its
// order.
// REQUIRES: no element is marked as deleted; see garbage_collection().
// O(V + F).
template <typename Traits>
TriangleSoup FromOpenMesh(const OpenMesh::TriMesh_ArrayKernelT<Traits>& mesh) {
  TriangleSoup soup;
  soup.positions.reserve(mesh.n_vertices());
  for (const auto vertex : mesh.vertices()) {
    const auto& point = mesh.point(vertex);
    soup.positions.push_back({point[0], point[1], point[2]});
  }
  soup.triangles.reserve(mesh.n_faces());
  for (const auto face : mesh.faces()) {
    Triangle triangle;
    auto side = mesh.halfedge_handle(face);
    for (uint32_t& corner : triangle) {
      corner = static_cast<uint32_t>(mesh.from_vertex_handle(side).idx());
      side = mesh.next_halfedge_handle(side);
    }
    soup.triangles.push_back(triangle);
  }
  return soup;
}

}  // namespace geodesic

#endif  // GEODESIC_OPEN_MESH_H_
