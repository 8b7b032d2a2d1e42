#include "server/store/data_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "tests/support/temporary_folder.h"

namespace geodesic::server {
namespace {

using ::testing::HasSubstr;

class DataFolderTest : public ::testing::Test {
 protected:
  geodesic::test::TemporaryFolder temporary_;
  const std::string path_ = temporary_ / "data";
};

TEST_F(DataFolderTest, IsForThisUserAlone) {
  ASSERT_TRUE(DataFolder::Open(path_).ok());
  struct stat facts {};
  ASSERT_EQ(stat(path_.c_str(), &facts), 0);
  EXPECT_EQ(facts.st_mode & 0777, 0700);
  ASSERT_EQ(stat((path_ + "/lock").c_str(), &facts), 0);
  EXPECT_EQ(facts.st_mode & 0777, 0600);
}

TEST_F(DataFolderTest, HasOneOwnerAtATime) {
  {
    const auto first = DataFolder::Open(path_);
    ASSERT_TRUE(first.ok()) << first.status();
    const absl::Status second = DataFolder::Open(path_).status();
    EXPECT_TRUE(absl::IsUnavailable(second));
    EXPECT_THAT(std::string(second.message()),
                HasSubstr("in use by process " + std::to_string(getpid())));
    EXPECT_THAT(std::string(second.message()), HasSubstr(path_));
    // Nor if the file of the lock is replaced.
    ASSERT_TRUE(std::filesystem::remove(path_ + "/lock"));
    EXPECT_TRUE(absl::IsUnavailable(DataFolder::Open(path_).status()));
  }
  EXPECT_TRUE(DataFolder::Open(path_).ok());
}

TEST_F(DataFolderTest, AKilledOwnerLetsGo) {
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t owner = fork();
  if (owner == 0) {
    const auto folder = DataFolder::Open(path_);
    if (!folder.ok() || write(ready[1], "r", 1) != 1) _exit(1);
    for (;;) pause();
  }
  char byte = 0;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  EXPECT_THAT(std::string(DataFolder::Open(path_).status().message()),
              HasSubstr("by process " + std::to_string(owner)));
  kill(owner, SIGKILL);
  waitpid(owner, nullptr, 0);
  EXPECT_TRUE(DataFolder::Open(path_).ok());
  close(ready[0]);
  close(ready[1]);
}

TEST_F(DataFolderTest, SaysWhatIsInTheWay) {
  const absl::Status nowhere = DataFolder::Open(temporary_ / "a/b").status();
  EXPECT_TRUE(absl::IsUnavailable(nowhere));
  EXPECT_THAT(std::string(nowhere.message()), HasSubstr("a/b"));
  geodesic::test::WriteFile(path_, "a file");
  EXPECT_TRUE(absl::IsUnavailable(DataFolder::Open(path_).status()));
}

TEST_F(DataFolderTest, APipeIsNoLock) {
  ASSERT_EQ(mkdir(path_.c_str(), 0700), 0);
  ASSERT_EQ(mkfifo((path_ + "/lock").c_str(), 0600), 0);
  const absl::Status status = DataFolder::Open(path_).status();
  EXPECT_TRUE(absl::IsUnavailable(status));
  EXPECT_THAT(std::string(status.message()), HasSubstr(path_ + "/lock"));
}

}  // namespace
}  // namespace geodesic::server
