// Every file of the test meshes that lie outside the project, against what an
// independent reader saw in them (INDEX.tsv).

#include "tests/support/meshes/test_meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/read_mesh.h"
#include "tests/core/readers/soup_checks.h"
#include "tests/support/temporary_folder.h"

namespace geodesic {
namespace {

using test::ExpectSound;

struct Row {
  std::string file;
  uint64_t vertices = 0;
  uint64_t faces = 0;
};

std::vector<Row> ReadIndex() {
  std::vector<Row> rows;
  std::ifstream index(test::TestMeshFolder() / "INDEX.tsv");
  std::string line;
  std::getline(index, line);  // the names of the columns
  while (std::getline(index, line)) {
    Row row;
    std::istringstream fields(line);
    std::getline(fields, row.file, '\t');
    fields >> row.vertices >> row.faces;
    EXPECT_TRUE(fields) << line;
    rows.push_back(row);
  }
  return rows;
}

// Files that the independent reader took, wholly or in part, and this one
// refuses: part of the message.
const std::map<std::string, std::string>& Refused() {
  static const auto& kRefused = *new std::map<std::string, std::string>{
      // It stopped at 3.1 and ignored +e2. A misspelt coordinate is no place
      // to guess.
      {"hostile/assimp_number_formats.obj",
       "line 11: vertex 7: '3.1+e2' is not a finite number"},
      // It dropped the face.
      {"hostile/made_index_out_of_range.off",
       "line 10: face 3 names vertex 99"},
      // It passed the NaN on.
      {"hostile/made_nan_binary.ply", "vertex 3: coordinate y is not a finite"},
      // It read strips.
      {"hostile/meshlab_brain.ply",
       "line 7: triangle strips are not supported"},
      // It dropped the faces with fewer than three corners.
      {"hostile/tinyobj_invalid-face-definition.obj",
       "line 15: face 0 has 1 corners"},
      // It read the rows as one stream of numbers and so found 3,907 faces in
      // a file of 1,000, whose rows hold a list the header declares as scalars.
      {"hostile/trimesh_fuze_ascii.ply",
       "line 523: face 0: '1' is more than the header declares"},
  };
  return kRefused;
}

// Files that the independent reader could not read, and this one can.
const std::map<std::string, Row>& Read() {
  static const auto& kRead = *new std::map<std::string, Row>{
      // Lines that end in CR alone.
      {"hostile/made_cr_only.off", {.vertices = 4, .faces = 4}},
  };
  return kRead;
}

class TestMeshesTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(test::TestMeshFolder() / "INDEX.tsv")) {
      GTEST_SKIP() << "no meshes in " << test::TestMeshFolder();
    }
  }
};

void CheckRow(Row row) {
  SCOPED_TRACE(row.file);
  std::filesystem::path name = row.file;
  if (name.extension() == ".zip") name = name.stem();
  const absl::StatusOr<MeshFormat> format = MeshFormatFromPath(name.string());
  ASSERT_TRUE(format.ok()) << format.status();
  const absl::StatusOr<TriangleSoup> soup =
      ReadMesh(test::FileBytes(test::TestMeshFolder() / row.file), *format);
  if (soup.ok()) {
    ExpectSound(*soup);
  } else {
    EXPECT_TRUE(absl::IsInvalidArgument(soup.status())) << soup.status();
  }
  if (const auto refused = Refused().find(row.file);
      refused != Refused().end()) {
    EXPECT_THAT(soup, test::IsInvalidWith(refused->second));
    return;
  }
  if (const auto read = Read().find(row.file); read != Read().end()) {
    row = read->second;
  } else if (row.vertices == 0 && row.faces == 0) {
    // Broken or without content.
    EXPECT_TRUE(!soup.ok() || soup->triangles.empty());
    return;
  }
  ASSERT_TRUE(soup.ok()) << soup.status();
  // Parts of an STL file that touch in a point have vertices of their own
  // there.
  EXPECT_EQ(
      *format == MeshFormat::kStl
          ? std::set(soup->positions.begin(), soup->positions.end()).size()
          : soup->positions.size(),
      row.vertices);
  EXPECT_EQ(soup->triangles.size(), row.faces);
}

TEST_F(TestMeshesTest, EveryFileIsReadOrRefusedAsItShould) {
  const std::vector<Row> rows = ReadIndex();
  EXPECT_GT(rows.size(), 100u);
  for (const Row& row : rows) CheckRow(row);
}

TEST_F(TestMeshesTest, NoHostileFileReadsPastItsTruncatedEnd) {
  for (const Row& row : ReadIndex()) {
    if (!row.file.starts_with("hostile/")) continue;
    const std::string bytes =
        test::FileBytes(test::TestMeshFolder() / row.file);
    if (bytes.size() > 20000) continue;
    for (const MeshFormat format : {MeshFormat::kObj, MeshFormat::kPly,
                                    MeshFormat::kOff, MeshFormat::kStl}) {
      const size_t step = 1 + bytes.size() / 100;
      for (size_t size = 0; size < bytes.size(); size += step) {
        const std::string start(bytes, 0, size);
        const absl::StatusOr<TriangleSoup> soup = ReadMesh(start, format);
        if (soup.ok()) ExpectSound(*soup);
      }
    }
  }
}

}  // namespace
}  // namespace geodesic
