// Matrices of Eigen in, a vector of Eigen out.
//
//   $ eigen
//   vertex 3 is 1.41421 away

#include <Eigen/Core>
#include <iostream>

#include "geodesic/mesh_arrays.h"
#include "geodesic/solve.h"

int main() {
  // A square, cut along the other diagonal.
  Eigen::MatrixXd V(4, 3);
  V << 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0;
  Eigen::MatrixXi F(2, 3);
  F << 0, 1, 2, 1, 3, 2;

  auto mesh = geodesic::BuildMesh(V, F);
  if (!mesh.ok()) return std::cerr << mesh.status() << '\n', 1;
  auto field =
      geodesic::Solve(**mesh, {.sources = {{geodesic::VertexPoint{0}}}});
  if (!field.ok()) return std::cerr << field.status() << '\n', 1;

  // The field's own memory, not a copy.
  const Eigen::Map<const Eigen::VectorXd> d(
      field->distances.data(),
      static_cast<Eigen::Index>(field->distances.size()));
  Eigen::Index farthest = 0;
  const double distance = d.maxCoeff(&farthest);
  std::cout << "vertex " << farthest << " is " << distance << " away\n";
}
