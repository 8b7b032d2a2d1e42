#include "server/engine/fields/field_files.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/store/data_folder.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/queries.h"
#include "tests/support/temporary_folder.h"

namespace geodesic::server {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class FieldFilesTest : public ::testing::Test {
 protected:
  void SetUp() override { Open("1"); }

  void Open(const std::string& version) {
    files_.reset();
    disk_.reset();
    folder_.reset();
    auto folder = DataFolder::Open(temporary_ / "data");
    ASSERT_TRUE(folder.ok()) << folder.status();
    folder_.emplace(*std::move(folder));
    auto disk =
        BlobStore::Open(*folder_, {.kind = "field", .capacity = 1 << 20});
    ASSERT_TRUE(disk.ok()) << disk.status();
    disk_ = *std::move(disk);
    blobs_.emplace(disk_.get(), nullptr);
    files_.emplace(*blobs_, version);
  }

  static FieldKey Key(const std::function<void(Query&)>& change = {}) {
    Query query{.sources = {{VertexPoint{1}, 0.5},
                            {Curve{{VertexPoint{2}, EdgePoint{2, 3, 0.25}}}}},
                .targets = {FacePoint{4, {0.25, 0.25, 0.5}}}};
    if (change) change(query);
    // Valid on a grid of ten by ten vertices.
    static const std::shared_ptr<const Mesh> grid =
        *Mesh::Build(geodesic::test::MakeGrid({.columns = 9, .rows = 9}));
    return {.mesh_digest = std::string(64, 'a'),
            .query = geodesic::test::Valid(*grid, query).Sorted().query};
  }

  static DistanceField Field(double settled_radius = kInfinity) {
    return {.distances = {0, 1, kInfinity},
            .target_distances = {0.75},
            .settled_radius = settled_radius,
            .algorithm = Algorithm::kFwpMmp,
            .statistics = {.windows_created = 7, .solve_seconds = 0.5}};
  }

  // Three vertices.
  static std::shared_ptr<const Mesh> OneFace(Triangle corners) {
    return *Mesh::Build({.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                         .triangles = {corners}});
  }

  const std::shared_ptr<const Mesh> mesh_ = OneFace({0, 1, 2});
  geodesic::test::TemporaryFolder temporary_;
  std::optional<DataFolder> folder_;
  std::unique_ptr<BlobStore> disk_;
  std::optional<BlobTiers> blobs_;
  std::optional<FieldFiles> files_;
};

TEST_F(FieldFilesTest, AFieldComesBackWhole) {
  DistanceField field = Field();
  field.arrivals.resize(3);
  field.arrivals[1] = {.pseudo_source = 5, .entry = 6, .x = 0.125, .depth = 2};
  field.target_arrivals.resize(1);
  ASSERT_TRUE(files_->Put(Key(), *mesh_, field).ok());
  Open("1");
  const auto stored = files_->Load(Key(), {}, *mesh_);
  ASSERT_TRUE(stored.ok()) << stored.status();
  const DistanceField& found = stored->field;
  EXPECT_EQ(found.distances, field.distances);
  EXPECT_EQ(found.target_distances, field.target_distances);
  EXPECT_EQ(found.settled_radius, kInfinity);
  EXPECT_EQ(found.algorithm, Algorithm::kFwpMmp);
  EXPECT_EQ(found.statistics.windows_created, 7);
  EXPECT_EQ(found.statistics.solve_seconds, 0.5);
  ASSERT_EQ(found.arrivals.size(), 3);
  EXPECT_EQ(found.arrivals[1].pseudo_source, 5);
  EXPECT_EQ(found.arrivals[1].entry, 6);
  EXPECT_EQ(found.arrivals[1].x, 0.125);
  EXPECT_EQ(found.arrivals[1].depth, 2);
  EXPECT_EQ(found.arrivals[2].pseudo_source, kNoPseudoSource);
  EXPECT_EQ(found.target_arrivals.size(), 1);
}

// Arrivals name half-edges.
TEST_F(FieldFilesTest, ATracedFieldIsOfOneLayout) {
  DistanceField field = Field();
  field.arrivals.resize(3);
  field.target_arrivals.resize(1);
  ASSERT_TRUE(files_->Put(Key(), *mesh_, field).ok());
  EXPECT_TRUE(files_->Load(Key(), {}, *mesh_).ok());
  const auto turned = OneFace({1, 2, 0});
  EXPECT_TRUE(absl::IsNotFound(files_->Load(Key(), {}, *turned).status()));
  // Distances alone are the same whatever the numbers.
  FieldKey other = Key();
  other.mesh_digest[0] = 'b';
  ASSERT_TRUE(files_->Put(other, *mesh_, Field()).ok());
  EXPECT_TRUE(files_->Load(other, {}, *turned).ok());
}

// Every part of a key tells fields apart.
TEST_F(FieldFilesTest, OtherQuestionsAreOthers) {
  ASSERT_TRUE(files_->Put(Key(), *mesh_, Field()).ok());
  EXPECT_TRUE(files_->Find(Key(), {}).has_value());
  const auto curve = [](Query& query) -> std::vector<SurfacePoint>& {
    return std::get<Curve>(query.sources[1].place).points;
  };
  std::vector<FieldKey> others = {
      Key([](Query& query) { query.sources[0].offset = 0.25; }),
      Key([](Query& query) { query.sources[0].place = VertexPoint{2}; }),
      Key([](Query& query) { query.sources.erase(query.sources.begin()); }),
      Key([](Query& query) { query.sources[1].offset = 1; }),
      Key([&](Query& query) { curve(query).pop_back(); }),
      Key([&](Query& query) {
        curve(query)[1] = EdgePoint{2, 3, 0.5};
      }),
      // A curve is not its points.
      Key([](Query& query) {
        query.sources[0].place = Curve{{VertexPoint{1}}};
      }),
      Key([](Query& query) {
        query.targets[0] = FacePoint{5, {0.25, 0.25, 0.5}};
      }),
      Key([](Query& query) {
        query.targets[0] = EdgePoint{4, 5, 0.25};
      }),
      Key([](Query& query) { query.targets.clear(); }),
      Key([](Query& query) { query.algorithm = Algorithm::kMmp; })};
  others.resize(14, Key());
  others[11].mesh_digest[0] = 'b';
  others[12].bucket_width = 1;
  others[13].max_batch = 1;
  for (size_t i = 0; i < others.size(); ++i) {
    EXPECT_FALSE(files_->Find(others[i], {}).has_value()) << i;
  }
}

TEST_F(FieldFilesTest, ATracedFieldAnswersForOneWithout) {
  const FieldKey traced = Key([](Query& query) { query.trace = true; });
  ASSERT_TRUE(files_->Put(traced, *mesh_, Field()).ok());
  EXPECT_EQ(files_->Find(Key(), {}), traced);
  ASSERT_TRUE(files_->Put(Key(), *mesh_, Field()).ok());
  EXPECT_EQ(files_->Find(Key(), {}), Key());
}

TEST_F(FieldFilesTest, TheFieldThatReachesFurtherIsKept) {
  ASSERT_TRUE(files_->Put(Key(), *mesh_, Field(2)).ok());
  ASSERT_TRUE(files_->Put(Key(), *mesh_, Field(1)).ok());
  EXPECT_TRUE(files_->Find(Key(), {.radius = 2}).has_value());
  EXPECT_FALSE(files_->Find(Key(), {.radius = 3}).has_value());
  EXPECT_EQ(files_->Load(Key(), {.radius = 2}, *mesh_)->field.settled_radius,
            2);
  ASSERT_TRUE(files_->Put(Key(), *mesh_, Field(4)).ok());
  EXPECT_TRUE(files_->Find(Key(), {.radius = 3}).has_value());
  EXPECT_EQ(disk_->size(), 1);
}

TEST_F(FieldFilesTest, FieldsAreThoseOfOneVersion) {
  ASSERT_TRUE(files_->Put(Key(), *mesh_, Field()).ok());
  Open("2");
  EXPECT_FALSE(files_->Find(Key(), {}).has_value());
  Open("1");
  EXPECT_TRUE(files_->Find(Key(), {}).has_value());
}

TEST_F(FieldFilesTest, GoWithTheirMesh) {
  FieldKey other = Key();
  other.mesh_digest[0] = 'b';
  ASSERT_TRUE(files_->Put(Key(), *mesh_, Field()).ok());
  ASSERT_TRUE(files_->Put(other, *mesh_, Field()).ok());
  files_->EraseMesh(Key().mesh_digest);
  EXPECT_FALSE(files_->Find(Key(), {}).has_value());
  EXPECT_TRUE(files_->Find(other, {}).has_value());
}

}  // namespace
}  // namespace geodesic::server
