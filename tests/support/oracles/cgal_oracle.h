// Oracle: geodesic distances by CGAL's Surface_mesh_shortest_path (Kiazyk,
// Loriot, de Verdiere), a program of others, in its recommended kernel of
// exact predicates and inexact constructions.

#ifndef GEODESIC_TESTS_SUPPORT_ORACLES_CGAL_ORACLE_H_
#define GEODESIC_TESTS_SUPPORT_ORACLES_CGAL_ORACLE_H_

#include <cstdint>
#include <memory>
#include <vector>

#include "geodesic/triangle_soup.h"

namespace geodesic::test {

class CgalOracle {
 public:
  // REQUIRES: an edge-manifold soup whose faces agree in orientation.
  explicit CgalOracle(const TriangleSoup& soup);
  ~CgalOracle();

  // One distance per vertex, +infinity where no path leads or no face is.
  std::vector<double> Distances(uint32_t source) const;
  // One alone, which spares asking for the others.
  double Distance(uint32_t source, uint32_t target) const;

 private:
  struct Model;
  const std::unique_ptr<const Model> model_;
};

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_ORACLES_CGAL_ORACLE_H_
