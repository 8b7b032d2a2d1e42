// Output files: what their endings ask for, and how they appear.

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "client/output/atomic_file.h"
#include "client/output/output_format.h"
#include "client/output/zip_archive.h"
#include "tests/client/temporary_folder.h"

namespace geodesic::client {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

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
  EXPECT_TRUE(CheckWritable(folder / "new.npy", {}).ok());
  EXPECT_TRUE(CheckWritable("new.npy", {}).ok());
  EXPECT_FALSE(CheckWritable(folder / "missing/new.npy", {}).ok());
  EXPECT_FALSE(CheckWritable(folder.path().string(), {}).ok());
  const std::string inputs[] = {folder / "none", folder / "read.npy"};
  WriteFile(inputs[1], "");
  EXPECT_TRUE(CheckWritable(folder / "new.npy", inputs).ok());
  EXPECT_FALSE(CheckWritable(folder / "./read.npy", inputs).ok());
}

TEST(CheckWritableTest, KnowsWhatStandardInputReads) {
  TemporaryFolder folder;
  WriteFile(folder / "list.csv", "1\n");
  const int before = dup(STDIN_FILENO);
  const int list = open((folder / "list.csv").c_str(), O_RDONLY);
  dup2(list, STDIN_FILENO);
  const std::string inputs[] = {"-"};
  EXPECT_FALSE(CheckWritable(folder / "list.csv", inputs).ok());
  EXPECT_TRUE(CheckWritable(folder / "other.csv", inputs).ok());
  dup2(before, STDIN_FILENO);
  close(list);
  close(before);
}

// Writes "new" there.
absl::Status WriteNew(const std::string& path) {
  absl::StatusOr<AtomicFile> file = AtomicFile::Create(path);
  if (!file.ok()) return file.status();
  file->Append("new");
  return file->Commit();
}

TEST(AtomicFileTest, LinksMayLeadToWhatIsNotThereYet) {
  TemporaryFolder folder;
  std::filesystem::create_symlink("next", folder / "link");
  std::filesystem::create_symlink("file", folder / "next");
  EXPECT_TRUE(WriteNew(folder / "link").ok());
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "next"));
  EXPECT_EQ(FileBytes(folder / "file"), "new");
  std::filesystem::create_symlink("loop", folder / "loop");
  EXPECT_FALSE(WriteNew(folder / "loop").ok());
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "loop"));
}

TEST(AtomicFileTest, PermissionsOfTheOldFileStay) {
  TemporaryFolder folder;
  for (const char* name : {"file", "file.gz"}) {
    ASSERT_TRUE(WriteNew(folder / name).ok());
    const auto mine = std::filesystem::perms::owner_read |
                      std::filesystem::perms::owner_write;
    std::filesystem::permissions(folder / name, mine);
    ASSERT_TRUE(WriteNew(folder / name).ok());
    EXPECT_EQ(std::filesystem::status(folder / name).permissions(), mine);
  }
}

TEST(AtomicFileTest, PipesAreWrittenInto) {
  TemporaryFolder folder;
  const std::string pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), S_IRUSR | S_IWUSR), 0);
  EXPECT_TRUE(CheckWritable(pipe, {}).ok());
  // Nobody reads: that is told, not waited for.
  EXPECT_THAT(std::string(WriteNew(pipe).message()), HasSubstr(pipe));
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  EXPECT_TRUE(WriteNew(pipe).ok());
  std::string read_bytes(10, ' ');
  EXPECT_EQ(read(reader, read_bytes.data(), read_bytes.size()), 3);
  EXPECT_THAT(read_bytes, StartsWith("new"));
  close(reader);
  EXPECT_TRUE(IsPipeOrDevice(pipe)) << "it is no file now";

  EXPECT_TRUE(WriteNew("/dev/null").ok());
  EXPECT_FALSE(WriteNew("/dev/full").ok());
  std::filesystem::create_symlink(pipe, folder / "pipe.gz");
  EXPECT_TRUE(absl::IsInvalidArgument(WriteNew(folder / "pipe.gz")));
  EXPECT_FALSE(ZipArchive::Create(pipe).ok());
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
