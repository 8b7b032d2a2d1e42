// MeshService.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "server/engine/meshes/mesh_digest.h"
#include "tests/engine/uploads.h"
#include "tests/rpc/rpc_fixture.h"
#include "tests/support/meshes/curved_meshes.h"

namespace geodesic::server {
namespace {

using test::FieldAtFault;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string kUnknown(64, '0');

class MeshRpcTest : public test::RpcTest {
 protected:
  void SetUp() override { Start(); }

  grpc::Status ReadMesh(const std::string& digest) {
    grpc::ClientContext context;
    v1::ReadMeshRequest request;
    request.set_digest(digest);
    const auto reader = meshes_->ReadMesh(&context, request);
    v1::ReadMeshResponse message;
    EXPECT_FALSE(reader->Read(&message));
    return reader->Finish();
  }
};

TEST_F(MeshRpcTest, DescribesAMesh) {
  const TriangleSoup soup = geodesic::test::Torus({.around = 12, .across = 8});
  const std::string digest = Upload(soup);
  EXPECT_EQ(digest, MeshDigest(soup));
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

TEST_F(MeshRpcTest, UnknownAndMalformedNames) {
  v1::Mesh mesh;
  const std::vector<grpc::Status> unknown = {
      GetMesh(kUnknown, mesh), DeleteMesh(kUnknown), ReadMesh(kUnknown)};
  for (const grpc::Status& status : unknown) {
    EXPECT_EQ(status.error_code(), grpc::StatusCode::NOT_FOUND);
    EXPECT_THAT(status.error_message(), HasSubstr("upload it again"));
  }
  const std::vector<grpc::Status> malformed = {
      GetMesh("horse", mesh), DeleteMesh("horse"), ReadMesh("horse")};
  for (const grpc::Status& status : malformed) {
    EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
    EXPECT_EQ(FieldAtFault(status), "digest");
  }
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

// CreateMesh, and those who break its protocol.
class UploadRpcTest : public test::RpcTest {
 protected:
  void SetUp() override { Start(); }

  static v1::CreateMeshRequest Header(v1::MeshFormat format, uint64_t size) {
    v1::CreateMeshRequest message;
    message.mutable_header()->set_format(format);
    message.mutable_header()->set_size_bytes(size);
    return message;
  }
  static v1::CreateMeshRequest Chunk(uint64_t offset, const std::string& data) {
    v1::CreateMeshRequest message;
    message.mutable_chunk()->set_offset(offset);
    message.mutable_chunk()->set_data(data);
    return message;
  }

  grpc::Status Send(const std::vector<v1::CreateMeshRequest>& messages) {
    grpc::ClientContext context;
    v1::CreateMeshResponse response;
    const auto writer = meshes_->CreateMesh(&context, &response);
    for (const v1::CreateMeshRequest& message : messages) {
      if (!writer->Write(message)) break;
    }
    writer->WritesDone();
    return writer->Finish();
  }

  void ExpectInvalid(const std::vector<v1::CreateMeshRequest>& messages,
                     const std::string& field) {
    const grpc::Status status = Send(messages);
    EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT)
        << status.error_message();
    EXPECT_EQ(FieldAtFault(status), field);
    // The server serves on.
    EXPECT_FALSE(Upload(test::Tetrahedron()).empty());
  }
};

TEST_F(UploadRpcTest, StreamsThatBreakTheProtocol) {
  const auto obj = v1::MESH_FORMAT_OBJ;
  ExpectInvalid({}, "header");
  ExpectInvalid({Chunk(0, "abc")}, "header");
  ExpectInvalid({Header(obj, 3), Header(obj, 3)}, "header");
  ExpectInvalid({v1::CreateMeshRequest()}, "part");
  ExpectInvalid({Header(obj, 3), v1::CreateMeshRequest()}, "part");
  ExpectInvalid({Header(obj, 6), Chunk(0, "abc"), Chunk(2, "def")},
                "chunk.offset");
  ExpectInvalid({Header(obj, 4), Chunk(0, "abc")}, "header.size_bytes");
  ExpectInvalid({Header(v1::MESH_FORMAT_UNSPECIFIED, 3), Chunk(0, "abc")},
                "header.format");
  ExpectInvalid({Header(static_cast<v1::MeshFormat>(77), 3), Chunk(0, "abc")},
                "header.format");
  ExpectInvalid({Header(obj, 8), Chunk(0, "v 0 zero")}, "chunk.data");
  const std::string tetrahedron = test::kTetrahedronOff;
  v1::CreateMeshRequest header =
      Header(v1::MESH_FORMAT_OFF, tetrahedron.size());
  header.mutable_header()->set_expected_digest(kUnknown);
  ExpectInvalid({header, Chunk(0, tetrahedron)}, "header.expected_digest");
}

}  // namespace
}  // namespace geodesic::server
