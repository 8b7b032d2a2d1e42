// The distances of a mesh file from its first vertex, and the farthest of them.
//
//   $ distances cube.off
//   vertex 6 is 2.23607 away

#include <algorithm>
#include <iostream>

#include "geodesic/mesh_file.h"
#include "geodesic/solve.h"

int main(int argc, char** argv) {
  if (argc != 2) return std::cerr << "usage: distances MESH\n", 2;

  auto mesh = geodesic::ReadMeshFile(argv[1]);
  if (!mesh.ok()) return std::cerr << mesh.status() << '\n', 1;
  auto field =
      geodesic::Solve(**mesh, {.sources = {{geodesic::VertexPoint{0}}}});
  if (!field.ok()) return std::cerr << field.status() << '\n', 1;

  const auto farthest = std::ranges::max_element(field->distances);
  std::cout << "vertex " << farthest - field->distances.begin() << " is "
            << *farthest << " away\n";
}
