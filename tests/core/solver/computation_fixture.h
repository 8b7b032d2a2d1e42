// What the typed tests of computations that stop and go on have in common.

#ifndef GEODESIC_TESTS_CORE_SOLVER_COMPUTATION_FIXTURE_H_
#define GEODESIC_TESTS_CORE_SOLVER_COMPUTATION_FIXTURE_H_

#include "geodesic/checkpoint.h"
#include "geodesic/query.h"
#include "tests/core/exactness/every_algorithm.h"

namespace geodesic::test {

class ComputationFixture : public EveryAlgorithm {
 protected:
  Query WithAlgorithm(Query query) const {
    query.algorithm = GetParam().algorithm;
    return query;
  }

  NoCheckpoint checkpoint_;
};

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_CORE_SOLVER_COMPUTATION_FIXTURE_H_
