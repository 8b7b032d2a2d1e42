// Where damaged files go, and how many may lie there.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>

#include "server/store/data_folder.h"
#include "tests/store/blob_fixture.h"

namespace geodesic::server {
namespace {

using geodesic::test::WriteFile;
using test::Name;

class QuarantineTest : public test::BlobTest {
 protected:
  void SetUp() override {
    auto folder = DataFolder::Open(data_dir());
    ASSERT_TRUE(folder.ok()) << folder.status();
    folder_.emplace(*std::move(folder));
  }
  Quarantine& quarantine() { return folder_->quarantine(); }

  // Sets aside a file of so many bytes.
  void Take(const std::string& name, size_t bytes = 10) {
    WriteFile(data_dir() + "/" + name, std::string(bytes, 'x'));
    const auto taken = quarantine().Take(folder_->descriptor(), name);
    ASSERT_TRUE(taken.ok()) << taken.status();
    EXPECT_FALSE(std::filesystem::exists(data_dir() + "/" + name));
  }
  bool Has(const std::string& name) const {
    return std::filesystem::exists(data_dir() + "/quarantine/" + name);
  }
};

TEST_F(QuarantineTest, TheLatestHundredAreKept) {
  for (int i = 0; i < 100; ++i) {
    WriteFile(data_dir() + "/quarantine/" + std::to_string(1000 + i), "x");
  }
  Take("a", kBlock + 1);
  EXPECT_EQ(quarantine().Count().files, 100);
  EXPECT_EQ(quarantine().Count().bytes, 101 * kBlock);
  EXPECT_FALSE(Has("1000"));
  EXPECT_TRUE(Has("1001"));
  EXPECT_TRUE(Has("a"));
}

TEST_F(QuarantineTest, ANameMayComeAgain) {
  Take("a");
  Take("a");
  EXPECT_TRUE(Has("a"));
  EXPECT_TRUE(Has("a.1"));
}

TEST_F(QuarantineTest, PeopleMayTakeFilesAway) {
  for (const char* name : {"a", "b"}) Take(name);
  std::filesystem::remove(data_dir() + "/quarantine/b");
  EXPECT_EQ(quarantine().Count().files, 1);
  EXPECT_EQ(quarantine().Count().bytes, kBlock);
}

using BlobCountersTest = test::BlobTest;

TEST_F(BlobCountersTest, EverythingIsCountedOnce) {
  ASSERT_TRUE(Open(2 * kBlock).ok());
  for (const char digit : {'a', 'b', 'c'}) {
    ASSERT_TRUE(test::Put(*store_, Name(digit), "body").ok());
  }
  EXPECT_FALSE(
      test::Put(*store_, Name('d'), std::string(3 * kBlock, 'x')).ok());
  ASSERT_TRUE(test::Read(*store_, Name('b')).ok());
  EXPECT_TRUE(absl::IsNotFound(test::Read(*store_, Name('a')).status()));
  EXPECT_TRUE(absl::IsCancelled(store_->Read(
      Name('b'), [](auto, auto&) { return absl::CancelledError("enough"); })));
  EXPECT_TRUE(
      absl::IsResourceExhausted(store_->Read(Name('b'), [](auto, auto&) {
        return absl::ResourceExhaustedError("no memory for it");
      })));
  WriteFile(FileOf(Name('c')), "damaged");
  EXPECT_TRUE(absl::IsDataLoss(test::Read(*store_, Name('c')).status()));
  const BlobCounters counters = store_->counters();
  EXPECT_EQ(counters.writes, 3);
  EXPECT_EQ(counters.write_failures, 0) << "the disk is well";
  EXPECT_EQ(counters.too_large, 1);
  EXPECT_EQ(counters.evictions, 1);
  EXPECT_EQ(counters.reads, 4);
  EXPECT_EQ(counters.read_failures, 1);
  EXPECT_EQ(counters.damaged, 1);

  // What is found at the start counts, too.
  WriteFile(FileOf(Name('b')), "damaged");
  ASSERT_TRUE(Open().ok());
  EXPECT_EQ(store_->counters().damaged, 1);
  EXPECT_EQ(store_->counters().reads, 0);
}

}  // namespace
}  // namespace geodesic::server
