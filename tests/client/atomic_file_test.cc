#include "client/output/atomic_file.h"

#include <gtest/gtest.h>

#include "tests/client/temporary_folder.h"

namespace geodesic::client {
namespace {

TEST(AtomicFileTest, AppearsAtCommit) {
  TemporaryFolder folder;
  const std::string path = folder / "out.bin";
  absl::StatusOr<AtomicFile> file = AtomicFile::Create(path);
  ASSERT_TRUE(file.ok()) << file.status();
  file->Append("some ");
  file->Append("bytes");
  EXPECT_EQ(file->size(), 10);
  EXPECT_FALSE(std::filesystem::exists(path));
  ASSERT_TRUE(file->Commit().ok());
  EXPECT_EQ(FileBytes(path), "some bytes");
  EXPECT_EQ(folder.count(), 1);
}

TEST(AtomicFileTest, LeavesTheOldFileAloneUnlessCommitted) {
  TemporaryFolder folder;
  const std::string path = folder / "out.bin";
  WriteFile(path, "old");
  {
    absl::StatusOr<AtomicFile> file = AtomicFile::Create(path);
    ASSERT_TRUE(file.ok());
    file->Append("half of the new");
  }
  EXPECT_EQ(FileBytes(path), "old");
  EXPECT_EQ(folder.count(), 1);
  absl::StatusOr<AtomicFile> file = AtomicFile::Create(path);
  ASSERT_TRUE(file.ok());
  file->Append("new");
  ASSERT_TRUE(file->Commit().ok());
  EXPECT_EQ(FileBytes(path), "new");
}

TEST(AtomicFileTest, MissingFolderIsNamed) {
  TemporaryFolder folder;
  const std::string path = folder / "missing/out.bin";
  absl::Status status = AtomicFile::Create(path).status();
  EXPECT_TRUE(absl::IsNotFound(status)) << status;
  EXPECT_NE(status.message().find(path), absl::string_view::npos);
}

TEST(AtomicFileTest, FailureLeavesNothingBehind) {
  // Renaming over a folder fails, whatever the user's rights.
  TemporaryFolder folder;
  const std::string path = folder / "out";
  std::filesystem::create_directory(path);
  absl::StatusOr<AtomicFile> file = AtomicFile::Create(path);
  ASSERT_TRUE(file.ok());
  file->Append("bytes");
  EXPECT_FALSE(file->Commit().ok());
  EXPECT_EQ(folder.count(), 1);
}

}  // namespace
}  // namespace geodesic::client
