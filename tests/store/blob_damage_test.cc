// Files that are not as they were written.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "server/store/blob_store.h"
#include "tests/store/blob_fixture.h"

namespace geodesic::server {
namespace {

namespace fs = std::filesystem;
using geodesic::test::FileBytes;
using geodesic::test::WriteFile;
using test::Name;
using test::Put;
using test::Read;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

class BlobDamageTest : public test::BlobTest {
 protected:
  static constexpr std::string_view kBody = "a body of some bytes";

  void SetUp() override {
    ASSERT_TRUE(Open().ok());
    ASSERT_TRUE(Put(*store_, Name('a'), kBody).ok());
    ASSERT_TRUE(Put(*store_, Name('b'), "untouched").ok());
    good_ = FileBytes(FileOf(Name('a')));
  }

  // Whether the file in quarantine is the damaged one; empties it.
  void ExpectQuarantined(const std::string& damaged) {
    const std::string aside =
        data_dir() + "/quarantine/" + Name('a') + ".thing";
    ASSERT_EQ(quarantined(), 1);
    EXPECT_EQ(FileBytes(aside), damaged);
    EXPECT_FALSE(std::filesystem::exists(FileOf(Name('a'))));
    ASSERT_EQ(warnings_.size(), 1);
    EXPECT_THAT(warnings_[0], HasSubstr(Name('a')));
    EXPECT_THAT(warnings_[0], HasSubstr("quarantine/"));
    std::filesystem::remove(aside);
    warnings_.clear();
  }

  // The damage is noticed by a read of an open store.
  void ExpectSetAsideByRead(const std::string& damaged) {
    WriteFile(FileOf(Name('a')), damaged);
    removed_.clear();
    const absl::Status status = Read(*store_, Name('a')).status();
    EXPECT_TRUE(absl::IsDataLoss(status)) << status;
    EXPECT_EQ(store_->Find(Name('a')), std::nullopt);
    EXPECT_THAT(removed_, ElementsAre(Name('a')));
    ExpectQuarantined(damaged);
    EXPECT_EQ(*Read(*store_, Name('b')), "untouched");
    // The name is free.
    ASSERT_TRUE(Put(*store_, Name('a'), kBody).ok());
    EXPECT_EQ(*Read(*store_, Name('a')), kBody);
  }

  // The damage is there when a store is opened; it is noticed then or, in the
  // body, when it is read.
  void ExpectNeverServed(const std::string& damaged) {
    WriteFile(FileOf(Name('a')), damaged);
    ASSERT_TRUE(Open().ok());
    if (store_->Find(Name('a')).has_value()) {
      EXPECT_TRUE(absl::IsDataLoss(Read(*store_, Name('a')).status()));
    }
    EXPECT_EQ(store_->size(), 1);
    ExpectQuarantined(damaged);
    EXPECT_EQ(*Read(*store_, Name('b')), "untouched");
  }

  std::string good_;
};

TEST_F(BlobDamageTest, IsNeverServed) {
  std::vector<std::string> samples = {good_ + '\0',
                                      FileBytes(FileOf(Name('b')))};
  for (size_t i = 0; i < good_.size(); i += 5) {
    samples.push_back(good_);
    samples.back()[i] = static_cast<char>(good_[i] ^ (1 << i % 8));
  }
  for (size_t size = 0; size < good_.size(); size += 7) {
    samples.push_back(good_.substr(0, size));
  }
  // What is left of a write of which only the length reached the disk.
  for (size_t from = 0; from < good_.size(); from += 16) {
    samples.push_back(good_.substr(0, from) +
                      std::string(good_.size() - from, '\0'));
  }
  for (size_t i = 0; i < samples.size(); ++i) {
    SCOPED_TRACE("sample " + std::to_string(i));
    ASSERT_NO_FATAL_FAILURE(ExpectSetAsideByRead(samples[i]));
    ASSERT_NO_FATAL_FAILURE(ExpectNeverServed(samples[i]));
    ASSERT_TRUE(Put(*store_, Name('a'), kBody).ok());
  }
}

// A name under which there is something else than a file.
TEST_F(BlobDamageTest, WhatIsNoFileIsLeftOutByName) {
  const std::string pipe = FileOf(Name('c'));
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const int listener = socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{.sun_family = AF_UNIX};
  // An address is short, so it is given from within the folder.
  const std::string socket_name = Name('d') + ".thing";
  ASSERT_LT(socket_name.size(), sizeof(address.sun_path));
  socket_name.copy(address.sun_path, socket_name.size());
  const fs::path before = fs::current_path();
  fs::current_path(fs::path(pipe).parent_path());
  const int bound =
      bind(listener, reinterpret_cast<sockaddr*>(&address), sizeof(address));
  fs::current_path(before);
  close(listener);
  ASSERT_EQ(bound, 0);
  fs::create_directory(FileOf(Name('e')));
  fs::create_symlink("/dev/zero", FileOf(Name('f')));

  ASSERT_TRUE(Open().ok());
  EXPECT_EQ(store_->size(), 2);
  EXPECT_THAT(warnings_,
              UnorderedElementsAre(HasSubstr(Name('c')), HasSubstr(Name('d')),
                                   HasSubstr(Name('e')), HasSubstr(Name('f'))));
  EXPECT_EQ(*Read(*store_, Name('b')), "untouched");
}

// It takes the place of a file while the store is open.
TEST_F(BlobDamageTest, APipeIsNotWaitedFor) {
  fs::remove(FileOf(Name('a')));
  ASSERT_EQ(mkfifo(FileOf(Name('a')).c_str(), 0600), 0);
  const absl::Status status = Read(*store_, Name('a')).status();
  EXPECT_TRUE(absl::IsUnavailable(status)) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr(Name('a')));
}

}  // namespace
}  // namespace geodesic::server
