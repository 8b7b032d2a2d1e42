#include "tests/support/field_check.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <limits>
#include <sstream>
#include <utility>

#include "geodesic/solve.h"
#include "tests/support/oracles/edge_paths.h"
#include "tests/support/surface_points.h"

namespace geodesic::test {
namespace {

// |got - expected| / expected; 0 where both are 0 or both infinite.
double RelativeError(double expected, double got) {
  if (expected == got) return 0;
  if (std::isinf(expected) || std::isinf(got) || std::isnan(got)) {
    return std::numeric_limits<double>::infinity();
  }
  return std::abs(got - expected) / std::abs(expected);
}

// Keeps, as a property of the running test, the worst error it has seen from
// each algorithm: the figures of a run with --gtest_output=xml.
void RecordWorstError(std::string_view algorithm, double error) {
  const testing::TestInfo* test =
      testing::UnitTest::GetInstance()->current_test_info();
  if (test == nullptr) return;
  const std::string key = "worst_error_" + std::string(algorithm);
  const testing::TestResult& result = *test->result();
  for (int i = 0; i < result.test_property_count(); ++i) {
    const testing::TestProperty& property = result.GetTestProperty(i);
    if (property.key() != key) continue;
    error = std::max(error, std::strtod(property.value(), nullptr));
  }
  std::ostringstream text;
  text << std::setprecision(3) << error;
  testing::Test::RecordProperty(key, text.str());
}

}  // namespace

std::shared_ptr<const Mesh> BuildOrFail(const NamedMesh& mesh) {
  absl::StatusOr<std::shared_ptr<const Mesh>> built = Mesh::Build(mesh.soup);
  EXPECT_TRUE(built.ok()) << mesh.name << ": " << built.status();
  return std::move(built).value();
}

DistanceField SolveOrFail(const Mesh& mesh, const Query& query) {
  NoCheckpoint checkpoint;
  DistanceField field = Solve(mesh, query, {}, checkpoint).value();
  if (const auto breach = BreachOfEdgeLaw(mesh, field.distances)) {
    ADD_FAILURE() << AlgorithmName(query.algorithm) << ": " << *breach;
  }
  return field;
}

std::vector<double> SolveOrFail(const Mesh& mesh, Algorithm algorithm,
                                const std::vector<Source>& sources) {
  return SolveOrFail(mesh, {.sources = sources, .algorithm = algorithm})
      .distances;
}

testing::AssertionResult FieldsAgree(const FieldContext& context,
                                     const std::vector<double>& expected,
                                     const std::vector<double>& got,
                                     double slack) {
  std::ostringstream text;
  text << std::setprecision(17) << context.mesh << ", " << context.algorithm
       << ", sources";
  for (const Source& source : context.sources) text << "; " << Name(source);
  if (expected.size() != got.size()) {
    return testing::AssertionFailure()
           << text.str() << ": " << got.size() << " distances for "
           << expected.size() << " vertices";
  }
  double worst_error = 0;
  std::vector<std::pair<double, size_t>> wrong;  // error, vertex
  for (size_t v = 0; v < got.size(); ++v) {
    if (std::abs(got[v] - expected[v]) <= slack) continue;
    const double error = RelativeError(expected[v], got[v]);
    worst_error = std::max(worst_error, error);
    if (error > kRelativeTolerance) wrong.emplace_back(error, v);
  }
  RecordWorstError(context.algorithm, worst_error);
  if (wrong.empty()) return testing::AssertionSuccess();
  text << ": " << wrong.size() << " of " << got.size() << " vertices differ";
  std::sort(wrong.rbegin(), wrong.rend());
  wrong.resize(std::min<size_t>(wrong.size(), 5));
  for (const auto& [error, v] : wrong) {
    text << "\n  vertex " << v << ": expected " << expected[v] << ", got "
         << got[v] << " (relative error " << std::setprecision(3) << error
         << std::setprecision(17) << ")";
  }
  return testing::AssertionFailure() << text.str();
}

void ExpectFromAll(std::span<const AlgorithmInfo> algorithms,
                   const std::string& name, const Mesh& mesh, Query query,
                   const std::vector<double>& expected, double slack) {
  for (const AlgorithmInfo& info : algorithms) {
    query.algorithm = info.algorithm;
    EXPECT_TRUE(FieldsAgree({name, query.sources, info.name}, expected,
                            AllDistances(SolveOrFail(mesh, query)), slack));
  }
}

}  // namespace geodesic::test
