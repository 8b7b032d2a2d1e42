// Ctrl-C, timeouts and stop requests, while the server computes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <initializer_list>
#include <string>

#include "geodesic_client/client.h"
#include "tests/integration/meshes.h"
#include "tests/integration/running_server.h"

namespace geodesic::client {
namespace {

using ::testing::HasSubstr;

class InterruptionTest : public IntegrationTest {
 protected:
  // Far more than a second's work for ICH, which all of these ask for.
  void SetUp() override {
    absl::StatusOr<UploadOutcome> upload = client_.UploadArrays(HillyGrid(500));
    ASSERT_TRUE(upload.ok()) << upload.status();
    digest_ = upload->mesh.digest;
  }

  Client client_{server_.address()};
  std::string digest_;
};

TEST_F(InterruptionTest, CtrlCEndsTheCommand) {
  Process field(CommandLine({"field", digest_, "-s", "0", "--algorithm", "ich",
                             "-o", folder_ / "d.npy"}));
  // Not on a terminal: a line of progress after a second.
  ASSERT_TRUE(field.AwaitError("solving"));
  field.Signal(SIGINT);
  const ProcessResult result = field.Wait();
  EXPECT_EQ(result.exit_code, 130);
  EXPECT_THAT(result.err, HasSubstr("geodesic: interrupted\n"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "d.npy"));
  // The log has the request once the server has ended it.
  server_.Terminate();
  EXPECT_EQ(server_.Wait(), 0);
  EXPECT_THAT(FileBytes(folder_ / "server.log"),
              HasSubstr("method=ComputeField code=CANCELLED"));
}

// A matrix whose rows are written as they come.
class InterruptedMatrixTest : public InterruptionTest {
 protected:
  // Waits until some are there, sends the signals, and expects that nothing is
  // left of the file.
  void ExpectNoPartAfter(std::initializer_list<int> signals) {
    std::string rows;
    for (int i = 0; i < 200; ++i) rows += std::to_string(i) + "\n";
    WriteFile(folder_ / "rows.txt", rows);
    Process matrix(
        CommandLine({"matrix", digest_, "--sources", folder_ / "rows.txt", "-o",
                     folder_ / "d.npy"}));
    ASSERT_TRUE(matrix.AwaitError("solving"));
    const std::string part =
        folder_ / ("d.npy.part-" + std::to_string(matrix.id()));
    EXPECT_TRUE(std::filesystem::exists(part));
    for (const int signal : signals) matrix.Signal(signal);
    EXPECT_EQ(matrix.Wait().exit_code, 130);
    EXPECT_FALSE(std::filesystem::exists(part));
  }
};

TEST_F(InterruptedMatrixTest, ATerminalThatClosesLeavesNoPartOfAFile) {
  ExpectNoPartAfter({SIGHUP});
}

// As timeout(1) sends them, to the process and to its group.
TEST_F(InterruptedMatrixTest, TwoSignalsAtOnceAreOne) {
  ExpectNoPartAfter({SIGINT, SIGTERM});
}

TEST_F(InterruptionTest, SignalsThatAreIgnoredStayIgnored) {
  std::vector<std::string> words = {"/bin/sh", "-c",
                                    "trap '' HUP INT; exec \"$@\"", "sh"};
  for (const std::string& word :
       CommandLine({"field", digest_, "-s", "0", "--algorithm", "ich",
                    "--timeout", "3"})) {
    words.push_back(word);
  }
  Process field(words);
  ASSERT_TRUE(field.AwaitError("solving"));
  field.Signal(SIGHUP);
  field.Signal(SIGINT);
  EXPECT_EQ(field.Wait().exit_code, 6);
}

TEST_F(InterruptionTest, CtrlCLeavesWhatHadSettled) {
  Process field(CommandLine({"field", digest_, "-s", "0", "--algorithm", "ich",
                             "--progressive", "-o", folder_ / "d.csv"}));
  ASSERT_TRUE(field.AwaitError("solving"));
  field.Signal(SIGINT);
  EXPECT_EQ(field.Wait().exit_code, 130);
  EXPECT_THAT(FileBytes(folder_ / "d.csv"),
              ::testing::StartsWith("vertex,geodesic_distance\n0,0\n"));
}

TEST_F(InterruptionTest, TimeoutEndsTheCommand) {
  const ProcessResult result = Geodesic(
      {"field", digest_, "-s", "0", "--algorithm", "ich", "--timeout", "0.2"});
  EXPECT_EQ(result.exit_code, 6) << result.err;
  EXPECT_THAT(result.err, HasSubstr("--timeout"));
}

TEST_F(InterruptionTest, StopRequestCancelsTheCall) {
  std::stop_source stop;
  size_t reports = 0;
  absl::StatusOr<Field> field = client_.ComputeField(
      {.mesh_digest = digest_,
       .sources = {{VertexPoint{0}}},
       .algorithm = "ich"},
      {.stop = stop.get_token()}, [&](const SolveProgress& progress) {
        EXPECT_EQ(progress.vertex_count, 501 * 501);
        ++reports;
        stop.request_stop();
      });
  EXPECT_EQ(field.status().code(), absl::StatusCode::kCancelled);
  EXPECT_GE(reports, 1);
}

TEST_F(InterruptionTest, StopRequestedBeforehandCancelsAtOnce) {
  std::stop_source stop;
  stop.request_stop();
  const CallOptions options = {.stop = stop.get_token()};
  EXPECT_TRUE(absl::IsCancelled(client_.ListMeshes(options).status()));
  EXPECT_TRUE(
      absl::IsCancelled(client_
                            .ComputeField({.mesh_digest = digest_,
                                           .sources = {{VertexPoint{0}}},
                                           .algorithm = "ich"},
                                          options)
                            .status()));
}

}  // namespace
}  // namespace geodesic::client
