// Landmarks outlive the process, as far as the disk keeps them whole.

#include "server/engine/searches/landmark_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/engine/durable_fixture.h"
#include "tests/support/meshes/curved_meshes.h"

namespace {

// Called once, before a file is flushed.
std::function<void()> before_flush;

}  // namespace

// The C library's.
extern "C" int fsync(int file) {
  if (before_flush) std::exchange(before_flush, nullptr)();
  return static_cast<int>(syscall(SYS_fsync, file));
}

namespace geodesic::server {
namespace {

namespace fs = std::filesystem;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class LandmarkFilesTest : public test::DurableEngineTest {
 protected:
  void SetUp() override {
    DurableEngineTest::SetUp();
    digest_ = Upload(geodesic::test::Icosphere(3)).value().mesh.digest;
  }

  // What a question gets, once idle time has passed.
  LandmarksHandle Wanted() {
    const auto mesh = Await(digest_);
    EXPECT_TRUE(mesh.ok()) << mesh.status();
    engine_->searches().landmarks().Want(*mesh);
    executor_.RunAll();
    return engine_->searches().landmarks().Present(**mesh);
  }

  std::vector<std::string> Files() const {
    std::vector<std::string> files;
    for (const auto& file : fs::directory_iterator(data_dir() + "/fields")) {
      files.push_back(file.path());
    }
    return files;
  }

  std::string digest_;
};

TEST_F(LandmarkFilesTest, TheyAreLoadedAfterARestart) {
  const LandmarksHandle before = Wanted();
  ASSERT_NE(before, nullptr);
  EXPECT_THAT(Files(), SizeIs(1));
  Restart();
  EXPECT_EQ(engine_->meshes().landmarks().used_bytes(), 0);
  const LandmarksHandle after = Wanted();
  ASSERT_NE(after, nullptr);
  EXPECT_EQ(after->count(), Landmarks::kMost);
  for (uint32_t v = 0; v < after->rows().size(); ++v) {
    ASSERT_EQ(after->rows()[v].steps, before->rows()[v].steps);
  }
  EXPECT_EQ(engine_->searches().landmarks().loaded(), Landmarks::kMost);
  EXPECT_EQ(engine_->searches().landmarks().made(), 0);
}

// They are made once; then the disk has them, each time that they are gone.
TEST_F(LandmarkFilesTest, WhoNeedsThemAtOnceLooksAtTheDiskFirst) {
  const auto mesh = Await(digest_);
  ASSERT_TRUE(mesh.ok()) << mesh.status();
  LandmarkMaker& maker = engine_->searches().landmarks();
  NoCheckpoint checkpoint;
  for (uint32_t times = 0; times < 3; ++times) {
    for (const bool are_there : {false, true}) {
      const auto made = maker.MakeNow(*mesh, Landmarks::kMost, checkpoint);
      ASSERT_TRUE(made.ok()) << made.status();
      EXPECT_EQ(*made, are_there) << times;
      executor_.RunAll();
    }
    EXPECT_EQ(maker.made(), Landmarks::kMost);
    EXPECT_EQ(maker.loaded(), times * Landmarks::kMost);
    engine_->meshes().landmarks().Erase(digest_);
  }
}

TEST_F(LandmarkFilesTest, ADamagedFileIsMadeAnew) {
  Wanted();
  const std::vector<std::string> files = Files();
  ASSERT_THAT(files, SizeIs(1));
  Stop();
  std::string bytes = geodesic::test::FileBytes(files[0]);
  bytes[bytes.size() / 2] ^= 1;
  geodesic::test::WriteFile(files[0], bytes);
  Restart();
  EXPECT_EQ(Wanted()->count(), Landmarks::kMost);
  EXPECT_EQ(engine_->searches().landmarks().made(), Landmarks::kMost);
  EXPECT_THAT(warnings_, SizeIs(1));
  Restart();
  Wanted();
  EXPECT_EQ(engine_->searches().landmarks().loaded(), Landmarks::kMost);
}

TEST_F(LandmarkFilesTest, AnotherVersionMakesItsOwn) {
  Wanted();
  version_ = "2";
  Restart();
  EXPECT_EQ(Wanted()->count(), Landmarks::kMost);
  EXPECT_EQ(engine_->searches().landmarks().made(), Landmarks::kMost);
  EXPECT_THAT(warnings_, IsEmpty());
}

TEST_F(LandmarkFilesTest, TheyGoWithTheirMesh) {
  Wanted();
  EXPECT_TRUE(Delete(digest_).ok());
  EXPECT_THAT(Files(), IsEmpty());
}

TEST_F(LandmarkFilesTest, TheyGoWithAMeshThatGoesWhileTheyAreWritten) {
  absl::Status deleted = absl::UnknownError("not told");
  before_flush = [&] { deleted = Delete(digest_); };
  Wanted();
  EXPECT_TRUE(deleted.ok()) << deleted;
  EXPECT_THAT(Files(), IsEmpty());
}

TEST_F(LandmarkFilesTest, AMeshThatComesBackToMemoryFindsThemAgain) {
  // Room for one mesh.
  limits_.mesh_store_bytes = 600 << 10;
  Restart();
  Wanted();
  EXPECT_GT(engine_->meshes().landmarks().used_bytes(), 0);
  ASSERT_TRUE(Upload(geodesic::test::Torus({.around = 30, .across = 30})).ok());
  EXPECT_EQ(engine_->meshes().Describe(digest_)->resident_bytes, 0);
  EXPECT_EQ(engine_->meshes().landmarks().used_bytes(), 0);
  EXPECT_EQ(Wanted()->count(), Landmarks::kMost);
  EXPECT_EQ(engine_->searches().landmarks().made(), Landmarks::kMost)
      << "the first time";
}

}  // namespace
}  // namespace geodesic::server
