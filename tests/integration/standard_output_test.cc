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
using ::testing::IsEmpty;
using ::testing::Not;

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

// Each answer is what a file of the same ending holds, and nothing else is with
// it.
TEST_F(StandardOutputTest, TakesAnswersInsteadOfFiles) {
  WriteFile(folder_ / "pairs.txt", "0 9\n3 80\n");
  for (const auto& [question, endings] : std::vector<std::pair<Words, Words>>{
           {{"field", grid_, "-s", "0"}, {"", ".csv", ".npy"}},
           {{"path", grid_, "-s", "0", "-t", "9"}, {"", ".csv", ".json"}},
           {{"isolines", grid_, "-s", "0", "-l", "0.3"}, {"", ".json"}},
           {matrix_, {"", ".npy"}},
           {{"nearest", grid_, "-s", "0", "-t", "3"}, {"", ".json"}},
           {{"sample", grid_, "-n", "2"}, {"", ".json"}},
           {{"logmap", grid_, "-s", "0"}, {"", ".npy"}},
           {{"distance", grid_, "--pairs", folder_ / "pairs.txt"},
            {"", ".npy", ".json"}}}) {
    for (const std::string& ending : endings) {
      SCOPED_TRACE(question[0] + ending);
      const std::string file =
          folder_ / ("answer" + (ending.empty() ? ".csv" : ending));
      Words words = question;
      words.insert(words.end(), {"-o", file, "-o", "-" + ending});
      const ProcessResult result = Geodesic(words);
      EXPECT_EQ(result.exit_code, 0) << result.err;
      EXPECT_THAT(result.out, Not(IsEmpty()));
      EXPECT_EQ(result.out, FileBytes(file));
      EXPECT_THAT(result.err, HasSubstr("wrote"));
      EXPECT_THAT(result.err, HasSubstr("standard output ("));
      words.push_back("--quiet");
      EXPECT_EQ(Geodesic(words).out, FileBytes(file));
    }
  }
}

TEST_F(StandardOutputTest, AnAnswerThatIsLostIsAnError) {
  Words words = matrix_;
  words.insert(words.end(), {"-o", "-", "--quiet"});
  ExpectLost(InShell("exec \"$@\" > /dev/full", words),
             "No space left on device");
}

TEST_F(StandardOutputTest, TakesOneAnswerThatItCanHold) {
  const Words field = {"field", grid_, "-s", "0"};
  for (const auto& [more, says] : std::vector<std::pair<Words, std::string>>{
           {{"-o", "-", "-o", "-.npy"}, "takes one answer"},
           {{"-o", "-", "--json"}, "--json"},
           {{"-o", "-", "--progressive"}, "without -o -"},
           {{"-o", "-.png"}, "takes .csv, .npy and .json only, not .png"},
           {{"-o", "-.npz"}, "not .npz: name a file"}}) {
    Words words = field;
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_THAT(Refusal(words, 2), HasSubstr(says));
  }
  EXPECT_THAT(Refusal({"distance", grid_, "0", "1", "-o", "-", "--json"}, 2),
              HasSubstr("--json"));
}

// script(1) gives the command a terminal.
TEST_F(StandardOutputTest, ATerminalGetsNoBinary) {
  const std::string in_terminal =
      "printf -v line '%q ' \"$@\"; exec script -qec \"$line\" /dev/null "
      "< /dev/null";
  const ProcessResult binary =
      InShell(in_terminal, {"field", grid_, "-s", "0", "-o", "-.npy"});
  EXPECT_EQ(binary.exit_code, 2);
  EXPECT_THAT(binary.out, HasSubstr("standard output is a terminal"));
  const ProcessResult text =
      InShell(in_terminal, {"field", grid_, "-s", "0", "-o", "-", "--quiet"});
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_THAT(text.out, HasSubstr("vertex,geodesic_distance"));
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
