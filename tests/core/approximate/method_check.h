// Asking approximate methods in one line, and comparing them with the exact
// solver.

#ifndef GEODESIC_TESTS_CORE_APPROXIMATE_METHOD_CHECK_H_
#define GEODESIC_TESTS_CORE_APPROXIMATE_METHOD_CHECK_H_

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "geodesic/approximate/prepare.h"
#include "tests/support/field_check.h"
#include "tests/support/queries.h"

namespace geodesic::test {

// These throw, which fails the test, where the method refuses.
inline std::shared_ptr<const PreparedMethod> PrepareOrFail(
    const Mesh& mesh, ApproximateMethod method,
    const MethodOptions& options = {}) {
  NoCheckpoint checkpoint;
  return PrepareMethod(mesh, method, options, checkpoint).value();
}

inline std::vector<double> AskOrFail(const PreparedMethod& method,
                                     const Mesh& mesh,
                                     const std::vector<Source>& sources) {
  NoCheckpoint checkpoint;
  return method.Distances(Valid(mesh, {.sources = sources}), checkpoint)
      .value()
      .distances;
}

// Relative to the exact solver's, over the vertices that have a distance and
// are no source.
struct FieldErrors {
  double mean = 0;
  double largest = 0;
};

inline FieldErrors CompareWithExact(const Mesh& mesh,
                                    const std::vector<Source>& sources,
                                    const std::vector<double>& distances) {
  const std::vector<double> exact =
      SolveOrFail(mesh, kDefaultAlgorithm, sources);
  FieldErrors errors;
  int count = 0;
  for (uint32_t v = 0; v < exact.size(); ++v) {
    EXPECT_EQ(std::isinf(distances[v]), std::isinf(exact[v])) << "vertex " << v;
    if (exact[v] == 0 || std::isinf(exact[v])) continue;
    const double error = std::abs(distances[v] / exact[v] - 1);
    errors.mean += error;
    errors.largest = std::max(errors.largest, error);
    ++count;
  }
  errors.mean /= std::max(count, 1);
  return errors;
}

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_CORE_APPROXIMATE_METHOD_CHECK_H_
