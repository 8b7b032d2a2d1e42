// What holds of every approximate method.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <ostream>
#include <string>
#include <thread>
#include <vector>

#include "absl/status/status.h"
#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "geodesic/read_mesh.h"
#include "geodesic_types/field_path.h"
#include "tests/core/approximate/method_check.h"
#include "tests/core/exactness/every_algorithm.h"
#include "tests/support/checkpoints.h"
#include "tests/support/meshes/crowded_meshes.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/meshes/test_meshes.h"
#include "tests/support/temporary_folder.h"

namespace geodesic {

inline void PrintTo(const ApproximateMethodInfo& info, std::ostream* out) {
  *out << info.name;
}

namespace test {
namespace {

// Enough for meshes of this size, and quick on hundreds of them.
const MethodOptions kOptions{.gtu = {.samples = 60}};

// What any method is off by on even faces of this size: heat, the worst, is off
// by 5.1 % on the torus.
constexpr double kSomePerCent = 0.06;

class EveryMethod : public testing::TestWithParam<ApproximateMethodInfo> {
 protected:
  std::shared_ptr<const PreparedMethod> PrepareOn(const Mesh& mesh) const {
    return PrepareOrFail(mesh, GetParam().method, kOptions);
  }
  std::vector<double> Field(const Mesh& mesh,
                            const std::vector<Source>& sources) const {
    return AskOrFail(*PrepareOn(mesh), mesh, sources);
  }

  // Expects a field that is sound, or a refusal that names the method.
  void ExpectSoundOrRefused(const std::string& name, const Mesh& mesh,
                            uint32_t source) const {
    SCOPED_TRACE(name);
    NoCheckpoint checkpoint;
    const auto prepared =
        PrepareMethod(mesh, GetParam().method, kOptions, checkpoint);
    if (!prepared.ok()) {
      ExpectRefusal(prepared.status());
      return;
    }
    const Query query{.sources = {{VertexPoint{source}}}};
    const absl::StatusOr<ApproximateField> field =
        (*prepared)->Distances(Valid(mesh, query), checkpoint);
    if (!field.ok()) {
      ExpectRefusal(field.status());
      return;
    }
    // Only which vertices are reached is compared: no method bounds its error.
    const std::vector<double> edges =
        SolveOrFail(mesh, Algorithm::kFwpMmp, query.sources);
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
      ASSERT_EQ(std::isinf(field->distances[v]), std::isinf(edges[v]))
          << "vertex " << v;
      ASSERT_GE(field->distances[v], 0) << "vertex " << v;
    }
    EXPECT_EQ(field->distances[source], 0);
  }

  void ExpectRefusal(const absl::Status& status) const {
    EXPECT_TRUE(absl::IsInvalidArgument(status) ||
                absl::IsFailedPrecondition(status))
        << status;
    EXPECT_TRUE(absl::StrContains(std::string(status.message()),
                                  std::string(GetParam().name)))
        << status;
  }
};

TEST_P(EveryMethod, NamesItself) {
  const auto mesh = BuildOrFail({"sphere", Icosphere(1)});
  const auto prepared = PrepareOn(*mesh);
  EXPECT_EQ(prepared->method(), GetParam().method);
  NoCheckpoint checkpoint;
  EXPECT_EQ(
      prepared
          ->Distances(Valid(*mesh, {.sources = {{VertexPoint{3}}}}), checkpoint)
          ->method,
      GetParam().method);
  EXPECT_EQ(*ApproximateMethodFromName(GetParam().name), GetParam().method);
  EXPECT_FALSE(AlgorithmFromName(GetParam().name).ok())
      << "an exact algorithm has this name";
}

// On surfaces of even faces any of them is good to some per cent. A field in
// the wrong unit, from another source or without a front is not.
TEST_P(EveryMethod, IsNearTheExactDistances) {
  const NamedMesh meshes[] = {
      {"icosphere", Icosphere(4)},
      {"torus", Torus({.around = 60, .across = 30})},
      {"plane",
       MakeGrid(
           {.columns = 40, .rows = 30, .diagonals = Diagonals::kAlternating})}};
  for (const NamedMesh& named : meshes) {
    const auto mesh = BuildOrFail(named);
    const auto prepared = PrepareOn(*mesh);
    for (const std::vector<Source>& sources :
         {std::vector<Source>{{VertexPoint{0}}},
          {{VertexPoint{7}}, {VertexPoint{mesh->vertex_count() - 1}}}}) {
      const FieldErrors errors = CompareWithExact(
          *mesh, sources, AskOrFail(*prepared, *mesh, sources));
      EXPECT_LE(errors.mean, kSomePerCent) << named.name;
    }
  }
}

TEST_P(EveryMethod, StartsFromPlacesInFacesAndOnEdges) {
  const auto mesh = BuildOrFail({"icosphere", Icosphere(4)});
  for (const std::vector<Source>& sources :
       {std::vector<Source>{{FacePoint{17, {0.2, 0.5, 0.3}}}},
        {{EdgePoint{mesh->triangle(5)[0], mesh->triangle(5)[1], 0.25}}},
        {{FacePoint{17, {0.6, 0.2, 0.2}}}, {VertexPoint{1}}}}) {
    const FieldErrors errors =
        CompareWithExact(*mesh, sources, Field(*mesh, sources));
    EXPECT_LE(errors.mean, kSomePerCent);
  }
}

TEST_P(EveryMethod, IsInfiniteExactlyWhereNoPathLeads) {
  TriangleSoup soup = Join(Join(Icosphere(2), Terrain(6, 5, 0.5, 2)),
                           MakeGrid({.columns = 4, .rows = 4}));
  soup = AddIsolatedVertices(std::move(soup), 3);
  const auto mesh = BuildOrFail({"three components", soup});
  const uint32_t last = mesh->vertex_count() - 1;
  for (const std::vector<Source>& sources :
       {std::vector<Source>{{VertexPoint{3}}},
        {{VertexPoint{3}}, {VertexPoint{last - 3}}},
        {{VertexPoint{last}}}}) {
    CompareWithExact(*mesh, sources, Field(*mesh, sources));
  }
}

TEST_P(EveryMethod, IsSymmetricWhereTheMeshIs) {
  if (GetParam().method == ApproximateMethod::kGtu) {
    GTEST_SKIP() << "its samples are not";
  }
  const auto mesh = BuildOrFail({"icosphere", Icosphere(3)});
  const std::vector<double> field = Field(*mesh, {{VertexPoint{0}}});
  const std::vector<double> exact =
      SolveOrFail(*mesh, kDefaultAlgorithm, {{VertexPoint{0}}});
  // Vertices that the exact solver has at one distance are images of each
  // other under the turns and reflections that keep vertex 0.
  std::vector<uint32_t> order(exact.size());
  for (uint32_t v = 0; v < order.size(); ++v) order[v] = v;
  std::ranges::sort(order, {}, [&](uint32_t v) { return exact[v]; });
  int pairs = 0;
  for (size_t i = 1; i < order.size(); ++i) {
    const uint32_t v = order[i - 1], w = order[i];
    if (exact[w] > exact[v] * (1 + 1e-12)) continue;
    ++pairs;
    // Ties may be taken in either order.
    EXPECT_NEAR(field[v], field[w], 1e-6) << v << " and " << w;
  }
  EXPECT_GT(pairs, 400);
}

TEST_P(EveryMethod, GivesTheSameBitsAgainAndFromManyThreads) {
  const auto mesh = BuildOrFail({"torus", Torus({.noise = 0.05, .seed = 3})});
  const auto prepared = PrepareOn(*mesh);
  const std::vector<Source> sources = {{VertexPoint{1}}, {VertexPoint{40}}};
  const std::vector<double> first = AskOrFail(*prepared, *mesh, sources);
  EXPECT_EQ(AskOrFail(*PrepareOn(*mesh), *mesh, sources), first);
  std::vector<std::vector<double>> fields(4);
  {
    std::vector<std::jthread> threads;
    for (auto& field : fields) {
      threads.emplace_back(
          [&] { field = AskOrFail(*prepared, *mesh, sources); });
    }
  }
  for (const auto& field : fields) EXPECT_EQ(field, first);
}

TEST_P(EveryMethod, ScalesWithTheMesh) {
  const TriangleSoup soup = Torus({.noise = 0.05, .seed = 5});
  const auto mesh = BuildOrFail({"torus", soup});
  const std::vector<double> field = Field(*mesh, {{VertexPoint{2}}});
  for (const double factor : {0x1p-400, 0x1p400}) {
    const auto scaled = BuildOrFail({"scaled torus", Scale(soup, factor)});
    const std::vector<double> got = Field(*scaled, {{VertexPoint{2}}});
    for (uint32_t v = 0; v < field.size(); ++v) {
      EXPECT_EQ(got[v], field[v] * factor);
    }
  }
}

TEST_P(EveryMethod, RefusesWhatItCannotDoByName) {
  const auto mesh = BuildOrFail({"sphere", Icosphere(1)});
  const auto prepared = PrepareOn(*mesh);
  NoCheckpoint checkpoint;
  const Source curve{Curve{
      {VertexPoint{mesh->triangle(0)[0]}, VertexPoint{mesh->triangle(0)[1]}}}};
  const std::pair<Query, std::string> refused[] = {
      {{.sources = {{VertexPoint{0}}, curve}}, "sources[1].curve"},
      {{.sources = {{VertexPoint{0}}}, .targets = {VertexPoint{1}}},
       "targets[0]"},
      {{.sources = {{VertexPoint{0}}}, .trace = true}, "trace"}};
  for (const auto& [query, path] : refused) {
    const absl::Status status =
        prepared->Distances(Valid(*mesh, query), checkpoint).status();
    ExpectRefusal(status);
    EXPECT_EQ(FieldPathOf(status), path);
  }
}

TEST_P(EveryMethod, StopsWhenTheCheckpointSays) {
  const auto mesh = BuildOrFail({"sphere", Icosphere(3)});
  RecordingCheckpoint all;
  const auto prepared = PrepareMethod(*mesh, GetParam().method, kOptions, all);
  ASSERT_TRUE(prepared.ok());
  // Each is a preparation: not all of the hundreds.
  const uint64_t step = 1 + all.polls().size() / 24;
  for (uint64_t poll = 0; poll < all.polls().size(); poll += step) {
    RecordingCheckpoint cancel(poll);
    EXPECT_EQ(
        PrepareMethod(*mesh, GetParam().method, kOptions, cancel).status(),
        RecordingCheckpoint::Stopped());
  }
  const ValidQuery query = Valid(*mesh, {.sources = {{VertexPoint{0}}}});
  RecordingCheckpoint asked;
  ASSERT_TRUE((*prepared)->Distances(query, asked).ok());
  ASSERT_FALSE(asked.polls().empty());
  for (uint64_t poll = 0; poll < asked.polls().size(); ++poll) {
    RecordingCheckpoint cancel(poll);
    EXPECT_EQ((*prepared)->Distances(query, cancel).status(),
              RecordingCheckpoint::Stopped());
  }
  // Nothing that is not exact may look certified.
  for (const RecordingCheckpoint* checkpoint : {&all, &asked}) {
    for (const Progress& progress : checkpoint->polls()) {
      EXPECT_EQ(progress.settled_radius, 0);
      EXPECT_TRUE(progress.distances.empty());
    }
  }
}

// Each source lies on an edge of very many faces and starts from all of their
// corners.
TEST_P(EveryMethod, AsksWhileSourcesLookAtVeryManyFaces) {
  constexpr uint32_t kFaces = 1024, kSources = 256;
  const auto mesh = BuildOrFail({"pages", Pages(kFaces)});
  NoCheckpoint preparing;
  const auto prepared =
      PrepareMethod(*mesh, GetParam().method, kOptions, preparing);
  if (!prepared.ok()) GTEST_SKIP() << prepared.status();
  RecordingCheckpoint checkpoint;
  (void)(*prepared)->Distances(
      Valid(*mesh, {.sources = {kSources, {EdgePoint{0, 1, 0.5}}}}),
      checkpoint);
  EXPECT_GE(checkpoint.polls().size(), kSources * kFaces / 2048);
}

TEST_P(EveryMethod, IsSoundOrRefusesOnBadMeshes) {
  const TriangleSoup sphere = Icosphere(2);
  const NamedMesh meshes[] = {
      {"needles", InsertNeedles(sphere, 40, 1)},
      {"faces without area", InsertZeroAreaFaces(sphere, 40, 2)},
      {"doubled vertices", DoubleVertices(sphere, 10, 3)},
      {"book", Book(MakeGrid({.columns = 4, .rows = 3}), 3)},
      {"turned faces", TurnFaces(sphere, 4)},
      {"one face", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}},
      {"one point", {{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2}}}},
      {"a line", {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}}};
  for (const NamedMesh& named : meshes) {
    ExpectSoundOrRefused(named.name, *BuildOrFail(named), 1);
  }
  for (uint64_t seed = 1; seed <= 150; ++seed) {
    const NamedMesh named{absl::StrCat("edited mesh ", seed),
                          EditedMesh(seed, seed % 2 == 0)};
    const auto mesh = BuildOrFail(named);
    ExpectSoundOrRefused(named.name, *mesh, mesh->triangle(0)[0]);
  }
}

TEST_P(EveryMethod, IsSoundOrRefusesOnHostileFiles) {
  const std::filesystem::path folder = TestMeshFolder() / "hostile";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no meshes";
  // Larger ones add time, not shapes.
  constexpr uint32_t kMostFaces = 6000;
  int tried = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    absl::StatusOr<TriangleSoup> soup = LoadTestMesh("hostile/" + name);
    if (!soup.ok() || soup->triangles.size() > kMostFaces) continue;
    const auto mesh = Mesh::Build(*std::move(soup));
    if (!mesh.ok()) continue;
    ExpectSoundOrRefused(name, **mesh, (*mesh)->triangle(0)[0]);
    ++tried;
  }
  EXPECT_GT(tried, 40);
}

INSTANTIATE_TEST_SUITE_P(Methods, EveryMethod,
                         testing::ValuesIn(kApproximateMethods),
                         [](const auto& method) {
                           return TestName(method.param.name);
                         });

}  // namespace
}  // namespace test
}  // namespace geodesic
