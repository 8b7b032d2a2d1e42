#include "client/cli/arguments.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace geodesic::client {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class ArgumentsTest : public ::testing::Test {
 protected:
  void SetUp() override { unsetenv("GEODESIC_SERVER"); }

  std::variant<Arguments, ExitCode> Parse(std::vector<const char*> words) {
    words.insert(words.begin(), "geodesic");
    return ParseArguments(static_cast<int>(words.size()), words.data(), out_,
                          err_);
  }

  Arguments Accepted(const std::vector<const char*>& words) {
    std::variant<Arguments, ExitCode> parsed = Parse(words);
    EXPECT_TRUE(std::holds_alternative<Arguments>(parsed)) << err_.str();
    return std::holds_alternative<Arguments>(parsed)
               ? std::get<Arguments>(parsed)
               : Arguments{};
  }

  // What is said about a command line that is refused as wrong usage.
  std::string Refused(const std::vector<const char*>& words) {
    err_.str("");
    std::variant<Arguments, ExitCode> parsed = Parse(words);
    EXPECT_TRUE(std::holds_alternative<ExitCode>(parsed));
    if (std::holds_alternative<ExitCode>(parsed)) {
      EXPECT_EQ(std::get<ExitCode>(parsed), ExitCode::kUsage);
    }
    return err_.str();
  }

  std::ostringstream out_;
  std::ostringstream err_;
};

TEST_F(ArgumentsTest, Field) {
  const Arguments arguments = Accepted(
      {"field",     "--source", "3",      "-s",     "7:0.5",       "horse.ply",
       "-o",        "a.npy",    "-o",     "b.PNG",  "--algorithm", "ich",
       "--timeout", "2.5",      "--view", "-30,20", "--size",      "640x480",
       "--up",      "z",        "--quiet"});
  EXPECT_EQ(arguments.command, Command::kField);
  EXPECT_EQ(arguments.mesh, "horse.ply");
  EXPECT_THAT(arguments.sources,
              ElementsAre(Source{VertexPoint{3}}, Source{VertexPoint{7}, 0.5}));
  ASSERT_EQ(arguments.outputs.size(), 2);
  EXPECT_EQ(arguments.outputs[0].path, "a.npy");
  EXPECT_EQ(arguments.outputs[0].format, OutputFormat::kNpy);
  EXPECT_EQ(arguments.outputs[1].format, OutputFormat::kPng);
  EXPECT_EQ(arguments.algorithm, "ich");
  EXPECT_EQ(arguments.timeout, 2.5);
  ASSERT_TRUE(arguments.picture.direction.has_value());
  EXPECT_EQ(arguments.picture.direction->azimuth, -30);
  EXPECT_EQ(arguments.picture.direction->elevation, 20);
  EXPECT_EQ(arguments.picture.width, 640);
  EXPECT_EQ(arguments.picture.height, 480);
  EXPECT_EQ(arguments.picture.up, UpAxis::kZ);
  EXPECT_TRUE(arguments.quiet);
}

TEST_F(ArgumentsTest, Connection) {
  const Arguments arguments = Accepted(
      {"--tls-ca", "ca.pem", "--tls-cert", "c.pem", "--tls-key", "k.pem",
       "--tls-server-name", "n", "--token-file", "t", "meshes"});
  const ConnectionArguments& connection = arguments.connection;
  EXPECT_EQ(connection.paths.authorities, "ca.pem");
  EXPECT_EQ(connection.paths.certificate, "c.pem");
  EXPECT_EQ(connection.paths.key, "k.pem");
  EXPECT_EQ(connection.server_name, "n");
  EXPECT_EQ(connection.token_file, "t");
  EXPECT_FALSE(connection.tls);
  EXPECT_TRUE(Accepted({"--tls", "meshes"}).connection.tls);
}

TEST_F(ArgumentsTest, FieldDefaults) {
  const Arguments arguments = Accepted({"field", "m", "-s", "0"});
  EXPECT_EQ(arguments.server, "127.0.0.1:50051");
  EXPECT_TRUE(arguments.algorithm.empty());
  EXPECT_TRUE(arguments.outputs.empty());
  EXPECT_FALSE(arguments.timeout.has_value());
  EXPECT_FALSE(arguments.format.has_value());
  EXPECT_FALSE(arguments.picture.direction.has_value());
  EXPECT_FALSE(arguments.picture.up.has_value());
  EXPECT_FALSE(arguments.json);
  EXPECT_FALSE(arguments.quiet);
}

TEST_F(ArgumentsTest, EachCommand) {
  EXPECT_EQ(Accepted({"upload", "a.obj"}).command, Command::kUpload);
  EXPECT_EQ(Accepted({"upload", "a.x", "--format", "stl"}).format,
            MeshFormat::kStl);
  EXPECT_EQ(Accepted({"meshes"}).command, Command::kMeshes);
  EXPECT_EQ(Accepted({"info", "a"}).command, Command::kInfo);
  EXPECT_EQ(Accepted({"delete", "a"}).command, Command::kDelete);
  EXPECT_EQ(Accepted({"capabilities"}).command, Command::kCapabilities);
  EXPECT_EQ(Accepted({"path", "m", "-s", "1", "-t", "2"}).command,
            Command::kPath);
  EXPECT_EQ(Accepted({"matrix", "m", "-s", "1"}).command, Command::kMatrix);
  EXPECT_EQ(Accepted({"nearest", "m", "-s", "1", "-t", "2", "-k", "3"}).count,
            3);
  EXPECT_EQ(Accepted({"sample", "m", "-n", "5"}).count, 5);
  EXPECT_EQ(Accepted({"logmap", "m", "-s", "1"}).command, Command::kLogMap);
  EXPECT_THAT(
      Accepted({"isolines", "m", "-s", "1", "-l", "0.5", "-l", "1"}).levels,
      ElementsAre(0.5, 1));
}

TEST_F(ArgumentsTest, PlacesOnTheSurface) {
  const Arguments arguments =
      Accepted({"field", "m", "--source", "edge:3-8@0.25:2", "--source",
                "face:5@0.2,0.3,0.5", "--curve", "1;edge:1-2@0.5:0.5",
                "--sources", "a.txt", "--target", "9", "--target",
                "face:0@1,0,0", "--targets", "b.txt"});
  EXPECT_THAT(arguments.sources,
              ElementsAre(Source{EdgePoint{3, 8, 0.25}, 2},
                          Source{FacePoint{5, {0.2, 0.3, 0.5}}}));
  EXPECT_THAT(
      arguments.curves,
      ElementsAre(Source{Curve{{VertexPoint{1}, EdgePoint{1, 2, 0.5}}}, 0.5}));
  EXPECT_THAT(arguments.source_files, ElementsAre("a.txt"));
  EXPECT_THAT(arguments.targets,
              ElementsAre(SurfacePoint(VertexPoint{9}),
                          SurfacePoint(FacePoint{0, {1, 0, 0}})));
  EXPECT_THAT(arguments.target_files, ElementsAre("b.txt"));
}

TEST_F(ArgumentsTest, FieldLimitsAndQuantities) {
  const Arguments arguments =
      Accepted({"field", "m", "-s", "1", "-r", "2.5", "--labels", "--gradients",
                "--float32", "-t", "4", "--stop-at-targets"});
  EXPECT_EQ(arguments.radius, 2.5);
  EXPECT_TRUE(arguments.labels);
  EXPECT_TRUE(arguments.gradients);
  EXPECT_TRUE(arguments.float32);
  EXPECT_EQ(arguments.stop_at_targets, kAllTargets);
  // MESH may follow, so that a count needs its "=".
  const Arguments counted = Accepted(
      {"field", "-s", "1", "-t", "4", "-t", "5", "--stop-at-targets=1", "m"});
  EXPECT_EQ(counted.stop_at_targets, 1);
  EXPECT_EQ(counted.mesh, "m");
}

TEST_F(ArgumentsTest, CombinationsThatMakeNoSenseAreRefused) {
  EXPECT_THAT(Refused({"field", "m", "-s", "1", "--stop-at-targets"}),
              HasSubstr("--target"));
  EXPECT_THAT(
      Refused({"field", "m", "-s", "1", "--progressive", "-o", "a.npy"}),
      HasSubstr("a.npy"));
  EXPECT_THAT(Refused({"field", "m", "-s", "1", "--progressive", "--labels"}),
              HasSubstr("--labels"));
  EXPECT_THAT(Refused({"field", "m", "-s", "1", "--progressive", "--json"}),
              HasSubstr("-o FILE.csv"));
  EXPECT_THAT(Refused({"isolines", "m", "-s", "1"}), HasSubstr("--count"));
  EXPECT_THAT(Refused({"isolines", "m", "-s", "1", "-l", "1", "-n", "2"}),
              HasSubstr("--count"));
  EXPECT_THAT(Refused({"path", "m", "-s", "1"}), HasSubstr("--targets"));
  EXPECT_THAT(Refused({"nearest", "m", "-s", "1"}), HasSubstr("--targets"));
  EXPECT_THAT(Refused({"matrix", "m"}), HasSubstr("--sources"));
  EXPECT_THAT(Refused({"logmap", "m", "-s", "1", "-s", "2"}),
              HasSubstr("one source"));
}

TEST_F(ArgumentsTest, CommonOptionsMayComeBeforeOrAfterTheCommand) {
  EXPECT_EQ(Accepted({"--server", "a:1", "meshes"}).server, "a:1");
  EXPECT_EQ(Accepted({"meshes", "--server", "a:1"}).server, "a:1");
  EXPECT_TRUE(Accepted({"--json", "meshes"}).json);
  EXPECT_TRUE(Accepted({"meshes", "--json"}).json);
}

TEST_F(ArgumentsTest, ServerFromTheEnvironmentYieldsToTheOption) {
  setenv("GEODESIC_SERVER", "env:7", 1);
  EXPECT_EQ(Accepted({"meshes"}).server, "env:7");
  EXPECT_EQ(Accepted({"meshes", "--server", "a:1"}).server, "a:1");
  unsetenv("GEODESIC_SERVER");
}

TEST_F(ArgumentsTest, WrongValuesAreNamed) {
  EXPECT_THAT(Refused({"field", "m", "-s", "-1"}), HasSubstr("'-1'"));
  EXPECT_THAT(Refused({"field", "m", "-s", "1:-2"}), HasSubstr("'1:-2'"));
  EXPECT_THAT(Refused({"field", "m", "-s", "1:inf"}), HasSubstr("'1:inf'"));
  EXPECT_THAT(Refused({"field", "m", "-s", "1:nan"}), HasSubstr("'1:nan'"));
  EXPECT_THAT(Refused({"field", "m", "-s", "1:"}), HasSubstr("'1:'"));
  EXPECT_THAT(Refused({"field", "m", "-s", "1x"}), HasSubstr("'1x'"));
  EXPECT_THAT(Refused({"field", "m", "-s", "1", "-t", "edge:1-2@1.5"}),
              HasSubstr("'edge:1-2@1.5'"));
  EXPECT_THAT(Refused({"field", "m", "-s", "1", "-r", "-1"}),
              HasSubstr("'-1'"));
  EXPECT_THAT(Refused({"field", "m", "-s", "1", "-r", "nan"}),
              HasSubstr("'nan'"));
  EXPECT_THAT(Refused({"isolines", "m", "-s", "1", "-l", "0"}),
              HasSubstr("'0'"));
  EXPECT_THAT(Refused({"nearest", "m", "-s", "1", "-t", "1", "-k", "0"}),
              HasSubstr("'0'"));
  EXPECT_THAT(Refused({"field", "m", "-s", "1", "--view", "1"}),
              HasSubstr("AZIMUTH,ELEVATION"));
  EXPECT_THAT(Refused({"field", "m", "-s", "1", "--view", "0,91"}),
              HasSubstr("'0,91'"));
  EXPECT_THAT(Refused({"field", "m", "-s", "1", "--size", "63x100"}),
              HasSubstr("'63x100'"));
  EXPECT_THAT(Refused({"field", "m", "-s", "1", "--size", "100x99999"}),
              HasSubstr("'100x99999'"));
  EXPECT_THAT(Refused({"field", "m", "-s", "1", "--algorithm", "heat"}),
              HasSubstr("heat"));
  EXPECT_THAT(Refused({"field", "m", "-s", "1", "--timeout", "0"}),
              HasSubstr("--timeout"));
}

TEST_F(ArgumentsTest, UnknownOutputEndingListsTheKnownOnes) {
  const std::string message = Refused({"field", "m", "-s", "1", "-o", "a.xyz"});
  EXPECT_THAT(message, HasSubstr("a.xyz"));
  EXPECT_THAT(message,
              HasSubstr(".npy, .npz, .csv, .f64, .f32, .ply, .vtk and .png"));
}

TEST_F(ArgumentsTest, MissingPartsAreNamed) {
  EXPECT_THAT(Refused({}), HasSubstr("subcommand"));
  EXPECT_THAT(Refused({"field", "m"}), HasSubstr("--source"));
  EXPECT_THAT(Refused({"field", "-s", "1"}), HasSubstr("MESH"));
  EXPECT_THAT(Refused({"upload"}), HasSubstr("FILE"));
  Refused({"upload", "a", "b"});
  Refused({"explode"});
}

TEST_F(ArgumentsTest, HelpAndVersionEndWell) {
  for (const std::vector<const char*>& words :
       std::vector<std::vector<const char*>>{
           {"--help"}, {"--version"}, {"field", "--help"}}) {
    std::variant<Arguments, ExitCode> parsed = Parse(words);
    ASSERT_TRUE(std::holds_alternative<ExitCode>(parsed));
    EXPECT_EQ(std::get<ExitCode>(parsed), ExitCode::kOk);
  }
  EXPECT_THAT(out_.str(), HasSubstr("Exit codes:"));
  EXPECT_THAT(out_.str(), HasSubstr("geodesic 0."));
  EXPECT_THAT(out_.str(), HasSubstr("POINT[:OFFSET]"));
}

TEST_F(ArgumentsTest, HelpFitsATerminalAndHasExamples) {
  std::string all_help;
  Parse({"--help"});
  all_help += out_.str();
  for (const char* command :
       {"upload", "meshes", "info", "delete", "field", "path", "isolines",
        "matrix", "nearest", "sample", "logmap", "capabilities"}) {
    out_.str("");
    Parse({command, "--help"});
    EXPECT_THAT(out_.str(), HasSubstr("Examples:\n  geodesic ")) << command;
    all_help += out_.str();
  }
  std::istringstream lines(all_help);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 80) << line;
  }
}

}  // namespace
}  // namespace geodesic::client
