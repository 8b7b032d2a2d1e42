// Comparing a field with an oracle's, and solving in one line.

#ifndef GEODESIC_TESTS_SUPPORT_FIELD_CHECK_H_
#define GEODESIC_TESTS_SUPPORT_FIELD_CHECK_H_

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "geodesic/algorithm.h"
#include "geodesic/mesh.h"
#include "geodesic/query.h"
#include "geodesic/triangle_soup.h"
#include "tests/support/queries.h"

namespace geodesic::test {

// What Solve promises (solve.h, guarantee 1). The oracles and the rounding of
// generated coordinates stay a few orders of magnitude below it; a mistake in
// geometry, such as a lost or merged window, shows orders above.
inline constexpr double kRelativeTolerance = 1e-10;

// A mesh under test and what to call it in messages.
struct NamedMesh {
  std::string name;
  TriangleSoup soup;
};

// Fails the test and throws if the mesh is refused.
std::shared_ptr<const Mesh> BuildOrFail(const NamedMesh& mesh);
// Fails the test, and returns an empty result, if the solver fails; also fails
// it if the field breaks the law of edges (edge_law.h).
std::vector<double> SolveOrFail(const Mesh& mesh, Algorithm algorithm,
                                const std::vector<Source>& sources);

// Where a field came from, for messages.
struct FieldContext {
  std::string mesh;
  std::vector<Source> sources;
  std::string_view algorithm;
};

// In words, for messages.
std::string Name(const SurfacePoint& point);
std::string Name(const Source& source);

// Success if at every vertex the two differ by at most kRelativeTolerance times
// what is expected, plus `slack`, or are infinite both. Otherwise names the
// worst vertices. The worst relative error is recorded as a property of the
// running test.
testing::AssertionResult FieldsAgree(const FieldContext& context,
                                     const std::vector<double>& expected,
                                     const std::vector<double>& got,
                                     double slack = 0);

// The rounding of the mesh's largest coordinate: distances between vertices
// that lie so close together are known no better. Slack for meshes that have
// such vertices.
double CoordinateRounding(const TriangleSoup& soup);

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_FIELD_CHECK_H_
