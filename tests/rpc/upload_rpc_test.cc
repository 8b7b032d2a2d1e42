// MeshService.CreateMesh, and what it does with those who break its protocol.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "absl/strings/ascii.h"
#include "digest/sha256.h"
#include "geodesic/read_mesh.h"
#include "tests/engine/uploads.h"
#include "tests/rpc/rpc_fixture.h"
#include "tests/support/curved_meshes.h"
#include "tests/support/test_meshes.h"

namespace geodesic::server {
namespace {

using test::FieldAtFault;
using ::testing::HasSubstr;

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

TEST_F(UploadRpcTest, AFileAndThenTheSameFileAgain) {
  const std::string bytes = test::kTetrahedronOff;
  v1::UploadHeader header;
  header.set_format(v1::MESH_FORMAT_OFF);
  header.set_size_bytes(bytes.size());
  v1::CreateMeshResponse first;
  ASSERT_TRUE(Upload(header, bytes, first).ok());
  EXPECT_FALSE(first.already_resident());
  EXPECT_EQ(first.mesh().face_count(), 4);
  v1::CreateMeshResponse second;
  ASSERT_TRUE(Upload(header, bytes, second).ok());
  EXPECT_TRUE(second.already_resident());
  EXPECT_EQ(second.mesh().digest(), first.mesh().digest());

  // A client that cannot parse may now ask for it by the file.
  Sha256 hash;
  hash.Update(bytes);
  v1::FindMissingMeshesRequest request;
  request.add_files()->set_format(v1::MESH_FORMAT_OFF);
  request.mutable_files(0)->set_sha256(hash.FinishHex());
  v1::FindMissingMeshesResponse response;
  grpc::ClientContext context;
  ASSERT_TRUE(meshes_->FindMissingMeshes(&context, request, &response).ok());
  ASSERT_EQ(response.known_files_size(), 1);
  EXPECT_EQ(response.known_files(0).mesh_digest(), first.mesh().digest());
}

TEST_F(UploadRpcTest, StreamsThatBreakTheProtocol) {
  const auto obj = v1::MESH_FORMAT_OBJ;
  ExpectInvalid({}, "header");
  ExpectInvalid({Chunk(0, "abc")}, "header");
  ExpectInvalid({Header(obj, 3), Header(obj, 3)}, "header");
  ExpectInvalid({v1::CreateMeshRequest()}, "part");
  ExpectInvalid({Header(obj, 3), v1::CreateMeshRequest()}, "part");
  ExpectInvalid({Header(obj, 6), Chunk(0, "abc"), Chunk(2, "def")},
                "chunk.offset");
  ExpectInvalid({Header(obj, 6), Chunk(3, "def")}, "chunk.offset");
  ExpectInvalid({Header(obj, 2), Chunk(0, "abc")}, "chunk.data");
  ExpectInvalid({Header(obj, 4), Chunk(0, "abc")}, "header.size_bytes");
  ExpectInvalid({Header(obj, 0)}, "header.size_bytes");
  ExpectInvalid({Header(v1::MESH_FORMAT_UNSPECIFIED, 3), Chunk(0, "abc")},
                "header.format");
  ExpectInvalid({Header(static_cast<v1::MeshFormat>(77), 3), Chunk(0, "abc")},
                "header.format");
}

TEST_F(UploadRpcTest, BadContent) {
  const std::string zero = "v 0 0 zero\n";
  ExpectInvalid({Header(v1::MESH_FORMAT_OBJ, zero.size()), Chunk(0, zero)},
                "chunk.data");
  const std::string index = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n";
  ExpectInvalid({Header(v1::MESH_FORMAT_OBJ, index.size()), Chunk(0, index)},
                "chunk.data");
  // No face at all.
  ExpectInvalid({Header(v1::MESH_FORMAT_OBJ, 8), Chunk(0, "v 0 0 0\n")},
                "chunk.data");
}

TEST_F(UploadRpcTest, AnUnexpectedDigest) {
  const std::string bytes = test::kTetrahedronOff;
  v1::CreateMeshRequest header = Header(v1::MESH_FORMAT_OFF, bytes.size());
  header.mutable_header()->set_expected_digest(std::string(64, '0'));
  ExpectInvalid({header, Chunk(0, bytes)}, "header.expected_digest");
}

TEST_F(UploadRpcTest, TooLarge) {
  const grpc::Status status =
      Send({Header(v1::MESH_FORMAT_OBJ, uint64_t{1} << 40)});
  EXPECT_EQ(status.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_THAT(status.error_message(), HasSubstr("max_upload_bytes"));
  // Waiting would not help.
  EXPECT_FALSE(test::RetryInfo(status).has_value());
}

TEST_F(UploadRpcTest, ManyChunks) {
  const TriangleSoup soup = geodesic::test::Icosphere(6);
  const std::string digest = Upload(soup);
  EXPECT_EQ(digest.size(), 64);
  // A second time the arrays are known by their bytes.
  EXPECT_EQ(Upload(soup), digest);
  EXPECT_EQ(server_->engine().counters().meshes_built, 1);
}

// MESH_FORMAT_OBJ for ".obj".
v1::MeshFormat FormatOf(const std::filesystem::path& extension) {
  v1::MeshFormat format = v1::MESH_FORMAT_UNSPECIFIED;
  const std::string name = extension.string().substr(1);
  v1::MeshFormat_Parse("MESH_FORMAT_" + absl::AsciiStrToUpper(name), &format);
  return format;
}

// Each file becomes a mesh that can be asked, or is refused with a reason; the
// server is there afterwards.
TEST_F(UploadRpcTest, HostileFiles) {
  const auto folder = geodesic::test::TestMeshFolder() / "hostile";
  if (!std::filesystem::is_directory(folder)) {
    GTEST_SKIP() << "no folder " << folder;
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path());
    if (!MeshFormatFromPath(entry.path().string()).ok()) continue;
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(file)),
                            std::istreambuf_iterator<char>());
    v1::UploadHeader header;
    header.set_format(FormatOf(entry.path().extension()));
    header.set_size_bytes(bytes.size());
    v1::CreateMeshResponse response;
    const grpc::Status status = Upload(header, bytes, response);
    if (!status.ok()) {
      EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
      EXPECT_FALSE(status.error_message().empty());
      EXPECT_FALSE(FieldAtFault(status).empty());
      continue;
    }
    const test::FieldReply reply = ComputeField(response.mesh().digest(), 0);
    EXPECT_TRUE(reply.status.ok()) << reply.status.error_message();
    ASSERT_EQ(reply.distances.size(), response.mesh().vertex_count());
    EXPECT_EQ(reply.distances[0], 0);
  }
  EXPECT_FALSE(Upload(test::Tetrahedron()).empty());
}

}  // namespace
}  // namespace geodesic::server
