// What goes wrong, how the command says so, and what it exits with.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/integration/meshes.h"
#include "tests/integration/running_server.h"

namespace geodesic::client {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class ErrorTest : public IntegrationTest {
 protected:
  void SetUp() override {
    WriteFile(folder_ / "grid.off", OffText(PlanarGrid(4)));
  }

  void ExpectFailure(const std::vector<std::string>& arguments, int exit_code,
                     const std::string& code, const std::string& words) {
    const ProcessResult plain = Geodesic(arguments);
    EXPECT_EQ(plain.exit_code, exit_code);
    EXPECT_EQ(plain.out, "");
    EXPECT_THAT(plain.err, AllOf(HasSubstr("geodesic: "), HasSubstr(words)));
    const json error = GeodesicJson(arguments, exit_code)["error"];
    EXPECT_EQ(error["code"], code);
    EXPECT_EQ(error["exit_code"], exit_code);
  }
};

TEST_F(ErrorTest, WordsAndJsonTellTheSame) {
  const std::string grid = folder_ / "grid.off";
  const std::string missing = folder_ / "missing.off";
  const std::string bad = folder_ / "bad.off";
  WriteFile(bad, "OFF\n3 1 0\n0 0 0\n1 0 zero\n0 1 0\n3 0 1 2\n");
  const std::string digest(64, 'a');
  // A file that the server does not know yet.
  ExpectFailure({"delete", grid}, 5, "NOT_FOUND", "grid.off");
  ExpectFailure({"field", grid, "-s", "1", "-s", "99"}, 5, "INVALID_ARGUMENT",
                "sources[1]");
  ExpectFailure({"field", digest, "-s", "0"}, 5, "NOT_FOUND",
                "geodesic upload");
  for (const std::string& unknown : {digest, digest.substr(0, 8)}) {
    ExpectFailure({"info", unknown}, 5, "NOT_FOUND", unknown);
    ExpectFailure({"delete", unknown}, 5, "NOT_FOUND", unknown);
  }
  ExpectFailure({"info", "aaaaaaa"}, 3, "INVALID_ARGUMENT",
                "neither a file nor a digest");
  ExpectFailure({"upload", missing}, 3, "INVALID_ARGUMENT", "missing.off");
  ExpectFailure({"upload", folder_.path().string()}, 3, "INVALID_ARGUMENT",
                "not a regular file");
  ExpectFailure({"upload", bad}, 5, "INVALID_ARGUMENT", "4");  // the line
}

TEST_F(ErrorTest, AFaultOfAMeshNamesTheFileAndNoFieldOfTheProtocol) {
  const std::string path = folder_ / "bad.off";
  for (const std::string text :
       {"", "OFF\n3 1 0\n0 0 0\n1 0 zero\n0 1 0\n3 0 1 2\n",
        "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"}) {
    WriteFile(path, text);
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"upload", path},
          {"field", path, "-s", "0"}}) {
      const ProcessResult result = Geodesic(words);
      EXPECT_EQ(result.exit_code, 5);
      EXPECT_THAT(
          result.err,
          AllOf(HasSubstr("geodesic: " + path + ": "), Not(HasSubstr("chunk")),
                Not(HasSubstr("size_bytes")), Not(HasSubstr("[field"))));
    }
  }
}

TEST_F(ErrorTest, ControlCharactersOfAFileAreEscaped) {
  WriteFile(folder_ / "list.txt", "\x1b[31m3\n");
  ExpectFailure(
      {"field", folder_ / "grid.off", "--sources", folder_ / "list.txt"}, 3,
      "INVALID_ARGUMENT", "'\\x1b[31m3'");
}

TEST_F(ErrorTest, OutputsThatCannotBeWrittenFailBeforeAnythingIsSent) {
  ExpectFailure({"field", folder_ / "grid.off", "-s", "0", "-o",
                 folder_ / "missing/d.npy"},
                3, "INVALID_ARGUMENT", "missing/d.npy");
  EXPECT_EQ(GeodesicJson({"meshes"})["meshes"], json::array());
}

TEST_F(ErrorTest, NoServer) {
  // A port nobody listens on: this test's server has just left it.
  server_.Terminate();
  ASSERT_EQ(server_.Wait(), 0);
  ExpectFailure({"meshes"}, 7, "UNAVAILABLE", "start one with geodesicd");
}

}  // namespace
}  // namespace geodesic::client
