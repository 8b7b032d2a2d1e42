// The engine with a data folder: what is there after a restart, and what
// happens when the disk fails.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "digest/sha256.h"
#include "server/engine/base/status_details.h"
#include "tests/engine/durable_fixture.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/small_disk.h"

namespace geodesic::server {
namespace {

namespace fs = std::filesystem;
using geodesic::test::SmallDisk;
using test::DurableEngineTest;
using test::Grid;
using test::kMiB;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST_F(DurableEngineTest, EverythingIsThereAfterARestart) {
  const TriangleSoup soup = geodesic::test::Icosphere(2);
  const auto before = Upload(soup).value();
  EXPECT_FALSE(before.already_resident);
  EXPECT_GT(before.mesh.resident_bytes, 0);
  EXPECT_EQ(before.mesh.stored_bytes, fs::file_size(FileOf(DigestOf(soup))));
  ASSERT_TRUE(Upload(test::TetrahedronOffHeader(), test::kTetrahedronOff).ok());
  const std::vector<std::string> listed = Listed();
  Restart();

  EXPECT_THAT(listed, SizeIs(2));
  EXPECT_EQ(Listed(), listed);
  const std::string digest = before.mesh.digest;
  const auto described = engine_->meshes().Describe(digest).value();
  EXPECT_EQ(described.resident_bytes, 0);
  EXPECT_EQ(described.stored_bytes, before.mesh.stored_bytes);
  const MeshSummary& was = before.mesh.summary;
  const MeshSummary& is = described.summary;
  EXPECT_EQ(is.vertices, was.vertices);
  EXPECT_EQ(is.faces, was.faces);
  EXPECT_EQ(is.edges, was.edges);
  EXPECT_EQ(is.components, was.components);
  EXPECT_EQ(is.genus, was.genus);
  EXPECT_EQ(is.is_orientable, was.is_orientable);
  EXPECT_EQ(is.saddle_vertices, was.saddle_vertices);
  EXPECT_EQ(is.bounding_box_min, was.bounding_box_min);
  EXPECT_EQ(is.bounding_box_max, was.bounding_box_max);
  EXPECT_EQ(is.mean_edge_length, was.mean_edge_length);
  EXPECT_EQ(is.anisotropy, was.anisotropy);

  const auto mesh = Await(digest).value();
  EXPECT_TRUE(std::ranges::equal(mesh->mesh->positions(), soup.positions));
  for (uint32_t face = 0; face < soup.triangles.size(); ++face) {
    ASSERT_EQ(mesh->mesh->triangle(face), soup.triangles[face]);
  }
  EXPECT_GT(engine_->meshes().Describe(digest)->resident_bytes, 0);
  EXPECT_EQ(engine_->counters().meshes_loaded, 1);
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(DurableEngineTest, NothingKnownIsAskedForAgain) {
  const TriangleSoup soup = Grid(5);
  ASSERT_TRUE(Upload(soup).ok());
  ASSERT_TRUE(Upload(test::TetrahedronOffHeader(), test::kTetrahedronOff).ok());
  Restart();
  const FileKey file = {MeshFormat::kOff, Sha256Hex(test::kTetrahedronOff)};
  const auto missing =
      engine_->meshes().FindMissing({DigestOf(soup)}, {file}).value();
  EXPECT_THAT(missing.mesh_digests, IsEmpty());
  ASSERT_THAT(missing.known_files, SizeIs(1));
  EXPECT_EQ(missing.known_files[0].mesh_digest, DigestOf(test::Tetrahedron()));

  // Nor is it built when it comes again, as arrays or as a file.
  for (const auto& again : {Upload(soup), Upload(test::TetrahedronOffHeader(),
                                                 test::kTetrahedronOff)}) {
    ASSERT_TRUE(again.ok()) << again.status();
    EXPECT_TRUE(again->already_resident);
  }
  EXPECT_EQ(engine_->counters().meshes_built, 0);
  EXPECT_EQ(engine_->meshes().store().used_bytes(), 0);
}

TEST_F(DurableEngineTest, WhatIsDeletedStaysAway) {
  const std::string digest = Upload(Grid(5))->mesh.digest;
  EXPECT_TRUE(Delete(digest).ok());
  EXPECT_TRUE(absl::IsNotFound(Delete(digest)));
  EXPECT_TRUE(absl::IsNotFound(engine_->meshes().Get(digest).status()));
  EXPECT_TRUE(absl::IsNotFound(Await(digest).status()));
  EXPECT_FALSE(fs::exists(FileOf(digest)));
  Restart();
  EXPECT_THAT(Listed(), IsEmpty());
  EXPECT_TRUE(absl::IsNotFound(engine_->meshes().Describe(digest).status()));
}

TEST_F(DurableEngineTest, ADeletionDuringALoadWins) {
  const std::string digest = Upload(Grid(5))->mesh.digest;
  Restart();
  const auto loaded = AskFor(digest);
  absl::Status deleted = absl::UnknownError("not told");
  ASSERT_TRUE(engine_->meshes()
                  .Delete(digest, [&](const auto& s) { deleted = s; })
                  .ok());
  executor_.RunAll();
  EXPECT_TRUE(loaded->ok()) << loaded->status();
  EXPECT_TRUE(deleted.ok()) << deleted;
  EXPECT_TRUE(absl::IsNotFound(engine_->meshes().Get(digest).status()));
  EXPECT_THAT(Listed(), IsEmpty());
}

// Room on disk for two small meshes.
class DiskBudgetTest : public DurableEngineTest {
 protected:
  DiskBudgetTest() { limits_.mesh_disk_bytes = 2 * 4096; }
};

TEST_F(DiskBudgetTest, WhatTheDiskForgetsIsGone) {
  const std::string a = Upload(Grid(2, 1))->mesh.digest;
  const std::string b = Upload(Grid(3, 1))->mesh.digest;
  ASSERT_TRUE(Field({.mesh_digest = b}).ok());
  // A question keeps a mesh young.
  ASSERT_TRUE(engine_->meshes().Get(a).ok());
  const std::string c = Upload(Grid(4, 1))->mesh.digest;
  std::vector<std::string> expected = {a, c};
  std::ranges::sort(expected);
  EXPECT_EQ(Listed(), expected);
  EXPECT_TRUE(absl::IsNotFound(engine_->meshes().Get(b).status()));
  EXPECT_THAT(engine_->meshes().FindMissing({a, b, c}, {})->mesh_digests,
              ElementsAre(b));
  EXPECT_EQ(engine_->fields().cache().size(), 0);
  Restart();
  EXPECT_EQ(Listed(), expected);
}

TEST_F(DiskBudgetTest, AMeshBeyondTheBudgetIsRefused) {
  const std::string small = Upload(Grid(2, 1))->mesh.digest;
  // Before a byte is sent, since its header says how large it is.
  const absl::Status status =
      engine_->meshes().StartUpload(test::ArrayHeader(Grid(20, 20))).status();
  EXPECT_TRUE(absl::IsResourceExhausted(status)) << status;
  EXPECT_FALSE(RetryAfter(status).has_value()) << "waiting would not help";
  EXPECT_EQ(ReasonOf(status), reason::kLimitExceeded);
  EXPECT_THAT(std::string(status.message()),
              HasSubstr(absl::StrCat(limits_.mesh_disk_bytes)));
  EXPECT_THAT(std::string(status.message()), HasSubstr("mesh-disk"));
  // That is no fault of the disk.
  const BlobCounters counters = engine_->durable()->meshes->blobs().counters();
  EXPECT_EQ(counters.too_large, 1);
  EXPECT_EQ(counters.write_failures, 0);
  EXPECT_THAT(Listed(), ElementsAre(small));
  EXPECT_TRUE(
      absl::IsNotFound(engine_->meshes().Get(DigestOf(Grid(20, 20))).status()));
}

TEST_F(DurableEngineTest, DamageIsSetAsideAndHealedByAnUpload) {
  const TriangleSoup soup = Grid(5);
  const std::string digest = Upload(soup)->mesh.digest;
  std::string bytes = geodesic::test::FileBytes(FileOf(digest));
  bytes[bytes.size() / 2] ^= 1;
  Stop();
  geodesic::test::WriteFile(FileOf(digest), bytes);
  Restart();
  const absl::Status status = Await(digest).status();
  EXPECT_TRUE(absl::IsNotFound(status)) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr("upload it again"));
  EXPECT_EQ(MeshAtFault(status), digest);
  ASSERT_THAT(warnings_, SizeIs(1));
  EXPECT_THAT(warnings_[0], HasSubstr(digest));
  EXPECT_THAT(engine_->meshes().FindMissing({digest}, {})->mesh_digests,
              ElementsAre(digest));
  EXPECT_TRUE(fs::exists(data_dir() + "/quarantine/" + digest + ".mesh"));

  ASSERT_TRUE(Upload(soup).ok());
  Restart();
  EXPECT_TRUE(Await(digest).ok());
}

TEST_F(DurableEngineTest, FieldsAreThereAfterARestart) {
  const std::string digest = Upload(geodesic::test::Icosphere(2))->mesh.digest;
  const FieldRequest request = {.mesh_digest = digest,
                                .extras = {.gradients = true}};
  const auto before = Field(request).value();
  EXPECT_EQ(before.origin, FieldOrigin::kComputed);
  Restart();
  ASSERT_TRUE(Await(digest).ok());
  const auto after = Field(request).value();
  EXPECT_EQ(after.origin, FieldOrigin::kCached);
  EXPECT_EQ(after.field->distances, before.field->distances);
  EXPECT_EQ(after.derived->gradients, before.derived->gradients);
  EXPECT_EQ(after.field->settled_radius, before.field->settled_radius);
  EXPECT_EQ(after.field->algorithm, before.field->algorithm);
  EXPECT_EQ(after.field->statistics.windows_created,
            before.field->statistics.windows_created);
  EXPECT_EQ(engine_->counters().solves_started, 0);
  EXPECT_EQ(engine_->counters().fields_loaded, 1);
  // From memory, the second time.
  EXPECT_EQ(Field(request)->origin, FieldOrigin::kCached);
  EXPECT_EQ(engine_->counters().fields_loaded, 1);
}

// A mesh that is deleted while one of its fields is on its way.
class LateFieldTest : public DurableEngineTest {
 protected:
  LateFieldTest() { limits_.max_concurrent_jobs = 2; }

  void SetUp() override {
    DurableEngineTest::SetUp();
    digest_ = Upload(soup_)->mesh.digest;
  }

  void StartDelete() {
    ASSERT_TRUE(engine_->meshes()
                    .Delete(digest_, [&](const auto& s) { deleted_ = s; })
                    .ok());
  }

  // The client keeps what it was given.
  void Ask() {
    FieldRequest request{.mesh_digest = digest_};
    request.query.sources = {{VertexPoint{0}}};
    call_ = engine_->fields().Compute(request, observer_);
    ASSERT_TRUE(call_.ok()) << call_.status();
  }

  void ExpectNoFieldIsLeft() {
    executor_.RunAll();
    EXPECT_TRUE(deleted_.ok()) << deleted_;
    EXPECT_TRUE(observer_->answer->ok()) << observer_->answer->status();
    EXPECT_EQ(engine_->fields().cache().size(), 0);
    EXPECT_TRUE(fs::is_empty(data_dir() + "/fields"));
    at_start_ = nullptr;
    Restart();
    ASSERT_TRUE(Upload(soup_).ok());
    EXPECT_EQ(Field({.mesh_digest = digest_})->origin, FieldOrigin::kComputed);
  }

  const TriangleSoup soup_ = Grid(5);
  std::string digest_;
  absl::Status deleted_ = absl::UnknownError("not told");
  absl::StatusOr<FieldCall> call_;
  std::shared_ptr<test::RecordingObserver> observer_ =
      std::make_shared<test::RecordingObserver>();
};

TEST_F(LateFieldTest, DeletedWhileItWaits) {
  Ask();
  StartDelete();
  ExpectNoFieldIsLeft();
}

TEST_F(LateFieldTest, DeletedWhileItIsComputed) {
  at_start_ = [&] {
    StartDelete();
    executor_.RunAll();
  };
  Ask();
  ExpectNoFieldIsLeft();
}

TEST_F(LateFieldTest, DeletedBeforeItIsWritten) {
  at_start_ = [&] { StartDelete(); };
  Ask();
  ExpectNoFieldIsLeft();
}

TEST_F(LateFieldTest, DeletedWhileItIsRead) {
  ASSERT_TRUE(Field({.mesh_digest = digest_}).ok());
  Restart();
  ASSERT_TRUE(Await(digest_).ok());
  Ask();
  StartDelete();
  ExpectNoFieldIsLeft();
}

// In no more memory than without a file.
TEST_F(DurableEngineTest, ADamagedFieldIsComputedAgain) {
  const std::string digest = Upload(Grid(5))->mesh.digest;
  absl::StatusOr<FieldAnswer> before;
  for (limits_.solver_memory_bytes = kMiB / 1024; !before.ok();
       limits_.solver_memory_bytes += limits_.solver_memory_bytes / 8) {
    Restart();
    ASSERT_TRUE(Await(digest).ok());
    before = Field({.mesh_digest = digest});
    if (before.ok()) break;
    ASSERT_LT(limits_.solver_memory_bytes, kMiB) << before.status();
  }
  limits_.field_cache_bytes = engine_->fields().cache().used_bytes();
  Stop();
  const fs::path file = fs::directory_iterator(data_dir() + "/fields")->path();
  std::string bytes = geodesic::test::FileBytes(file.string());
  bytes[200] ^= 1;
  geodesic::test::WriteFile(file.string(), bytes);
  Restart();
  ASSERT_TRUE(Await(digest).ok());
  const auto after = Field({.mesh_digest = digest}).value();
  EXPECT_EQ(after.origin, FieldOrigin::kComputed);
  EXPECT_EQ(after.field->distances, before->field->distances);
  EXPECT_THAT(warnings_, SizeIs(1));
}

// A data folder on a disk of half a megabyte.
class FailingDiskTest : public DurableEngineTest {
 protected:
  void SetUp() override {
    fs::create_directory(data_dir());
    auto disk = SmallDisk::Mount(data_dir(), kMiB / 2);
    if (!disk.ok()) GTEST_SKIP() << disk.status().message();
    disk_ = *std::move(disk);
    Restart();
    resident_ = Upload(Grid(5))->mesh.digest;
  }
  void TearDown() override {
    Stop();
    disk_.reset();
  }

  std::unique_ptr<SmallDisk> disk_;
  std::string resident_;
};

TEST_F(FailingDiskTest, AFullDiskRefusesUploadsAndServesTheRest) {
  const TriangleSoup large = Grid(150, 150);
  const absl::Status status = Upload(large).status();
  EXPECT_TRUE(absl::IsResourceExhausted(status)) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr("delete meshes"));
  EXPECT_TRUE(RetryAfter(status).has_value());
  // What was refused is nowhere.
  EXPECT_TRUE(
      absl::IsNotFound(engine_->meshes().Get(DigestOf(large)).status()));
  EXPECT_THAT(Listed(), ElementsAre(resident_));
  // The rest goes on, and small ones are taken.
  EXPECT_TRUE(Field({.mesh_digest = resident_}).ok());
  EXPECT_TRUE(Upload(Grid(6)).ok());
}

TEST_F(FailingDiskTest, SpaceHealsWithoutARestart) {
  const std::string filler = data_dir() + "/filler";
  geodesic::test::WriteFile(filler, std::string(kMiB, 'x'));
  const TriangleSoup soup = Grid(40, 40);
  EXPECT_TRUE(absl::IsResourceExhausted(Upload(soup).status()));
  // A field that cannot be kept is answered all the same.
  EXPECT_TRUE(Field({.mesh_digest = resident_}).ok());
  fs::remove(filler);
  ASSERT_TRUE(Upload(soup).ok());
  Restart();
  EXPECT_TRUE(Await(DigestOf(soup)).ok());
}

TEST_F(FailingDiskTest, AReadOnlyDiskRefusesChangesAndServesTheRest) {
  ASSERT_TRUE(disk_->SetReadOnly(true).ok());
  const absl::Status upload = Upload(Grid(6)).status();
  EXPECT_TRUE(absl::IsUnavailable(upload)) << upload;
  EXPECT_THAT(std::string(upload.message()), HasSubstr("Read-only"));
  const absl::Status deletion = Delete(resident_);
  EXPECT_TRUE(absl::IsUnavailable(deletion)) << deletion;
  EXPECT_TRUE(engine_->meshes().Get(resident_).ok());
  EXPECT_TRUE(Field({.mesh_digest = resident_}).ok());
  // A restart changes nothing of that.
  Restart();
  EXPECT_TRUE(Await(resident_).ok());

  ASSERT_TRUE(disk_->SetReadOnly(false).ok());
  EXPECT_TRUE(Upload(Grid(6)).ok());
  EXPECT_TRUE(Delete(resident_).ok());
}

}  // namespace
}  // namespace geodesic::server
