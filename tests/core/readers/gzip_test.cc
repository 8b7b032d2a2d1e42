#include "geodesic/gzip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/read_mesh.h"
#include "tests/core/readers/soup_checks.h"
#include "tests/support/checkpoints.h"
#include "tests/support/gzip_file.h"

namespace geodesic {
namespace {

using test::Gzip;
using test::IsInvalidWith;

std::string Text(const std::vector<char>& bytes) {
  return {bytes.begin(), bytes.end()};
}

constexpr char kTriangle[] = "OFF\n3 1 0\n0 0 0\n3 0 0\n0 4 0\n3 0 1 2\n";

TEST(GzipTest, PiecesAndPaddingAreRead) {
  const std::string bytes = Gzip("one ") + Gzip("") + Gzip("two");
  EXPECT_TRUE(IsGzip(bytes));
  EXPECT_EQ(Text(Gunzip(bytes, 7).value()), "one two");
  EXPECT_EQ(Text(Gunzip(bytes + std::string(9, '\0'), 7).value()), "one two");
}

TEST(GzipTest, ABombStopsAtItsBound) {
  const std::string bomb = Gzip(std::string(50'000'000, 'x'));
  ASSERT_LT(bomb.size(), 60'000);
  EXPECT_EQ(PromisedGzipBytes(bomb), 50'000'000);
  const auto refused = Gunzip(bomb, 49'999'999);
  EXPECT_TRUE(absl::IsResourceExhausted(refused.status())) << refused.status();
  EXPECT_EQ(Gunzip(bomb, 50'000'000).value().size(), 50'000'000);
}

TEST(GzipTest, PromisesAreNotBelieved) {
  std::string lying = Gzip(std::string(100'000, 'x'));
  // The last four bytes are the size.
  lying.replace(lying.size() - 4, 4, "\xff\xff\xff\xff");
  EXPECT_LE(PromisedGzipBytes(lying), 1032 * lying.size());
  EXPECT_THAT(Gunzip(lying, 1 << 20), IsInvalidWith("damaged"));
  EXPECT_GE(PromisedGzipBytes(""), 1);
}

TEST(GzipTest, EveryCutAndEveryChangedByteIsAnError) {
  const std::string bytes = Gzip("what is compressed, compressed");
  for (size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(Gunzip(std::string(bytes, 0, size), 1000).ok()) << size;
  }
  // Behind the header, where time and system do not matter.
  for (size_t at = 10; at < bytes.size(); ++at) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ 1);
    const auto text = Gunzip(changed, 1000);
    EXPECT_TRUE(!text.ok()) << at;
  }
  EXPECT_THAT(Gunzip(bytes + "rest", 1000), IsInvalidWith("end here"));
}

TEST(GzipTest, ACheckpointStopsIt) {
  test::RecordingCheckpoint stop(0);
  EXPECT_TRUE(absl::IsCancelled(
      Gunzip(Gzip(std::string(1'000'000, 'x')), 1 << 20, &stop).status()));
}

TEST(GzipTest, MeshesAreReadWhereThatIsAllowed) {
  const std::string bytes = Gzip(kTriangle);
  EXPECT_THAT(ReadMesh(bytes, MeshFormat::kOff), IsInvalidWith("gzip"));
  const auto soup = ReadMesh(bytes, MeshFormat::kOff, {.max_gzip_bytes = 1000});
  ASSERT_TRUE(soup.ok()) << soup.status();
  EXPECT_EQ(soup->triangles.size(), 1);
  EXPECT_TRUE(absl::IsResourceExhausted(
      ReadMesh(bytes, MeshFormat::kOff, {.max_gzip_bytes = 10}).status()));
  // Once only.
  EXPECT_THAT(ReadMesh(Gzip(bytes), MeshFormat::kOff, {.max_gzip_bytes = 1000}),
              IsInvalidWith("gzip"));
  EXPECT_EQ(*MeshFormatFromPath("a/b.ply.GZ"), MeshFormat::kPly);
  EXPECT_FALSE(MeshFormatFromPath("b.gz").ok());
}

}  // namespace
}  // namespace geodesic
