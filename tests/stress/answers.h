// Solving, and comparing answers.

#ifndef GEODESIC_TESTS_STRESS_ANSWERS_H_
#define GEODESIC_TESTS_STRESS_ANSWERS_H_

#include <string>
#include <string_view>
#include <vector>

#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "geodesic/query.h"
#include "tests/stress/report.h"
#include "tests/stress/scene.h"
#include "tests/support/queries.h"

namespace geodesic::stress {

// What the solver promises: relative error of distances.
inline constexpr double kTolerance = 1e-10;

// A search for a target and a field may differ by so much. Both are within some
// 1e-14 of the truth; a window that is missing makes a difference of 1e-6 and
// more.
inline constexpr double kPairTolerance = 1e-12;

// Distances of all vertices, then of all targets; empty, and reported, if the
// solver fails.
std::vector<double> AllDistances(const Mesh& mesh, const Query& query,
                                 Report& report);
using test::AllDistances;

// Whether the two are equal up to `slack` and a relative error of `tolerance`,
// or both infinite.
bool AreEqual(double expected, double got, double slack,
              double tolerance = kTolerance);

// Checks that all of the two are; names the worst.
void CheckEqual(std::string_view law, const Query& query,
                const std::vector<double>& expected,
                const std::vector<double>& got, double slack, Report& report,
                double tolerance = kTolerance);

}  // namespace geodesic::stress

#endif  // GEODESIC_TESTS_STRESS_ANSWERS_H_
