#include "client/cli/terminal/exit_code.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace geodesic::client {
namespace {

TEST(ExitCodeTest, FollowsFromTheStatus) {
  EXPECT_EQ(ExitCodeOf(absl::UnavailableError("")), ExitCode::kUnreachable);
  EXPECT_EQ(ExitCodeOf(absl::InvalidArgumentError("")), ExitCode::kRefused);
  EXPECT_EQ(ExitCodeOf(absl::NotFoundError("")), ExitCode::kRefused);
  EXPECT_EQ(ExitCodeOf(absl::InternalError("")), ExitCode::kRefused);
  EXPECT_EQ(ExitCodeOf(absl::DeadlineExceededError("")), ExitCode::kTimeout);
  EXPECT_EQ(ExitCodeOf(Interrupted()), ExitCode::kInterrupted);
}

TEST(ExitCodeTest, LocalFilesAreTheirOwnCase) {
  EXPECT_EQ(ExitCodeOf(FileError(absl::NotFoundError("x"))), ExitCode::kFile);
  EXPECT_TRUE(FileError(absl::OkStatus()).ok());
}

// A server, or a proxy, may end a call when it stops.
TEST(ExitCodeTest, AServersCancellationIsNoInterruption) {
  const absl::Status status = absl::CancelledError("going down");
  EXPECT_EQ(ExitCodeOf(status), ExitCode::kUnreachable);
  EXPECT_EQ(Explain(status, "host:1"),
            "the server at host:1 ended the call: going down; try again in a "
            "moment");
}

TEST(ExplainTest, KeepsTheServersWordsAndSaysWhatToDo) {
  const std::vector<std::pair<absl::Status, std::string>> table = {
      {absl::UnavailableError("failed to connect to all addresses"),
       "cannot reach a server at host:1: start one with geodesicd, or name one "
       "with --server"},
      {absl::UnavailableError("shutting down"),
       "the server at host:1 is not available: shutting down; try again in a "
       "moment"},
      {absl::NotFoundError("mesh ab is not resident"),
       "mesh ab is not resident; `geodesic meshes` lists what is resident, "
       "`geodesic upload FILE` adds to it"},
      {absl::ResourceExhaustedError("Received message larger than max (9 vs. "
                                    "4)"),
       "the request is larger than the server's max_message_bytes (Received "
       "message larger than max (9 vs. 4)): ask for fewer sources, targets or "
       "levels at a time"},
      {absl::InvalidArgumentError("line 3: no number"), "line 3: no number"}};
  for (const auto& [status, said] : table) {
    EXPECT_EQ(Explain(status, "host:1"), said);
  }
}

}  // namespace
}  // namespace geodesic::client
