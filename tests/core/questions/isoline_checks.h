// What must hold of the isolines of any mesh, checked by solving for points.

#ifndef GEODESIC_TESTS_CORE_QUESTIONS_ISOLINE_CHECKS_H_
#define GEODESIC_TESTS_CORE_QUESTIONS_ISOLINE_CHECKS_H_

#include <cstdint>
#include <vector>

#include "geodesic/isolines.h"
#include "tests/support/field_check.h"

namespace geodesic::test {

// Throws, which fails the test, where there is no answer.
std::vector<Isoline> IsolinesOrFail(const Mesh& mesh, const Query& query,
                                    const std::vector<double>& levels,
                                    double chord_error = 0);

double Length(const Isoline& isoline);
// Of all together.
double Length(const std::vector<Isoline>& isolines);

// Computes the isolines of all levels and expects that
//   - every point lies at its level, where positions say;
//   - no middle of a chord is farther from the level than a thousandth of it;
//   - points that follow each other differ, share a face and come once a level;
//   - open isolines end at the boundary or where more than two faces meet;
//   - along every edge, the points that are nearer than the level are told from
//     the others by the crossings in between: at both ends, and at `samples`
//     points of edges drawn at random.
// With a tolerance in the query, levels and sides hold within it. `slack` is
// added to the tolerance of distances.
void ExpectIsolines(const NamedMesh& named, const Query& query,
                    const std::vector<double>& levels, uint32_t samples,
                    double slack = 0);

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_CORE_QUESTIONS_ISOLINE_CHECKS_H_
