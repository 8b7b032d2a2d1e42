// A mesh as an OpenMesh kernel, for tools that walk or edit connectivity.

#ifndef GEODESIC_OPEN_MESH_H_
#define GEODESIC_OPEN_MESH_H_

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>

#include "geodesic/mesh.h"

namespace geodesic {

// The mesh's connectivity in OpenMesh: vertex v, face f and the half-edges
// inside faces are those of `mesh`, in its order; boundary half-edges are
// linked along their boundary loops. A vertex where several boundary loops
// touch lies on each of them. At irregular edges (Mesh::IsIrregularEdge) the
// surface is cut: every face gets an edge of its own there.
//
// O(V + F) whatever the valence: the kernel is filled directly, because
// OpenMesh's add_face searches around vertices. About 76 bytes a face.
OpenMesh::TriConnectivity ToOpenMesh(const Mesh& mesh);

}  // namespace geodesic

#endif  // GEODESIC_OPEN_MESH_H_
