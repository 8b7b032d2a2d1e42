#include "client/cli/terminal/exit_code.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geodesic::client {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

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

TEST(ExplainTest, UnreachableServerSaysWhatToDo) {
  EXPECT_EQ(
      Explain(absl::UnavailableError("failed to connect to all addresses"),
              "host:1"),
      "cannot reach a server at host:1: start one with geodesicd, or "
      "name one with --server");
}

TEST(ExplainTest, ServerThatShutsDownIsNotCalledUnreachable) {
  const std::string text =
      Explain(absl::UnavailableError("shutting down"), "host:1");
  EXPECT_THAT(text, HasSubstr("shutting down"));
  EXPECT_THAT(text, Not(HasSubstr("cannot reach")));
}

TEST(ExplainTest, MissingMeshPointsToUpload) {
  EXPECT_THAT(Explain(absl::NotFoundError("mesh ab is not resident"), "h:1"),
              HasSubstr("geodesic upload"));
}

TEST(ExplainTest, ARequestThatIsTooLargeNamesTheLimit) {
  EXPECT_THAT(Explain(absl::ResourceExhaustedError(
                          "Received message larger than max (9 vs. 4)"),
                      "h:1"),
              HasSubstr("max_message_bytes"));
}

TEST(ExplainTest, ServersWordsAreKept) {
  EXPECT_EQ(Explain(absl::InvalidArgumentError("line 3: no number"), "h:1"),
            "line 3: no number");
}

}  // namespace
}  // namespace geodesic::client
