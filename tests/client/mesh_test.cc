#include "geodesic_client/mesh.h"

#include <gtest/gtest.h>

#include "geodesic_client/field.h"

namespace geodesic::client {
namespace {

// Computed with Python's hashlib and struct from the definition in mesh.proto.
TEST(MeshDigestTest, IsTheOneTheProtocolDefines) {
  EXPECT_EQ(MeshDigest({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}),
            "4538d0d0eb2a08471aab3a00e597e36252b1ea05f74234051eabd46ee6a8b4ba");
  EXPECT_EQ(MeshDigest({}),
            "6687583eb49f1b9c0b6274258375ab8a8e87365b820ab336b7fb2cf23264c2fc");
}

TEST(MeshDigestTest, HasTheFormOfADigest) {
  EXPECT_TRUE(IsMeshDigest(MeshDigest({})));
  EXPECT_FALSE(IsMeshDigest(""));
  EXPECT_FALSE(IsMeshDigest(std::string(64, 'G')));
  EXPECT_FALSE(IsMeshDigest(std::string(64, 'A')));
  EXPECT_FALSE(IsMeshDigest(std::string(63, 'a')));
  EXPECT_TRUE(IsMeshDigest(std::string(64, 'a')));
}

TEST(MeshFormatTest, FollowsFromTheEnding) {
  EXPECT_EQ(*MeshFormatFromPath("a.obj"), MeshFormat::kObj);
  EXPECT_EQ(*MeshFormatFromPath("/a.off/b.PLY"), MeshFormat::kPly);
  EXPECT_EQ(*MeshFormatFromPath("./x.y.off"), MeshFormat::kOff);
  EXPECT_EQ(*MeshFormatFromPath("A.Stl"), MeshFormat::kStl);
}

TEST(MeshFormatTest, OtherEndingsAreRefusedByName) {
  for (const char* path : {"", "obj", "a.obj/b", "a.gltf", "a.obj.", "a.ob"}) {
    absl::Status status = MeshFormatFromPath(path).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << path;
    EXPECT_NE(status.message().find(path), absl::string_view::npos);
    EXPECT_NE(status.message().find(".ply"), absl::string_view::npos);
  }
}

TEST(AlgorithmNamesTest, AreThoseOfTheProtocol) {
  EXPECT_EQ(AlgorithmNames(),
            (std::vector<std::string>{"fwp-ch", "fwp-mmp", "ich", "mmp", "ch",
                                      "lc-mmp", "lc-ch", "fwp-list"}));
}

}  // namespace
}  // namespace geodesic::client
