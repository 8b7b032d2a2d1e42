// Questions for the tests of computations that stop and go on: meshes with
// ties, curvature, needles and boundaries, sources of every kind.

#ifndef GEODESIC_TESTS_CORE_SOLVER_COMPUTATION_SCENES_H_
#define GEODESIC_TESTS_CORE_SOLVER_COMPUTATION_SCENES_H_

#include <memory>
#include <string>
#include <vector>

#include "geodesic/computation.h"
#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "geodesic/query.h"

namespace geodesic::test {

struct ComputationScene {
  std::string name;
  std::shared_ptr<const Mesh> mesh;
  Query query;  // with targets; the algorithm is to be set
};

// Some hundred faces each.
std::vector<ComputationScene> ComputationScenes();

// StartComputation; fails the test and returns null if it is refused.
std::unique_ptr<Computation> StartOrFail(const Mesh& mesh, const Query& query);

// The whole field, computed at once.
DistanceField WholeField(const Mesh& mesh, const Query& query);

// Distances of the vertices, then of the targets.
std::vector<double> AllDistances(const DistanceField& field);

// The largest finite distance.
double Farthest(const DistanceField& field);

// Fails the test unless `field` has the distances of `whole` up to its settled
// radius, +infinity beyond it and nothing else.
void ExpectCertified(const std::string& context, const DistanceField& field,
                     const DistanceField& whole);

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_CORE_SOLVER_COMPUTATION_SCENES_H_
