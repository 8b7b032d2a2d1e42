#include "tests/support/oracles/cgal_oracle.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <limits>

namespace geodesic::test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, SurfaceMesh>;
using ShortestPath = CGAL::Surface_mesh_shortest_path<Traits>;
using Vertex = SurfaceMesh::Vertex_index;

double DistanceTo(Vertex v, ShortestPath& shortest_path,
                  const SurfaceMesh& mesh) {
  const double distance =
      mesh.is_isolated(v)
          ? -1
          : shortest_path.shortest_distance_to_source_points(v).first;
  // CGAL says -1 where no source can be reached.
  return distance < 0 ? std::numeric_limits<double>::infinity() : distance;
}

}  // namespace

struct CgalOracle::Model {
  SurfaceMesh mesh;
};

CgalOracle::CgalOracle(const TriangleSoup& soup)
    : model_([&] {
        auto model = std::make_unique<Model>();
        for (const Point& p : soup.positions) {
          model->mesh.add_vertex({p[0], p[1], p[2]});
        }
        for (const Triangle& t : soup.triangles) {
          model->mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
        }
        return model;
      }()) {}

CgalOracle::~CgalOracle() = default;

std::vector<double> CgalOracle::Distances(uint32_t source) const {
  const SurfaceMesh& mesh = model_->mesh;
  ShortestPath shortest_path(mesh);
  shortest_path.add_source_point(Vertex(source));
  std::vector<double> distances;
  for (const Vertex v : mesh.vertices()) {
    distances.push_back(DistanceTo(v, shortest_path, mesh));
  }
  return distances;
}

double CgalOracle::Distance(uint32_t source, uint32_t target) const {
  ShortestPath shortest_path(model_->mesh);
  shortest_path.add_source_point(Vertex(source));
  return DistanceTo(Vertex(target), shortest_path, model_->mesh);
}

}  // namespace geodesic::test
