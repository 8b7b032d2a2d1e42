// A test per algorithm of the table, and the one way these tests compare a
// field with an oracle's.

#ifndef GEODESIC_TESTS_CORE_EXACTNESS_EVERY_ALGORITHM_H_
#define GEODESIC_TESTS_CORE_EXACTNESS_EVERY_ALGORITHM_H_

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "geodesic_types/algorithms.h"
#include "tests/support/field_check.h"
#include "tests/support/meshes/test_meshes.h"
#include "tests/support/oracles/brute_force.h"
#include "tests/support/vec.h"

namespace geodesic {

inline void PrintTo(const AlgorithmInfo& info, std::ostream* out) {
  *out << info.name;
}

namespace test {

// Whether these tests run an algorithm on a mesh of `faces` faces: any on any,
// but CH without the filter, which makes ten to fifty times the windows of the
// others, on small ones only. Tests that meet larger ones ask here, and say so.
inline bool IsTestedOn(Algorithm algorithm, uint64_t faces) {
  constexpr uint64_t kMostFacesForCh = 6000;
  return algorithm != Algorithm::kCh || faces <= kMostFacesForCh;
}

inline std::vector<AlgorithmInfo> AlgorithmsTestedOn(uint64_t faces) {
  std::vector<AlgorithmInfo> tested;
  std::ranges::copy_if(kAlgorithms, std::back_inserter(tested),
                       [&](const AlgorithmInfo& info) {
                         return IsTestedOn(info.algorithm, faces);
                       });
  return tested;
}

class EveryAlgorithm : public testing::TestWithParam<AlgorithmInfo> {
 protected:
  // The query, asked of the algorithm under test.
  Query Ask(Query query) const {
    query.algorithm = GetParam().algorithm;
    return query;
  }

  std::vector<double> SolveOn(const Mesh& mesh,
                              const std::vector<Source>& sources) const {
    return SolveOrFail(mesh, GetParam().algorithm, sources);
  }

  // Compares the field of each of `sources`, one at a time, with
  // `distance(source, vertex)`.
  template <typename DistanceFunction>
  void ExpectDistances(const NamedMesh& named,
                       const std::vector<uint32_t>& sources,
                       DistanceFunction distance) const {
    const std::shared_ptr<const Mesh> mesh = BuildOrFail(named);
    for (const uint32_t s : sources) {
      std::vector<double> expected;
      for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
        expected.push_back(distance(s, v));
      }
      ExpectField(named.name, *mesh, {{VertexPoint{s}}}, expected);
    }
  }

  // The same for a mesh in which distances are those of Euclid.
  void ExpectEuclid(const NamedMesh& mesh,
                    const std::vector<uint32_t>& sources) const {
    const std::vector<Point>& p = mesh.soup.positions;
    ExpectDistances(mesh, sources, [&](uint32_t s, uint32_t v) {
      return static_cast<double>(Distance(p[s], p[v]));
    });
  }

  // The same with brute force, from these vertices.
  void ExpectBruteForce(const NamedMesh& named,
                        const std::vector<uint32_t>& sources) const {
    const std::shared_ptr<const Mesh> mesh = BuildOrFail(named);
    const BruteForce brute_force(named.soup);
    for (const uint32_t s : sources) {
      ExpectField(named.name, *mesh, {{VertexPoint{s}}},
                  brute_force.Distances(s));
    }
  }

  void ExpectField(const std::string& name, const Mesh& mesh,
                   const std::vector<Source>& sources,
                   const std::vector<double>& expected) const {
    ExpectAnswer(name, mesh, {.sources = sources}, expected);
  }

  // `expected`: distances of the vertices, then of the targets.
  void ExpectAnswer(const std::string& name, const Mesh& mesh,
                    const Query& query, const std::vector<double>& expected,
                    double slack = 0) const {
    const AlgorithmInfo asked[] = {GetParam()};
    ExpectFromAll(asked, name, mesh, query, expected, slack);
  }
};

// A mesh of others, the file that the parameter names. Skips itself where it is
// not there.
class RealMesh : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const std::string name = absl::StrCat("real/", GetParam());
    absl::StatusOr<TriangleSoup> soup = LoadTestMesh(name);
    if (absl::IsNotFound(soup.status())) GTEST_SKIP() << soup.status();
    named_ = {name, std::move(soup).value()};
    mesh_ = BuildOrFail(named_);
  }

  NamedMesh named_;
  std::shared_ptr<const Mesh> mesh_;
};

// `count` vertices spread over the numbers of a mesh, the first and the last
// among them.
inline std::vector<uint32_t> SpreadVertices(const TriangleSoup& soup,
                                            uint32_t count) {
  const uint32_t last = static_cast<uint32_t>(soup.positions.size() - 1);
  std::vector<uint32_t> vertices;
  for (uint32_t i = 0; i < count; ++i) {
    vertices.push_back(last * i / (count - 1));
  }
  return vertices;
}

// A name as GoogleTest wants it: letters, digits and underscores.
inline std::string TestName(std::string_view text) {
  std::string name(text);
  for (char& c : name) {
    if (!absl::ascii_isalnum(static_cast<unsigned char>(c))) c = '_';
  }
  return name;
}

inline std::string AlgorithmTestName(
    const testing::TestParamInfo<AlgorithmInfo>& info) {
  return TestName(info.param.name);
}

// For tests whose parameter is the name of a mesh file.
inline std::string MeshTestName(
    const testing::TestParamInfo<const char*>& info) {
  return TestName(info.param);
}

}  // namespace test
}  // namespace geodesic

// Runs the TEST_Ps of `suite`, a subclass of EveryAlgorithm.
#define GEODESIC_TEST_EVERY_ALGORITHM(suite)                                  \
  INSTANTIATE_TEST_SUITE_P(Algorithms, suite, testing::ValuesIn(kAlgorithms), \
                           AlgorithmTestName)

#endif  // GEODESIC_TESTS_CORE_EXACTNESS_EVERY_ALGORITHM_H_
