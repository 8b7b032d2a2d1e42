// A server on a unix socket, and one that ends when nobody needs it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "geodesic_client/client.h"
#include "tests/integration/meshes.h"
#include "tests/integration/running_server.h"

namespace geodesic::client {
namespace {

using ::testing::HasSubstr;

class SocketTest : public ::testing::Test {
 protected:
  std::vector<std::string> Flags() const {
    return {"--listen", "unix:" + socket_};
  }

  // Whether a client is answered there.
  bool Answers() const {
    Client client("unix:" + socket_, {.retry = false});
    return client.ListMeshes().ok();
  }

  TemporaryFolder folder_;
  const std::string socket_ = folder_ / "a.sock";
};

TEST_F(SocketTest, IsItsUsersAloneAndGoesWithItsServer) {
  const mode_t before = umask(0);
  RunningServer server(folder_, Flags());
  umask(before);
  EXPECT_EQ(server.address(), "unix:" + socket_);
  struct stat file = {};
  ASSERT_EQ(stat(socket_.c_str(), &file), 0);
  EXPECT_TRUE(S_ISSOCK(file.st_mode));
  EXPECT_EQ(file.st_mode & 0077, 0);
  EXPECT_TRUE(Answers());
  const ProcessResult listed =
      RunProgram({GEODESIC_BINARY, "--server", server.address(), "meshes"});
  EXPECT_EQ(listed.exit_code, 0) << listed.err;
  server.Terminate();
  EXPECT_EQ(server.Wait(), 0);
  EXPECT_NE(stat(socket_.c_str(), &file), 0);
}

TEST_F(SocketTest, IsNotTakenFromAServerThatAnswers) {
  RunningServer first(folder_, Flags());
  const ProcessResult second =
      RunProgram({GEODESICD_BINARY, "--listen", "unix:" + socket_});
  EXPECT_EQ(second.exit_code, 1);
  EXPECT_THAT(second.err, HasSubstr("another server answers there"));
  EXPECT_TRUE(Answers());
}

TEST_F(SocketTest, IsTakenFromAServerThatWasKilled) {
  RunningServer first(folder_, Flags());
  first.Kill();
  EXPECT_FALSE(Answers());
  RunningServer second(folder_, Flags());
  EXPECT_TRUE(Answers());
}

TEST_F(SocketTest, OtherFilesStayInPlace) {
  WriteFile(socket_, "a file");
  const ProcessResult server =
      RunProgram({GEODESICD_BINARY, "--listen", "unix:" + socket_});
  EXPECT_EQ(server.exit_code, 1);
  EXPECT_THAT(server.err, HasSubstr("something else has that name"));
  EXPECT_EQ(FileBytes(socket_), "a file");
}

TEST(IdleExitTest, StaysWhileARequestIsInHand) {
  TemporaryFolder folder;
  RunningServer server(folder, {"--exit-when-idle", "1"});
  Client client(server.address(), {.retry = false});
  const auto upload = client.UploadArrays(HillyGrid(400));
  ASSERT_TRUE(upload.ok()) << upload.status();
  const auto field = client.ComputeField({.mesh_digest = upload->mesh.digest,
                                          .sources = {{VertexPoint{0}}},
                                          .algorithm = "ich"});
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_EQ(server.Wait(), 0);
  if (field->statistics.solve_seconds < 2) {
    GTEST_SKIP() << "this machine solves too fast to show anything";
  }
}

}  // namespace
}  // namespace geodesic::client
