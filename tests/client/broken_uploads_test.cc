// Uploads that break: the client sends them again, as a whole.

#include <grpcpp/server.h>
#include <grpcpp/server_builder.h>
#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "geodesic/v1/mesh_service.grpc.pb.h"
#include "geodesic_client/client.h"
#include "tests/client/scripted_service.h"
#include "tests/client/temporary_folder.h"

namespace geodesic::client {
namespace {

// Has forgotten each mesh that it says it knows, and breaks each first upload.
class ForgetfulService final : public v1::MeshService::Service {
 public:
  using Context = grpc::ServerContext;
  grpc::Status FindMissingMeshes(
      Context*, const v1::FindMissingMeshesRequest*,
      v1::FindMissingMeshesResponse* response) override {
    response->add_known_files()->set_mesh_digest("forgotten");
    return grpc::Status::OK;
  }
  grpc::Status GetMesh(Context*, const v1::GetMeshRequest*,
                       v1::GetMeshResponse*) override {
    return {grpc::StatusCode::NOT_FOUND, "it is gone"};
  }
  grpc::Status CreateMesh(Context*,
                          grpc::ServerReader<v1::CreateMeshRequest>* reader,
                          v1::CreateMeshResponse*) override {
    std::string& bytes = uploads.emplace_back();
    v1::CreateMeshRequest request;
    while (reader->Read(&request))
      absl::StrAppend(&bytes, request.chunk().data());
    return uploads.size() % 2 == 1 ? Broken() : grpc::Status::OK;
  }

  std::vector<std::string> uploads;
};

TEST(BrokenUploadTest, IsSentAgainAsAWhole) {
  ForgetfulService service;
  int port = 0;
  grpc::ServerBuilder builder;
  builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(),
                           &port);
  builder.RegisterService(&service);
  const std::unique_ptr<grpc::Server> server = builder.BuildAndStart();
  ASSERT_NE(server, nullptr);
  Client client(absl::StrCat("127.0.0.1:", port));

  const TemporaryFolder folder;
  const std::string text(3'000'000, '#');  // several chunks
  WriteFile(folder / "mesh.obj", text);
  EXPECT_TRUE(client.UploadFile(folder / "mesh.obj").ok());
  EXPECT_EQ(service.uploads, std::vector<std::string>(2, text));

  service.uploads.clear();
  const MeshArrays arrays = {.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                             .triangles = {{0, 1, 2}}};
  std::string bytes(sizeof(Point) * 3 + sizeof(Triangle), '\0');
  std::memcpy(bytes.data(), arrays.positions.data(), sizeof(Point) * 3);
  std::memcpy(bytes.data() + sizeof(Point) * 3, arrays.triangles.data(),
              sizeof(Triangle));
  EXPECT_TRUE(client.UploadArrays(arrays).ok());
  EXPECT_EQ(service.uploads, std::vector<std::string>(2, bytes));
}

}  // namespace
}  // namespace geodesic::client
