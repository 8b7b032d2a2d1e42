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

TEST_F(ErrorTest, SourceOutOfRange) {
  ExpectFailure({"field", folder_ / "grid.off", "-s", "25"}, 5,
                "INVALID_ARGUMENT", "25");
}

TEST_F(ErrorTest, TheFieldAtFaultIsNamed) {
  ExpectFailure({"field", folder_ / "grid.off", "-s", "1", "-s", "99"}, 5,
                "INVALID_ARGUMENT", "sources[1]");
}

TEST_F(ErrorTest, UnknownDigest) {
  const std::string digest(64, 'a');
  ExpectFailure({"field", digest, "-s", "0"}, 5, "NOT_FOUND",
                "geodesic upload");
  ExpectFailure({"info", digest}, 5, "NOT_FOUND", digest);
  ExpectFailure({"delete", digest}, 5, "NOT_FOUND", digest);
  ExpectFailure({"info", "aaaaaaaa"}, 5, "NOT_FOUND", "aaaaaaaa");
}

TEST_F(ErrorTest, DeletingAFileTheServerDoesNotKnow) {
  ExpectFailure({"delete", folder_ / "grid.off"}, 5, "NOT_FOUND", "grid.off");
}

TEST_F(ErrorTest, NeitherFileNorDigest) {
  ExpectFailure({"info", "aaaaaaa"}, 3, "NOT_FOUND",
                "neither a file nor a digest");
  ExpectFailure({"field", folder_ / "missing.off", "-s", "0"}, 3, "NOT_FOUND",
                "missing.off");
}

TEST_F(ErrorTest, FilesThatCannotBeUploaded) {
  ExpectFailure({"upload", folder_ / "missing.off"}, 3, "NOT_FOUND",
                "missing.off");
  ExpectFailure({"upload", folder_.path().string()}, 3, "INVALID_ARGUMENT",
                "not a regular file");
}

TEST_F(ErrorTest, MalformedFileIsNamedByLine) {
  WriteFile(folder_ / "bad.off",
            "OFF\n3 1 0\n0 0 0\n1 0 zero\n0 1 0\n3 0 1 2\n");
  ExpectFailure({"upload", folder_ / "bad.off"}, 5, "INVALID_ARGUMENT", "4");
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

TEST_F(ErrorTest, UnknownOutputEndingFailsBeforeAnythingIsSent) {
  const ProcessResult result = Geodesic(
      {"field", folder_ / "grid.off", "-s", "0", "-o", folder_ / "d.txt"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err,
              HasSubstr(".npy, .npz, .csv, .f64, .f32, .ply, .vtk and .png"));
  EXPECT_EQ(GeodesicJson({"meshes"})["meshes"], json::array());
}

TEST_F(ErrorTest, MissingOutputFolderFailsBeforeAnythingIsSent) {
  ExpectFailure({"field", folder_ / "grid.off", "-s", "0", "-o",
                 folder_ / "missing/d.npy"},
                3, "NOT_FOUND", "missing/d.npy");
  EXPECT_EQ(GeodesicJson({"meshes"})["meshes"], json::array());
}

TEST_F(ErrorTest, FailedFieldLeavesNoFile) {
  Geodesic(
      {"field", folder_ / "grid.off", "-s", "25", "-o", folder_ / "d.npy"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "d.npy"));
}

TEST_F(ErrorTest, NoServer) {
  // A port nobody listens on: this test's server has just left it.
  server_.Terminate();
  ASSERT_EQ(server_.Wait(), 0);
  ExpectFailure({"meshes"}, 4, "UNAVAILABLE", "start one with geodesicd");
}

TEST_F(ErrorTest, WrongUsage) {
  EXPECT_EQ(Geodesic({}).exit_code, 2);
  EXPECT_EQ(Geodesic({"field"}).exit_code, 2);
  EXPECT_EQ(Geodesic({"field", "m", "-s", "x"}).exit_code, 2);
  EXPECT_EQ(Geodesic({"meshes", "--wings"}).exit_code, 2);
}

}  // namespace
}  // namespace geodesic::client
