#include "server/engine/meshes/mesh_digest.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "digest/sha256.h"

namespace geodesic::server {
namespace {

// FIPS 180-4's own examples.
TEST(Sha256, KnownAnswers) {
  EXPECT_EQ(Sha256().FinishHex(),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  Sha256 hash;
  hash.Update("a");
  hash.Update("");
  hash.Update("bc");
  EXPECT_EQ(hash.FinishHex(),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Sha256, RecognisesItsOwnHex) {
  const std::string digest = Sha256().FinishHex();
  EXPECT_TRUE(IsSha256Hex(digest));
  EXPECT_FALSE(IsSha256Hex(""));
  EXPECT_FALSE(IsSha256Hex(digest.substr(1)));
  EXPECT_FALSE(IsSha256Hex(digest + "0"));
  for (const char wrong : {'E', 'g', '/', ':', '\0'}) {
    std::string other = digest;
    other[17] = wrong;
    EXPECT_FALSE(IsSha256Hex(other)) << wrong;
  }
}

const std::vector<Point> kPositions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
const std::vector<Triangle> kTriangles = {{0, 1, 2}};

// The value was computed outside of this program, with Python:
//   hashlib.sha256(b"geodesic.mesh.v1\n" + struct.pack("<2Q", 3, 1)
//       + struct.pack("<9d", 0,0,0, 1,0,0, 0,1,0)
//       + struct.pack("<3I", 0,1,2)).hexdigest()
TEST(MeshDigest, IsTheOneTheProtocolDefines) {
  EXPECT_EQ(MeshDigest({.positions = kPositions, .triangles = kTriangles}),
            "4538d0d0eb2a08471aab3a00e597e36252b1ea05f74234051eabd46ee6a8b4ba");
}

TEST(MeshDigest, TellsMeshesApart) {
  const std::string digest =
      MeshDigest({.positions = kPositions, .triangles = kTriangles});
  std::vector<Point> moved = kPositions;
  moved[2][1] = 1.0000000000000002;
  EXPECT_NE(MeshDigest({.positions = moved, .triangles = kTriangles}), digest);
  const std::vector<Triangle> turned = {{1, 2, 0}};
  EXPECT_NE(MeshDigest({.positions = kPositions, .triangles = turned}), digest);
  EXPECT_NE(MeshDigest({.positions = kPositions, .triangles = {}}), digest);
  EXPECT_NE(MeshDigest({.positions = kPositions,
                        .triangles = kTriangles,
                        .reading = {.seam_edges = 1}}),
            digest);
}

}  // namespace
}  // namespace geodesic::server
