// MeshService but for uploads.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <set>
#include <string>
#include <vector>

#include "server/engine/meshes/mesh_digest.h"
#include "tests/engine/uploads.h"
#include "tests/rpc/rpc_fixture.h"
#include "tests/support/curved_meshes.h"
#include "tests/support/planar_meshes.h"

namespace geodesic::server {
namespace {

using test::FieldAtFault;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string kUnknown(64, '0');

class MeshRpcTest : public test::RpcTest {
 protected:
  void SetUp() override { Start(); }

  grpc::Status GetMesh(const std::string& digest, v1::Mesh& mesh) {
    grpc::ClientContext context;
    v1::GetMeshRequest request;
    request.set_digest(digest);
    v1::GetMeshResponse response;
    const grpc::Status status = meshes_->GetMesh(&context, request, &response);
    mesh = response.mesh();
    return status;
  }
  grpc::Status DeleteMesh(const std::string& digest) {
    grpc::ClientContext context;
    v1::DeleteMeshRequest request;
    request.set_digest(digest);
    v1::DeleteMeshResponse response;
    return meshes_->DeleteMesh(&context, request, &response);
  }
  grpc::Status ReadMesh(const std::string& digest, TriangleSoup& soup) {
    grpc::ClientContext context;
    v1::ReadMeshRequest request;
    request.set_digest(digest);
    const auto reader = meshes_->ReadMesh(&context, request);
    v1::ReadMeshResponse message;
    size_t vertex = 0;
    size_t face = 0;
    bool first = true;
    while (reader->Read(&message)) {
      EXPECT_EQ(message.has_header(), first);
      first = false;
      if (message.has_header()) {
        EXPECT_EQ(message.header().digest(), digest);
        soup.positions.resize(message.header().vertex_count());
        soup.triangles.resize(message.header().face_count());
      } else if (message.has_vertices()) {
        const std::string& bytes = message.vertices().positions();
        EXPECT_EQ(message.vertices().first_vertex(), vertex);
        EXPECT_EQ(face, 0);
        std::memcpy(&soup.positions[vertex], bytes.data(), bytes.size());
        vertex += bytes.size() / sizeof(Point);
      } else {
        const std::string& bytes = message.faces().indices();
        EXPECT_EQ(message.faces().first_face(), face);
        std::memcpy(&soup.triangles[face], bytes.data(), bytes.size());
        face += bytes.size() / sizeof(Triangle);
      }
    }
    EXPECT_EQ(vertex, soup.positions.size());
    EXPECT_EQ(face, soup.triangles.size());
    return reader->Finish();
  }
};

TEST_F(MeshRpcTest, DescribesAMesh) {
  const TriangleSoup soup = geodesic::test::Torus({.around = 12, .across = 8});
  const std::string digest = Upload(soup);
  EXPECT_EQ(digest, MeshDigest(soup.positions, soup.triangles));
  v1::Mesh mesh;
  ASSERT_TRUE(GetMesh(digest, mesh).ok());
  EXPECT_EQ(mesh.digest(), digest);
  EXPECT_EQ(mesh.vertex_count(), 96);
  EXPECT_EQ(mesh.face_count(), 192);
  EXPECT_EQ(mesh.edge_count(), 288);
  EXPECT_EQ(mesh.boundary_edge_count(), 0);
  EXPECT_EQ(mesh.component_count(), 1);
  EXPECT_EQ(mesh.genus(), 1);
  EXPECT_DOUBLE_EQ(mesh.bounding_box_max().x(), 2.8);
  EXPECT_GT(mesh.saddle_vertex_count(), 0);
  EXPECT_GT(mesh.mean_edge_length(), 0);
  EXPECT_GT(mesh.anisotropy(), 1);
  EXPECT_GT(mesh.resident_bytes(), 192 * 3 * 64);
}

TEST_F(MeshRpcTest, ABookOfThreePagesHasNoGenus) {
  // Three faces along one edge.
  const TriangleSoup soup = {
      .positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
      .triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
  v1::Mesh mesh;
  const std::string digest = Upload(soup);
  ASSERT_TRUE(GetMesh(digest, mesh).ok());
  EXPECT_EQ(mesh.edge_count(), 7);
  EXPECT_FALSE(mesh.has_genus());
  // Every two of its pages unfold into one plane.
  const test::FieldReply reply = ComputeField(digest, 2);
  ASSERT_EQ(reply.distances.size(), 5);
  EXPECT_NEAR(reply.distances[3], 2, 1e-10);
  EXPECT_NEAR(reply.distances[4], 2, 1e-10);
}

TEST_F(MeshRpcTest, UnknownAndMalformedNames) {
  v1::Mesh mesh;
  TriangleSoup soup;
  const std::vector<grpc::Status> unknown = {
      GetMesh(kUnknown, mesh), DeleteMesh(kUnknown), ReadMesh(kUnknown, soup)};
  for (const grpc::Status& status : unknown) {
    EXPECT_EQ(status.error_code(), grpc::StatusCode::NOT_FOUND);
    EXPECT_THAT(status.error_message(), HasSubstr("upload it again"));
  }
  const std::vector<grpc::Status> malformed = {
      GetMesh("horse", mesh), DeleteMesh("horse"), ReadMesh("horse", soup)};
  for (const grpc::Status& status : malformed) {
    EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
    EXPECT_EQ(FieldAtFault(status), "digest");
  }
}

TEST_F(MeshRpcTest, ReadsBackWhatWasUploaded) {
  // More than one chunk of each.
  const TriangleSoup soup = geodesic::test::Icosphere(6);
  TriangleSoup read;
  ASSERT_TRUE(ReadMesh(Upload(soup), read).ok());
  EXPECT_EQ(read.positions, soup.positions);
  EXPECT_EQ(read.triangles, soup.triangles);
}

TEST_F(MeshRpcTest, ListsInPages) {
  std::set<std::string> uploaded;
  for (uint32_t columns = 1; columns <= 5; ++columns) {
    uploaded.insert(
        Upload(geodesic::test::MakeGrid({.columns = columns, .rows = 2})));
  }
  std::vector<std::string> listed;
  v1::ListMeshesRequest request;
  request.set_page_size(2);
  do {
    grpc::ClientContext context;
    v1::ListMeshesResponse response;
    ASSERT_TRUE(meshes_->ListMeshes(&context, request, &response).ok());
    EXPECT_LE(response.meshes_size(), 2);
    for (const v1::Mesh& mesh : response.meshes()) {
      listed.push_back(mesh.digest());
    }
    request.set_page_token(response.next_page_token());
  } while (!request.page_token().empty());
  EXPECT_EQ(listed, std::vector<std::string>(uploaded.begin(), uploaded.end()));
}

TEST_F(MeshRpcTest, ListChecksItsArguments) {
  v1::ListMeshesRequest request;
  v1::ListMeshesResponse response;
  {
    grpc::ClientContext context;
    request.set_page_size(-1);
    EXPECT_EQ(FieldAtFault(meshes_->ListMeshes(&context, request, &response)),
              "page_size");
  }
  grpc::ClientContext context;
  request.set_page_size(1);
  request.set_page_token("2");
  EXPECT_EQ(FieldAtFault(meshes_->ListMeshes(&context, request, &response)),
            "page_token");
}

TEST_F(MeshRpcTest, DeletedIsGone) {
  const std::string digest = Upload(test::Tetrahedron());
  EXPECT_TRUE(DeleteMesh(digest).ok());
  EXPECT_EQ(DeleteMesh(digest).error_code(), grpc::StatusCode::NOT_FOUND);
  EXPECT_EQ(ComputeField(digest, 0).status.error_code(),
            grpc::StatusCode::NOT_FOUND);
}

TEST_F(MeshRpcTest, FindMissing) {
  const std::string digest = Upload(test::Tetrahedron());
  v1::FindMissingMeshesRequest request;
  request.add_mesh_digests(kUnknown);
  request.add_mesh_digests(digest);
  v1::FileDigest& file = *request.add_files();
  file.set_format(v1::MESH_FORMAT_OBJ);
  file.set_sha256(kUnknown);
  v1::FindMissingMeshesResponse response;
  {
    grpc::ClientContext context;
    ASSERT_TRUE(meshes_->FindMissingMeshes(&context, request, &response).ok());
  }
  EXPECT_THAT(response.missing_mesh_digests(), ElementsAre(kUnknown));
  ASSERT_EQ(response.missing_files_size(), 1);
  EXPECT_EQ(response.missing_files(0).sha256(), kUnknown);
  EXPECT_EQ(response.known_files_size(), 0);

  file.set_format(v1::MESH_FORMAT_UNSPECIFIED);
  grpc::ClientContext context;
  EXPECT_EQ(
      FieldAtFault(meshes_->FindMissingMeshes(&context, request, &response)),
      "files[0].format");
}

}  // namespace
}  // namespace geodesic::server
