#include "server/engine/meshes/mesh_store.h"

#include <gtest/gtest.h>

#include <string>

#include "server/engine/meshes/mesh_digest.h"
#include "tests/engine/uploads.h"
#include "tests/support/meshes/curved_meshes.h"

namespace geodesic::server {
namespace {

// Room for one mesh of so many, and not for a tetrahedron beside it.
constexpr uint64_t kVertices = 1000;
constexpr uint64_t kFaces = 2000;
const uint64_t kRoom = Mesh::EstimateResidentBytes(kVertices, kFaces) + 512;

ResidentMesh Resident(TriangleSoup soup) {
  std::string digest = MeshDigest(soup);
  auto mesh = *Mesh::Build(std::move(soup));
  return {std::move(digest), mesh, Summarize(*mesh)};
}

MeshHandle Put(MeshStore& store, const ResidentMesh& mesh) {
  return store.Insert(mesh, *store.Reserve(4, 4)).value;
}

FileKey File(char name) { return {MeshFormat::kObj, std::string(64, name)}; }

TEST(MeshStore, ChargesWhatTheMeshTakes) {
  MeshStore store(kRoom);
  const ResidentMesh mesh = Resident(test::Tetrahedron());
  Put(store, mesh);
  EXPECT_GE(store.used_bytes(), mesh.mesh->resident_bytes());
  EXPECT_LT(store.used_bytes(), mesh.mesh->resident_bytes() + 1024);
}

TEST(MeshStore, FilesGoWithTheirMesh) {
  MeshStore store(kRoom);
  const MeshHandle mesh = Put(store, Resident(test::Tetrahedron()));
  store.AddFile(File('a'), mesh->digest);
  store.AddFile(File('b'), mesh->digest);
  EXPECT_EQ(store.FindFile(File('a')), mesh->digest);
  EXPECT_EQ(store.FindFile(File('b')), mesh->digest);
  EXPECT_EQ(store.FindFile(File('c')), std::nullopt);
  // The same bytes in another format are another file.
  EXPECT_EQ(store.FindFile({MeshFormat::kStl, File('a').sha256, {}}),
            std::nullopt);
  EXPECT_TRUE(store.Erase(mesh->digest).ok());
  EXPECT_EQ(store.FindFile(File('a')), std::nullopt);
  EXPECT_EQ(store.FindFile(File('b')), std::nullopt);
}

TEST(MeshStore, FilesGoWhenTheirMeshIsEvicted) {
  MeshStore store(kRoom);
  const std::string digest = Put(store, Resident(test::Tetrahedron()))->digest;
  store.AddFile(File('a'), digest);
  ASSERT_TRUE(store.Reserve(kVertices, kFaces).ok());
  EXPECT_EQ(store.Find(digest), nullptr);
  EXPECT_EQ(store.FindFile(File('a')), std::nullopt);
}

TEST(MeshStore, AMeshRemembersItsLatestFiles) {
  MeshStore store(kRoom);
  const std::string digest = Put(store, Resident(test::Tetrahedron()))->digest;
  for (char name = 'a'; name <= 'z'; ++name) store.AddFile(File(name), digest);
  EXPECT_EQ(store.FindFile(File('a')), std::nullopt);
  EXPECT_EQ(store.FindFile(File('z')), digest);
}

TEST(MeshStore, AFileOfAMeshThatIsGoneIsForgotten) {
  MeshStore store(kRoom);
  const std::string digest = Put(store, Resident(test::Tetrahedron()))->digest;
  ASSERT_TRUE(store.Erase(digest).ok());
  store.AddFile(File('a'), digest);
  EXPECT_EQ(store.FindFile(File('a')), std::nullopt);
}

}  // namespace
}  // namespace geodesic::server
