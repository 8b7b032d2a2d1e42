// A mesh of OpenMesh, whose vertices get their distances as a property.
//
//   $ open_mesh cube.off
//   vertex 6 is 2.23607 away

#include "geodesic/open_mesh.h"

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/DefaultTriMesh.hh>
#include <OpenMesh/Core/Utils/PropertyManager.hh>
#include <iostream>

#include "geodesic/solve.h"

int main(int argc, char** argv) {
  OpenMesh::TriMesh surface;
  if (argc != 2 || !OpenMesh::IO::read_mesh(surface, argv[1])) {
    return std::cerr << "usage: open_mesh MESH\n", 2;
  }

  auto mesh = geodesic::Mesh::Build(geodesic::FromOpenMesh(surface));
  if (!mesh.ok()) return std::cerr << mesh.status() << '\n', 1;
  auto field =
      geodesic::Solve(**mesh, {.sources = {{geodesic::VertexPoint{0}}}});
  if (!field.ok()) return std::cerr << field.status() << '\n', 1;

  OpenMesh::VProp<double> distance(surface, "geodesic_distance");
  OpenMesh::VertexHandle farthest(0);
  for (const auto vertex : surface.vertices()) {
    distance[vertex] = field->distances[vertex.idx()];
    if (distance[vertex] > distance[farthest]) farthest = vertex;
  }
  std::cout << "vertex " << farthest.idx() << " is " << distance[farthest]
            << " away\n";
}
