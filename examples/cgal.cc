// A CGAL::Surface_mesh, whose vertices get their distances as a property map.
//
//   $ cgal cube.off
//   vertex 6 is 2.23607 away

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>
#include <vector>

#include "geodesic/mesh_arrays.h"
#include "geodesic/solve.h"

using Surface = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char** argv) {
  Surface surface;
  if (argc != 2 || !CGAL::IO::read_polygon_mesh(argv[1], surface) ||
      !CGAL::is_triangle_mesh(surface)) {
    return std::cerr << "usage: cgal MESH-OF-TRIANGLES\n", 2;
  }
  // Numbers then run from 0 without gaps.
  surface.collect_garbage();

  std::vector<double> coordinates;
  for (const auto vertex : surface.vertices()) {
    for (int i = 0; i < 3; ++i) {
      coordinates.push_back(surface.point(vertex)[i]);
    }
  }
  std::vector<uint32_t> corners;
  for (const auto face : surface.faces()) {
    for (const auto vertex :
         CGAL::vertices_around_face(surface.halfedge(face), surface)) {
      corners.push_back(vertex.idx());
    }
  }

  auto mesh = geodesic::BuildMesh(coordinates, corners);
  if (!mesh.ok()) return std::cerr << mesh.status() << '\n', 1;
  auto field =
      geodesic::Solve(**mesh, {.sources = {{geodesic::VertexPoint{0}}}});
  if (!field.ok()) return std::cerr << field.status() << '\n', 1;

  auto distance = surface
                      .add_property_map<Surface::Vertex_index, double>(
                          "v:geodesic_distance")
                      .first;
  Surface::Vertex_index farthest(0);
  for (const auto vertex : surface.vertices()) {
    distance[vertex] = field->distances[vertex.idx()];
    if (distance[vertex] > distance[farthest]) farthest = vertex;
  }
  std::cout << "vertex " << farthest.idx() << " is " << distance[farthest]
            << " away\n";
}
