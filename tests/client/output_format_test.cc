#include "client/output/output_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/client/temporary_folder.h"

namespace geodesic::client {
namespace {

using ::testing::HasSubstr;

TEST(OutputFormatTest, FollowsFromTheEnding) {
  EXPECT_EQ(*OutputFormatFromPath("a.npy", kFieldFormats), OutputFormat::kNpy);
  EXPECT_EQ(*OutputFormatFromPath("a/b.c.CSV", kFieldFormats),
            OutputFormat::kCsv);
  EXPECT_EQ(*OutputFormatFromPath("a.f32", kFieldFormats), OutputFormat::kF32);
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
}

TEST(OutputFormatTest, WhatAnotherCommandWritesIsRefused) {
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

}  // namespace
}  // namespace geodesic::client
