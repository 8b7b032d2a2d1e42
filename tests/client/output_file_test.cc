// Output files: what their endings ask for, and how they appear.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <string>

#include "client/output/atomic_file.h"
#include "client/output/output_format.h"
#include "tests/client/temporary_folder.h"

namespace geodesic::client {
namespace {

using ::testing::HasSubstr;

TEST(OutputFormatTest, FollowsFromTheEnding) {
  EXPECT_EQ(*OutputFormatFromPath("a.npy", kFieldFormats), OutputFormat::kNpy);
  EXPECT_EQ(*OutputFormatFromPath("a/b.c.CSV", kFieldFormats),
            OutputFormat::kCsv);
  EXPECT_EQ(*OutputFormatFromPath("a.f32", kFieldFormats), OutputFormat::kF32);
  EXPECT_EQ(*OutputFormatFromPath(kStandardOutput, kFieldFormats),
            OutputFormat::kCsv);
  EXPECT_EQ(*OutputFormatFromPath("a.obj", kLineFormats), OutputFormat::kObj);
  EXPECT_EQ(*OutputFormatFromPath("a.npz", kMatrixFormats), OutputFormat::kNpz);
}

TEST(OutputFormatTest, OtherEndingsAreRefused) {
  for (const char* path : {"", "a", "npy", "a.npy/b", "a.txt", "a."}) {
    absl::Status status = OutputFormatFromPath(path, kFieldFormats).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << path;
    EXPECT_THAT(std::string(status.message()),
                HasSubstr(OutputEndings(kFieldFormats)));
  }
  EXPECT_FALSE(OutputFormatFromPath("a.obj", kFieldFormats).ok());
  EXPECT_FALSE(OutputFormatFromPath("a.npy", kLineFormats).ok());
  EXPECT_EQ(OutputEndings(kMatrixFormats), ".npy, .npz and .csv");
}

TEST(CheckWritableTest, FindsOutEarly) {
  TemporaryFolder folder;
  EXPECT_TRUE(CheckWritable(folder / "new.npy").ok());
  EXPECT_TRUE(CheckWritable("new.npy").ok());
  EXPECT_FALSE(CheckWritable(folder / "missing/new.npy").ok());
  EXPECT_FALSE(CheckWritable(folder.path().string()).ok());
}

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

TEST(OutputFormatTest, GzipMayFollow) {
  EXPECT_EQ(*OutputFormatFromPath("a.ply.GZ", kFieldFormats),
            OutputFormat::kPly);
  EXPECT_FALSE(OutputFormatFromPath("a.gz", kFieldFormats).ok());
  EXPECT_THAT(
      std::string(
          OutputFormatFromPath("a.npz.gz", kFieldFormats).status().message()),
      HasSubstr("compressed already"));
}

TEST(AtomicFileTest, IsCompressedWhereThePathSaysSo) {
  TemporaryFolder folder;
  const std::string path = folder / "out.csv.gz";
  const std::string text(300'000, 'x');
  absl::StatusOr<AtomicFile> file = AtomicFile::Create(path);
  ASSERT_TRUE(file.ok()) << file.status();
  file->Append(text + "end");
  file->Replace("start");
  ASSERT_TRUE(file->Commit().ok());
  EXPECT_EQ(folder.count(), 1);
  EXPECT_LT(FileBytes(path).size(), 1000);
  EXPECT_EQ(file->size(), FileBytes(path).size());

  const gzFile packed = gzopen(path.c_str(), "rb");
  ASSERT_NE(packed, nullptr);
  std::string found(text.size() + 100, '\0');
  found.resize(std::max(
      0, gzread(packed, found.data(), static_cast<unsigned>(found.size()))));
  gzclose(packed);
  EXPECT_EQ(found, "start" + text.substr(5) + "end");
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
