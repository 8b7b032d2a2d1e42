#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "geodesic/read_mesh.h"
#include "tests/core/readers/soup_checks.h"

namespace geodesic {
namespace {

using test::IsInvalidWith;

TEST(MeshFormatTest, TheEndingOfAPathNamesTheFormat) {
  EXPECT_EQ(MeshFormatFromPath("horse.ply").value(), MeshFormat::kPly);
  EXPECT_EQ(MeshFormatFromPath("a/b.PLY").value(), MeshFormat::kPly);
  EXPECT_EQ(MeshFormatFromPath("a.b/c.d.obj").value(), MeshFormat::kObj);
  EXPECT_EQ(MeshFormatFromPath("x.Off").value(), MeshFormat::kOff);
  EXPECT_EQ(MeshFormatFromPath("x.STL").value(), MeshFormat::kStl);
}

TEST(MeshFormatTest, OtherPathsAreRefusedByName) {
  EXPECT_THAT(MeshFormatFromPath("mesh.gltf"), IsInvalidWith("mesh.gltf"));
  EXPECT_THAT(MeshFormatFromPath("mesh.gltf"), IsInvalidWith(".obj, .ply"));
  for (const char* path : {"", "ply", "a.ply/mesh", "mesh.", "mesh.ply.gz"}) {
    EXPECT_THAT(MeshFormatFromPath(path), IsInvalidWith("names no mesh format"))
        << path;
  }
}

TEST(MeshFormatTest, NamesLeadBackToTheFormat) {
  for (const MeshFormat format : {MeshFormat::kObj, MeshFormat::kPly,
                                  MeshFormat::kOff, MeshFormat::kStl}) {
    const std::string path = "x." + std::string(MeshFormatName(format));
    EXPECT_EQ(MeshFormatFromPath(path).value(), format);
  }
}

}  // namespace
}  // namespace geodesic
