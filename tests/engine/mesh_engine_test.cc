// The part of QueryEngine that deals with meshes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "digest/sha256.h"
#include "geodesic_types/field_path.h"
#include "server/engine/meshes/mesh_digest.h"
#include "tests/engine/engine_fixture.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/planar_meshes.h"

namespace geodesic::server {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

using MeshEngineTest = test::EngineTest;

TEST_F(MeshEngineTest, AnUploadBecomesResident) {
  const TriangleSoup soup = geodesic::test::Icosphere(1);
  const auto uploaded = Upload(soup).value();
  EXPECT_FALSE(uploaded.already_resident);
  EXPECT_EQ(uploaded.mesh.digest, MeshDigest(soup));
  EXPECT_EQ(uploaded.mesh.summary.faces, 80);
  EXPECT_EQ((*engine_.meshes().Get(uploaded.mesh.digest))->digest,
            uploaded.mesh.digest);
  EXPECT_GT(uploaded.mesh.resident_bytes, 0);
  EXPECT_EQ(uploaded.mesh.stored_bytes, 0);
}

TEST_F(MeshEngineTest, TheSameMeshInAnotherFormatIsTheSameMesh) {
  const auto arrays = Upload(test::Tetrahedron()).value();
  const auto off =
      Upload(test::TetrahedronOffHeader(), test::kTetrahedronOff).value();
  EXPECT_TRUE(off.already_resident);
  EXPECT_EQ(off.mesh.digest, arrays.mesh.digest);
  EXPECT_EQ(engine_.counters().meshes_built, 1);
}

TEST_F(MeshEngineTest, AKnownFileIsNotParsedAgain) {
  ASSERT_TRUE(Upload(test::TetrahedronOffHeader(), test::kTetrahedronOff).ok());
  auto upload = *engine_.meshes().StartUpload(test::TetrahedronOffHeader());
  ASSERT_TRUE(upload->Append(0, test::kTetrahedronOff).ok());
  absl::StatusOr<UploadResult> result = absl::UnknownError("not called");
  const auto job = engine_.meshes().FinishUpload(
      std::move(upload), [&](const auto& r) { result = r; });
  ASSERT_TRUE(job.ok());
  EXPECT_EQ(job->entry, nullptr);
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(result->already_resident);
}

// 4 vertices and 4 faces take as many bytes as 3 vertices and 6 faces.
TEST_F(MeshEngineTest, EqualBytesOfArraysMayBeOtherMeshes) {
  const std::string bytes = test::ArrayBytes(test::Tetrahedron());
  UploadHeader header = test::ArrayHeader(test::Tetrahedron());
  ASSERT_TRUE(Upload(header, bytes).ok());
  header.vertex_count = 3;
  header.face_count = 6;
  EXPECT_TRUE(absl::IsInvalidArgument(Upload(header, bytes).status()));

  // Nor are they a file that could be asked for.
  const FileKey file = {kArrays, Sha256Hex(bytes)};
  EXPECT_THAT(engine_.meshes().FindMissing({}, {file})->files,
              ElementsAre(file));
}

TEST_F(MeshEngineTest, ExpectedDigestsAreChecked) {
  const TriangleSoup soup = test::Tetrahedron();
  UploadHeader header = test::ArrayHeader(soup);
  header.expected_digest = std::string(64, '0');
  const absl::Status status = Upload(header, test::ArrayBytes(soup)).status();
  EXPECT_TRUE(absl::IsInvalidArgument(status));
  EXPECT_EQ(FieldPathOf(status), "header.expected_digest");
  EXPECT_EQ(engine_.meshes().store().used_bytes(), 0);

  header.expected_digest = MeshDigest(soup);
  ASSERT_TRUE(Upload(header, test::ArrayBytes(soup)).ok());

  // Nor does the shortcut for known files overlook it.
  UploadHeader off = test::TetrahedronOffHeader();
  ASSERT_TRUE(Upload(off, test::kTetrahedronOff).ok());
  off.expected_digest = std::string(64, '0');
  EXPECT_TRUE(
      absl::IsInvalidArgument(Upload(off, test::kTetrahedronOff).status()));
}

TEST_F(MeshEngineTest, ARefusedMeshLeavesNothingBehind) {
  TriangleSoup soup = test::Tetrahedron();
  soup.triangles[2] = {0, 3, 77};
  const absl::Status status = Upload(soup).status();
  EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr("77"));
  EXPECT_EQ(FieldPathOf(status), "chunk.data");
  EXPECT_EQ(engine_.meshes().store().used_bytes(), 0);
}

TEST_F(MeshEngineTest, FindMissingTellsWhatToUpload) {
  const std::string digest = Upload(test::Tetrahedron())->mesh.digest;
  ASSERT_TRUE(Upload(test::TetrahedronOffHeader(), test::kTetrahedronOff).ok());
  const FileKey known = {MeshFormat::kOff, Sha256Hex(test::kTetrahedronOff)};
  const FileKey unknown = {MeshFormat::kOff, Sha256Hex("something else")};
  const std::string other(64, '0');

  const auto missing =
      engine_.meshes().FindMissing({other, digest}, {unknown, known}).value();
  EXPECT_THAT(missing.mesh_digests, ElementsAre(other));
  EXPECT_THAT(missing.files, ElementsAre(unknown));
  ASSERT_EQ(missing.known_files.size(), 1);
  EXPECT_EQ(missing.known_files[0].file, known);
  EXPECT_EQ(missing.known_files[0].mesh_digest, digest);
}

TEST_F(MeshEngineTest, FindMissingChecksItsArguments) {
  const std::string good(64, '0');
  const absl::Status digest =
      engine_.meshes().FindMissing({good, "x"}, {}).status();
  EXPECT_EQ(FieldPathOf(digest), "mesh_digests[1]");
  const absl::Status file =
      engine_.meshes().FindMissing({}, {{MeshFormat::kObj, "X"}}).status();
  EXPECT_EQ(FieldPathOf(file), "files[0].sha256");
  EXPECT_TRUE(engine_.meshes()
                  .FindMissing(std::vector<std::string>(1000, good), {})
                  .ok());
  EXPECT_TRUE(absl::IsInvalidArgument(
      engine_.meshes()
          .FindMissing(std::vector<std::string>(1001, good), {})
          .status()));
}

TEST_F(MeshEngineTest, ListsInPages) {
  std::vector<std::string> digests;
  for (uint32_t columns = 1; columns <= 5; ++columns) {
    digests.push_back(
        Upload(geodesic::test::MakeGrid({.columns = columns, .rows = 1}))
            ->mesh.digest);
  }
  std::sort(digests.begin(), digests.end());

  std::vector<std::string> listed;
  std::string token;
  int pages = 0;
  do {
    const auto page = engine_.meshes().List(2, token).value();
    for (const MeshDescription& mesh : page.meshes) {
      listed.push_back(mesh.digest);
    }
    token = page.next_token;
    ++pages;
  } while (!token.empty());
  EXPECT_EQ(listed, digests);
  EXPECT_EQ(pages, 3);
  EXPECT_EQ(engine_.meshes().List(0, "")->meshes.size(), 5);
  EXPECT_EQ(engine_.meshes().List(5, "")->next_token, "");
}

TEST_F(MeshEngineTest, ListChecksItsArguments) {
  EXPECT_EQ(FieldPathOf(engine_.meshes().List(-1, "").status()), "page_size");
  EXPECT_EQ(FieldPathOf(engine_.meshes().List(1, "x").status()), "page_token");
}

}  // namespace
}  // namespace geodesic::server
