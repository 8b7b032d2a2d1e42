// The commands one after the other, as someone would use them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "absl/strings/ascii.h"
#include "tests/integration/meshes.h"
#include "tests/integration/running_server.h"

namespace geodesic::client {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class CommandTest : public IntegrationTest {};

TEST_F(CommandTest, UploadNamesTheMeshByItsContent) {
  const MeshArrays mesh = PlanarGrid(8);
  WriteFile(folder_ / "grid.off", OffText(mesh));
  const json upload = GeodesicJson({"upload", folder_ / "grid.off"});
  EXPECT_EQ(upload["mesh"]["digest"], MeshDigest(mesh));
  EXPECT_EQ(upload["mesh"]["vertices"], 81);
  EXPECT_EQ(upload["mesh"]["faces"], 128);
  EXPECT_EQ(upload["mesh"]["boundary_loops"], 1);
  EXPECT_EQ(upload["mesh"]["components"], 1);
  EXPECT_EQ(upload["mesh"]["genus"], 0);
  EXPECT_EQ(upload["already_resident"], false);
  EXPECT_EQ(upload["bytes_sent"], OffText(mesh).size());
  // A file that is known is not sent again; another is, though its mesh is
  // there.
  const json again = GeodesicJson({"upload", folder_ / "grid.off"});
  EXPECT_EQ(again["mesh"], upload["mesh"]);
  EXPECT_EQ(again["already_resident"], true);
  EXPECT_EQ(again["bytes_sent"], 0);
  WriteFile(folder_ / "other.off", OffText(mesh) + "\n");
  const json other = GeodesicJson({"upload", folder_ / "other.off"});
  EXPECT_EQ(other["mesh"]["digest"], MeshDigest(mesh));
  EXPECT_EQ(other["already_resident"], true);
  EXPECT_GT(other["bytes_sent"], 0);
  EXPECT_EQ(GeodesicJson({"meshes"})["meshes"].size(), 1);
}

TEST_F(CommandTest, MeshesInfoAndDelete) {
  EXPECT_EQ(GeodesicJson({"meshes"})["meshes"], json::array());
  EXPECT_THAT(Geodesic({"meshes"}).out, HasSubstr("geodesic upload"));
  WriteFile(folder_ / "grid.off", OffText(PlanarGrid(8)));
  const std::string digest =
      GeodesicJson({"upload", folder_ / "grid.off"})["mesh"]["digest"];
  EXPECT_EQ(GeodesicJson({"meshes"})["meshes"][0]["digest"], digest);
  EXPECT_THAT(Geodesic({"meshes"}).out, HasSubstr(digest.substr(0, 16)));
  const std::string upper = absl::AsciiStrToUpper(digest);
  // By digest, by its beginning, in either case, by file.
  for (const std::string& name : {digest, digest.substr(0, 8), upper,
                                  upper.substr(0, 8), folder_ / "grid.off"}) {
    EXPECT_EQ(GeodesicJson({"info", name})["digest"], digest);
  }
  EXPECT_THAT(Geodesic({"info", digest}).out, HasSubstr("bounding box"));
  EXPECT_EQ(GeodesicJson({"delete", folder_ / "grid.off"})["deleted"], digest);
  EXPECT_EQ(GeodesicJson({"meshes"})["meshes"], json::array());
}

TEST_F(CommandTest, InfoTellsWhatIsNotManifoldAndWhatIsTurned) {
  // Three half-planes that share the edge 0-1, two of them turned alike.
  WriteFile(folder_ / "fan.off",
            "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n"
            "3 0 1 2\n3 1 0 3\n3 0 1 4\n");
  const json fan = GeodesicJson({"info", folder_ / "fan.off"});
  EXPECT_EQ(fan["non_manifold_edges"], 1);
  EXPECT_TRUE(fan["genus"].is_null());
  EXPECT_THAT(Geodesic({"info", folder_ / "fan.off"}).out,
              HasSubstr("1 edges, "));
  WriteFile(folder_ / "turned.off",
            "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n3 0 1 2\n3 0 1 3\n");
  const json turned = GeodesicJson({"info", folder_ / "turned.off"});
  EXPECT_EQ(turned["inconsistent_edges"], 1);
  EXPECT_EQ(turned["is_orientable"], true);
  EXPECT_THAT(Geodesic({"info", folder_ / "turned.off"}).out,
              HasSubstr("turned against each other"));
}

TEST_F(CommandTest, FormatsCanBeNamed) {
  WriteFile(folder_ / "grid.mesh", OffText(PlanarGrid(2)));
  const json refused =
      GeodesicJson({"upload", folder_ / "grid.mesh"}, /*exit code=*/3);
  EXPECT_THAT(refused["error"]["message"].get<std::string>(),
              HasSubstr("--format"));
  GeodesicJson({"upload", folder_ / "grid.mesh", "--format", "off"});
}

TEST_F(CommandTest, Capabilities) {
  const json capabilities = GeodesicJson({"capabilities"});
  std::vector<std::string> names;
  for (const json& algorithm : capabilities["algorithms"]) {
    names.push_back(algorithm["name"]);
  }
  EXPECT_THAT(names, ::testing::UnorderedElementsAre("fwp-ch", "fwp-mmp", "ich",
                                                     "mmp", "ch", "lc-mmp",
                                                     "lc-ch", "fwp-list"));
  EXPECT_GT(capabilities["limits"]["max_upload_bytes"], 0);
  EXPECT_THAT(Geodesic({"capabilities"}).out, HasSubstr("fwp-ch"));
}

TEST_F(CommandTest, SeveralFilesAreUploadedAtOnce) {
  const std::string left = folder_ / "left.off";
  const std::string right = folder_ / "right.off";
  WriteFile(left, OffText(PlanarGrid(2)));
  WriteFile(right, OffText(PlanarGrid(3)));
  const json uploads = GeodesicJson({"upload", left, right})["uploads"];
  ASSERT_EQ(uploads.size(), 2);
  EXPECT_EQ(uploads[0]["mesh"]["digest"], MeshDigest(PlanarGrid(2)));
  EXPECT_EQ(uploads[1]["mesh"]["digest"], MeshDigest(PlanarGrid(3)));
  EXPECT_EQ(
      Geodesic({"upload", "--quiet", left, right}).out,
      MeshDigest(PlanarGrid(2)) + "\n" + MeshDigest(PlanarGrid(3)) + "\n");
}

TEST_F(CommandTest, UploadsBeforeOneThatFailsAreKept) {
  const std::string good = folder_ / "good.off";
  const std::string bad = folder_ / "bad.off";
  const std::string missing = folder_ / "missing.off";
  WriteFile(good, OffText(PlanarGrid(2)));
  WriteFile(bad, "OFF\n1 1 0\n");
  const json absent = GeodesicJson({"upload", good, missing, bad}, 3);
  ASSERT_EQ(absent["uploads"].size(), 1);
  EXPECT_EQ(absent["uploads"][0]["file"], good);
  EXPECT_EQ(absent["uploads"][0]["mesh"]["digest"], MeshDigest(PlanarGrid(2)));
  EXPECT_EQ(absent["error"]["file"], missing);
  EXPECT_EQ(absent["error"]["code"], "INVALID_ARGUMENT");
  EXPECT_EQ(absent["error"]["exit_code"], 3);
  EXPECT_EQ(absent["error"]["message"],
            "cannot read " + missing + ": No such file or directory");
  const json malformed = GeodesicJson({"upload", good, bad}, 5);
  EXPECT_EQ(malformed["uploads"].size(), 1);
  EXPECT_EQ(malformed["error"]["file"], bad);
  const ProcessResult text = Geodesic({"upload", "-q", good, missing});
  EXPECT_EQ(text.out, MeshDigest(PlanarGrid(2)) + "\n");
  EXPECT_THAT(text.err, HasSubstr("cannot read " + missing));
}

TEST_F(CommandTest, ListsComeFromStandardInput) {
  const std::string path = folder_ / "grid.off";
  WriteFile(path, OffText(PlanarGrid(2)));
  std::vector<std::string> words = {"/bin/bash", "-c",
                                    "printf '3\\n5\\n' | \"$@\"", "bash"};
  const std::vector<std::string> command =
      CommandLine({"field", path, "-s", "0", "--targets", "-", "--json"});
  words.insert(words.end(), command.begin(), command.end());
  const ProcessResult result = RunProgram(words);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json targets = json::parse(result.out)["targets"];
  ASSERT_EQ(targets.size(), 2);
  EXPECT_EQ(targets[1]["vertex"], 5);
}

TEST_F(CommandTest, QuietLeavesNothingButTheRowsAskedFor) {
  const std::string path = folder_ / "grid.off";
  WriteFile(path, OffText(PlanarGrid(2)));
  const std::vector<std::string> question = {"path", path, "-s", "0",
                                             "-t",   "1",  "-q"};
  EXPECT_THAT(Geodesic(question).out,
              ::testing::AllOf(HasSubstr("target  source"),
                               ::testing::Not(HasSubstr("solver"))));
  std::vector<std::string> to_file = question;
  to_file.insert(to_file.end(), {"-o", folder_ / "path.obj"});
  EXPECT_EQ(Geodesic(to_file).out, "");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "path.obj"));
  EXPECT_EQ(
      Geodesic({"field", path, "-s", "0", "-q", "-o", folder_ / "d.npy"}).out,
      "");
  EXPECT_EQ(Geodesic({"delete", path, "-q"}).out, "");
}

TEST_F(CommandTest, GrpcKeepsItsWordsToItself) {
  std::vector<std::string> words = {"/usr/bin/env", "grpc_proxy=ftp://proxy"};
  const std::vector<std::string> command = CommandLine({"meshes"});
  words.insert(words.end(), command.begin(), command.end());
  EXPECT_EQ(RunProgram(words).err, "");
}

}  // namespace
}  // namespace geodesic::client
