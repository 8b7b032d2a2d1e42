#include "geodesic/mesh_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "absl/status/status.h"
#include "geodesic/solve.h"
#include "tests/support/temporary_folder.h"

namespace geodesic {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class MeshFileTest : public ::testing::Test {
 protected:
  // The path of a file with this content.
  std::string File(const std::string& name, const std::string& content) {
    test::WriteFile(folder_ / name, content);
    return folder_ / name;
  }

  test::TemporaryFolder folder_;
};

// A triangle with legs 3 and 4.
constexpr char kTriangle[] = "OFF\n3 1 0\n0 0 0\n3 0 0\n0 4 0\n3 0 1 2\n";

TEST_F(MeshFileTest, ReadsAndSolvesInThreeLines) {
  const auto mesh = ReadMeshFile(File("triangle.off", kTriangle));
  ASSERT_TRUE(mesh.ok()) << mesh.status();
  const auto field = Solve(**mesh, {.sources = {{VertexPoint{1}}}});
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_THAT(field->distances, ElementsAre(3, 0, 5));
}

TEST_F(MeshFileTest, LongFilesAreReadWhole) {
  // Longer than a block of reading, and no multiple of it.
  const std::string comment(3'000'001, '#');
  const auto mesh = ReadMeshFile(File("long.off", kTriangle + comment + "\n"));
  ASSERT_TRUE(mesh.ok()) << mesh.status();
  const absl::Status cut =
      ReadMeshFile(File("cut.off", "OFF\n" + comment + "\n3 1 0\n0 0 0\n"))
          .status();
  EXPECT_EQ(cut.code(), absl::StatusCode::kInvalidArgument) << cut;
}

TEST_F(MeshFileTest, ErrorsNameTheFile) {
  const std::string missing = folder_ / "missing.ply";
  EXPECT_EQ(ReadMeshFile(missing).status().code(), absl::StatusCode::kNotFound);
  EXPECT_THAT(ReadMeshFile(missing).status().message(), HasSubstr(missing));

  const std::string folder = folder_ / "folder.ply";
  std::filesystem::create_directory(folder);
  const absl::Status no_file = ReadMeshFile(folder).status();
  EXPECT_FALSE(no_file.ok());
  EXPECT_THAT(no_file.message(), HasSubstr(folder));

  const std::string bad = File("bad.off", "OFF\n1 1 0\n0 0 0\n3 0 1 2\n");
  const absl::Status malformed = ReadMeshFile(bad).status();
  EXPECT_EQ(malformed.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(malformed.message(), HasSubstr(bad + ": line 4"));
}

TEST_F(MeshFileTest, LimitsHold) {
  EXPECT_EQ(ReadMeshFile(File("triangle.off", kTriangle), {.max_vertices = 2})
                .status()
                .code(),
            absl::StatusCode::kResourceExhausted);
}

}  // namespace
}  // namespace geodesic
