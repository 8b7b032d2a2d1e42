// What goes to standard output gets there, or the command says why not.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <string>
#include <vector>

#include "tests/integration/planar_grid_test.h"

namespace geodesic::client {
namespace {

using ::testing::HasSubstr;

using Words = std::vector<std::string>;

class StandardOutputTest : public PlanarGridTest {
 protected:
  // Runs the command inside a line of shell, whose "$@" it is.
  ProcessResult InShell(const std::string& line, const Words& arguments) const {
    Words words = {"/bin/bash", "-c", line, "bash"};
    const Words command = CommandLine(arguments);
    words.insert(words.end(), command.begin(), command.end());
    return RunProgram(words);
  }

  void ExpectLost(const ProcessResult& result, const std::string& why) const {
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_EQ(result.err,
              "geodesic: cannot write standard output: " + why + "\n");
  }

  // More than pipes hold.
  const Words matrix_ = [this] {
    Words words = {"matrix", grid_};
    for (int source = 0; source < 81; ++source) {
      words.insert(words.end(), {"-s", std::to_string(source)});
    }
    return words;
  }();
};

TEST_F(StandardOutputTest, AFullDiskIsAnError) {
  for (const Words& arguments :
       std::vector<Words>{{"field", grid_, "-s", "0"},
                          {"field", grid_, "-s", "0", "--json"},
                          {"field", grid_, "-s", "0", "--progressive"},
                          matrix_,
                          {"matrix", grid_, "-s", "0", "--json"},
                          {"meshes"},
                          {"info", "ffffffff", "--json"},
                          {"--help"},
                          {"--version"}}) {
    SCOPED_TRACE(::testing::PrintToString(arguments));
    const ProcessResult result = InShell("exec \"$@\" > /dev/full", arguments);
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_THAT(result.err, HasSubstr("geodesic: cannot write standard output: "
                                      "No space left on device\n"));
  }
}

TEST_F(StandardOutputTest, HalfOfTheRowsIsAnError) {
  for (const Words& arguments :
       {Words{"field", grid_, "-s", "0", "--progressive"}, matrix_}) {
    ExpectLost(InShell("trap '' XFSZ; ulimit -f 1; exec \"$@\" > " +
                           (folder_ / "rows.csv"),
                       arguments),
               "File too large");
    EXPECT_EQ(FileBytes(folder_ / "rows.csv").size(), 1024);
  }
}

TEST_F(StandardOutputTest, ClosedIsAnError) {
  ExpectLost(InShell("exec \"$@\" >&-", {"meshes"}), "Bad file descriptor");
}

TEST_F(StandardOutputTest, AReaderThatHasEnoughEndsTheCommandSilently) {
  const ProcessResult result =
      InShell("\"$@\" | head -n 1; exit ${PIPESTATUS[0]}", matrix_);
  EXPECT_EQ(result.exit_code, 128 + SIGPIPE);
  EXPECT_EQ(result.out, "source,target,distance\n");
  EXPECT_EQ(result.err, "");
}

// As in a program that ignores SIGPIPE.
TEST_F(StandardOutputTest, WithoutTheSignalABrokenPipeIsAnError) {
  ExpectLost(InShell("trap '' PIPE; \"$@\" | head -n 1; exit ${PIPESTATUS[0]}",
                     matrix_),
             "Broken pipe");
}

}  // namespace
}  // namespace geodesic::client
