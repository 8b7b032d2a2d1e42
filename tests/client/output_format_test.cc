#include "client/output/output_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/client/temporary_folder.h"

namespace geodesic::client {
namespace {

using ::testing::HasSubstr;

TEST(OutputFormatTest, FollowsFromTheEnding) {
  EXPECT_EQ(*OutputFormatFromPath("a.npy"), OutputFormat::kNpy);
  EXPECT_EQ(*OutputFormatFromPath("a/b.c.CSV"), OutputFormat::kCsv);
  EXPECT_EQ(*OutputFormatFromPath("a.f64"), OutputFormat::kRaw);
  EXPECT_EQ(*OutputFormatFromPath("a.ply"), OutputFormat::kPly);
  EXPECT_EQ(*OutputFormatFromPath("a.vtk"), OutputFormat::kVtk);
  EXPECT_EQ(*OutputFormatFromPath("a.png"), OutputFormat::kPng);
}

TEST(OutputFormatTest, OtherEndingsAreRefused) {
  for (const char* path : {"", "a", "npy", "a.npy/b", "a.txt", "a."}) {
    absl::Status status = OutputFormatFromPath(path).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << path;
    EXPECT_THAT(std::string(status.message()), HasSubstr(OutputEndings()));
  }
}

TEST(CheckWritableTest, FindsOutEarly) {
  TemporaryFolder folder;
  EXPECT_TRUE(CheckWritable(folder / "new.npy").ok());
  EXPECT_TRUE(CheckWritable("new.npy").ok());
  EXPECT_FALSE(CheckWritable(folder / "missing/new.npy").ok());
  EXPECT_FALSE(CheckWritable(folder.path().string()).ok());
}

TEST(WriteOutputTest, WritesEveryFormat) {
  TemporaryFolder folder;
  const MeshArrays mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const std::vector<double> distances = {0, 1, 1};
  OutputContent content = {
      .mesh = &mesh, .distances = &distances, .sources = {0}};
  content.picture.width = 96;
  content.picture.height = 64;
  for (const char* name :
       {"a.npy", "a.csv", "a.f64", "a.ply", "a.vtk", "a.png"}) {
    const std::string path = folder / name;
    absl::StatusOr<OutputFormat> format = OutputFormatFromPath(path);
    ASSERT_TRUE(format.ok());
    absl::StatusOr<uint64_t> bytes = WriteOutput(path, *format, content);
    ASSERT_TRUE(bytes.ok()) << bytes.status();
    EXPECT_EQ(*bytes, FileBytes(path).size());
    EXPECT_GT(*bytes, 20);
  }
  EXPECT_EQ(folder.count(), 6);
}

}  // namespace
}  // namespace geodesic::client
