// SIGTERM: what is under way ends, what is new is refused.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string>

#include "geodesic_client/client.h"
#include "tests/integration/meshes.h"
#include "tests/integration/running_server.h"

namespace geodesic::client {
namespace {

TEST(ShutdownTest, IdleServerStopsInOrder) {
  TemporaryFolder folder;
  RunningServer server(folder);
  Client client(server.address());
  ASSERT_TRUE(client.ListMeshes().ok());
  server.Terminate();
  EXPECT_EQ(server.Wait(), 0);
  EXPECT_TRUE(absl::IsUnavailable(client.ListMeshes().status()));
}

// A field whose server is asked to stop once its solver reports.
absl::StatusOr<Field> AskAndTerminate(const RunningServer& server,
                                      const MeshArrays& mesh) {
  // It does not come back, so nobody is to wait for it.
  Client client(server.address(), {.retry = false});
  absl::StatusOr<UploadOutcome> upload = client.UploadArrays(mesh);
  if (!upload.ok()) return upload.status();
  bool terminated = false;
  absl::StatusOr<Field> field =
      client.ComputeField({.mesh_digest = upload->mesh.digest,
                           .sources = {{VertexPoint{0}}},
                           .algorithm = "ich"},
                          {}, [&](const SolveProgress&) {
                            if (!terminated) server.Terminate();
                            terminated = true;
                          });
  EXPECT_TRUE(terminated) << "the solver had ended before it reported";
  return field;
}

TEST(ShutdownTest, NobodyNeedsToReadTheLog) {
  TemporaryFolder folder;
  const std::string log = folder / "server.log";
  ASSERT_EQ(mkfifo(log.c_str(), 0600), 0);
  const int reader = open(log.c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  RunningServer server(folder);
  close(reader);
  Client client(server.address());
  // Each writes a line.
  EXPECT_TRUE(client.ListMeshes().ok());
  EXPECT_TRUE(client.ListMeshes().ok());
  server.Terminate();
  EXPECT_EQ(server.Wait(), 0);
}

TEST(ShutdownTest, WorkUnderWayIsFinished) {
  TemporaryFolder folder;
  RunningServer server(folder, {"--drain-seconds", "200"});
  const MeshArrays mesh = HillyGrid(150);
  const absl::StatusOr<Field> field = AskAndTerminate(server, mesh);
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_EQ(field->distances.size(), mesh.positions.size());
  EXPECT_EQ(server.Wait(), 0);
}

TEST(ShutdownTest, WorkThatTakesLongerThanTheDrainIsCancelled) {
  TemporaryFolder folder;
  RunningServer server(folder, {"--drain-seconds", "0"});
  EXPECT_FALSE(AskAndTerminate(server, HillyGrid(500)).ok());
  EXPECT_EQ(server.Wait(), 3);
}

}  // namespace
}  // namespace geodesic::client
