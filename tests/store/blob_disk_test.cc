// Disks that cannot take more.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <filesystem>
#include <memory>
#include <string>

#include "server/store/blob_store.h"
#include "tests/store/blob_fixture.h"
#include "tests/support/small_disk.h"

namespace geodesic::server {
namespace {

using geodesic::test::SmallDisk;
using test::Name;
using test::Put;
using test::Read;
using ::testing::HasSubstr;

// A disk of a megabyte, of which the store thinks it may use 16.
class BlobDiskTest : public test::BlobTest {
 protected:
  static constexpr uint64_t kMiB = uint64_t{1} << 20;

  void SetUp() override {
    std::filesystem::create_directory(data_dir());
    absl::StatusOr<std::unique_ptr<SmallDisk>> disk =
        SmallDisk::Mount(data_dir(), kMiB);
    if (!disk.ok()) GTEST_SKIP() << disk.status().message();
    disk_ = *std::move(disk);
    ASSERT_TRUE(Open(16 * kMiB).ok());
    ASSERT_TRUE(Put(*store_, Name('a'), "there before").ok());
  }
  void TearDown() override { Close(); }

  std::unique_ptr<SmallDisk> disk_;
};

TEST_F(BlobDiskTest, AFullDiskIsSaidAndLeft) {
  const absl::Status full = Put(*store_, Name('b'), std::string(2 * kMiB, 'x'));
  EXPECT_TRUE(absl::IsResourceExhausted(full)) << full;
  EXPECT_THAT(std::string(full.message()), HasSubstr("No space left"));
  // Nothing is left of it, nor was anything thrown out for it.
  EXPECT_EQ(files(), 1);
  EXPECT_EQ(store_->Find(Name('b')), std::nullopt);
  EXPECT_EQ(*Read(*store_, Name('a')), "there before");
  EXPECT_EQ(store_->used_bytes(), kBlock);
  // What fits is taken.
  EXPECT_TRUE(Put(*store_, Name('b'), std::string(kMiB / 2, 'x')).ok());
  EXPECT_EQ(store_->counters().write_failures, 1);
}

TEST_F(BlobDiskTest, AServerStartsOnAFullDisk) {
  geodesic::test::WriteFile(data_dir() + "/filler", std::string(2 * kMiB, 'x'));
  ASSERT_TRUE(Open(16 * kMiB).ok());
  EXPECT_EQ(*Read(*store_, Name('a')), "there before");
  // Which makes the space that was missing.
  EXPECT_TRUE(store_->Erase(Name('a')).ok());
}

TEST_F(BlobDiskTest, DamageOnAReadOnlyDiskIsNotServed) {
  geodesic::test::WriteFile(data_dir() + "/things/" + Name('a') + ".thing",
                            "damage");
  ASSERT_TRUE(disk_->SetReadOnly(true).ok());
  EXPECT_TRUE(absl::IsDataLoss(Read(*store_, Name('a')).status()));
  EXPECT_TRUE(absl::IsNotFound(Read(*store_, Name('a')).status()));
  ASSERT_EQ(warnings_.size(), 1);
  EXPECT_THAT(warnings_[0], HasSubstr("Read-only"));
  ASSERT_TRUE(disk_->SetReadOnly(false).ok());
  ASSERT_TRUE(Open().ok());
  EXPECT_EQ(quarantined(), 1);
}

// The bound on a file's size that any user may set, where mounts are forbidden.
using BlobLimitTest = test::BlobTest;

TEST_F(BlobLimitTest, AFileThatMayNotGrowIsGivenUp) {
  ASSERT_TRUE(Open(64 << 20).ok());
  signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  rlimit small = before;
  small.rlim_cur = 100'000;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string body(200'000, 'x');
  const absl::Status status = Put(*store_, Name('a'), body);
  EXPECT_EQ(setrlimit(RLIMIT_FSIZE, &before), 0);
  EXPECT_TRUE(absl::IsResourceExhausted(status)) << status;
  EXPECT_EQ(files(), 0);
  EXPECT_EQ(store_->used_bytes(), 0);
  EXPECT_TRUE(Put(*store_, Name('a'), body).ok());
}

}  // namespace
}  // namespace geodesic::server
