#include "client/cli/command_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace geodesic::client {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class CommandLineTest : public ::testing::Test {
 protected:
  void SetUp() override { unsetenv("GEODESIC_SERVER"); }

  std::variant<CommandLine, ExitCode> Parse(std::vector<const char*> words) {
    words.insert(words.begin(), "geodesic");
    return ParseCommandLine(static_cast<int>(words.size()), words.data(), out_,
                            err_);
  }

  CommandLine Accepted(const std::vector<const char*>& words) {
    std::variant<CommandLine, ExitCode> parsed = Parse(words);
    EXPECT_TRUE(std::holds_alternative<CommandLine>(parsed)) << err_.str();
    return std::holds_alternative<CommandLine>(parsed)
               ? std::get<CommandLine>(parsed)
               : CommandLine{};
  }

  // What is said about a command line that is refused as wrong usage.
  std::string Refused(const std::vector<const char*>& words) {
    err_.str("");
    std::variant<CommandLine, ExitCode> parsed = Parse(words);
    EXPECT_TRUE(std::holds_alternative<ExitCode>(parsed));
    if (std::holds_alternative<ExitCode>(parsed)) {
      EXPECT_EQ(std::get<ExitCode>(parsed), ExitCode::kUsage);
    }
    return err_.str();
  }

  std::ostringstream out_;
  std::ostringstream err_;
};

// CLI11 2.4 (Debian 13) takes -k and --k for one option and refuses the second.
TEST_F(CommandLineTest, NoOptionIsShortAndLong) {
  const manual::Page program = ProgramPage();
  ASSERT_FALSE(program.commands.empty());
  for (const manual::Page& command : program.commands) {
    std::set<std::string> names;
    for (const manual::Option& option : command.options) {
      for (const std::string& name : option.names) {
        EXPECT_TRUE(
            names.insert(name.substr(name.find_first_not_of('-'))).second)
            << command.name << " " << name;
      }
    }
  }
}

// The others are run in tests/integration.
TEST_F(CommandLineTest, OptionsComeBeforeAndAfterWhatTheyAreAbout) {
  Accepted({"field",       "--source", "3",      "-s",         "7:0.5",
            "horse.ply",   "-o",       "a.npy",  "-o",         "b.PNG",
            "--algorithm", "ich",      "--view", "-30,20",     "--size",
            "640x480",     "--up",     "z",      "--priority", "batch"});
  Accepted({"view", "a.obj", "--no-browser", "--page", "https://a.example"});
  Accepted({"upload", "a.obj", "b.obj", "--format", "stl"});
  Accepted({"field", "m", "--source", "edge:3-8@0.25:2", "--source",
            "face:5@0.2,0.3,0.5", "--curve", "1;edge:1-2@0.5:0.5", "--sources",
            "a.txt", "--target", "face:0@1,0,0", "--targets", "-",
            "--stop-at-targets"});
}

TEST_F(CommandLineTest, CommonOptions) {
  const CommandLine line = Accepted({"meshes", "--timeout", "2.5", "--quiet"});
  EXPECT_EQ(line.timeout, 2.5);
  EXPECT_TRUE(line.quiet);
  const CommandLine plain = Accepted({"meshes"});
  EXPECT_EQ(plain.connection.server, "");
  EXPECT_FALSE(plain.timeout.has_value());
  EXPECT_FALSE(plain.json);
  EXPECT_FALSE(plain.quiet);
}

TEST_F(CommandLineTest, Connection) {
  const CommandLine line = Accepted(
      {"--tls-ca", "ca.pem", "--tls-cert", "c.pem", "--tls-key", "k.pem",
       "--tls-server-name", "n", "--token-file", "t", "meshes"});
  const ConnectionArguments& connection = line.connection;
  EXPECT_EQ(connection.paths.authorities, "ca.pem");
  EXPECT_EQ(connection.paths.certificate, "c.pem");
  EXPECT_EQ(connection.paths.key, "k.pem");
  EXPECT_EQ(connection.server_name, "n");
  EXPECT_EQ(connection.token_file, "t");
  EXPECT_FALSE(connection.tls);
  EXPECT_TRUE(Accepted({"--tls", "meshes"}).connection.tls);
}

// What else is refused of questions is in wrong_arguments_test.cc.
TEST_F(CommandLineTest, ProgressiveFieldsAreDistancesInCsv) {
  const std::vector<std::pair<std::vector<const char*>, std::string>> table = {
      {{"-o", "a.npy"}, "a.npy"},
      {{"--gradients"}, "--gradients"},
      {{"--json"}, "-o FILE.csv"}};
  for (const auto& [more, said] : table) {
    std::vector<const char*> words = {"field", "m", "-s", "1", "--progressive"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_THAT(Refused(words), HasSubstr(said));
  }
}

TEST_F(CommandLineTest, FloatsGoToNoFileOfDoubles) {
  EXPECT_THAT(
      Refused({"field", "m", "-s", "1", "--float32", "-o", "a.f64"}),
      HasSubstr("--float32: a.f64 holds numbers of 64 bits: write .f32"));
  Accepted({"field", "m", "-s", "1", "--float32", "-o", "a.f32"});
}

TEST_F(CommandLineTest, WhatIsAskedForHasAFileThatHoldsIt) {
  for (const char* quantity :
       {"--nearest-sources", "--gradients", "--certified-errors"}) {
    EXPECT_THAT(Refused({"field", "m", "-s", "1", quantity, "-o", "a.npy"}),
                HasSubstr("no -o FILE holds that"))
        << quantity;
    Accepted({"field", "m", "-s", "1", quantity, "-o", "a.npy", "-o", "a.vtk"});
  }
  Accepted({"field", "m", "-s", "1", "--nearest-sources", "-o", "a.png"});
  Refused({"field", "m", "-s", "1", "--gradients", "-o", "a.png"});
}

TEST_F(CommandLineTest, StandardInputIsReadOnce) {
  for (const char* question : {"field", "path", "matrix", "nearest"}) {
    for (const char* other : {"--targets", "--sources"}) {
      EXPECT_THAT(
          Refused({question, "m", "-t", "1", "--sources", "-", other, "-"}),
          HasSubstr("--sources, --targets: standard input (-) can be read by "
                    "one of them only"));
    }
    Accepted({question, "m", "-t", "1", "--sources", "-", "--targets", "f"});
  }
}

TEST_F(CommandLineTest, AFileTakesOneAnswer) {
  for (const char* again : {"a.npy", "./a.npy", "b/../a.npy"}) {
    EXPECT_THAT(Refused({"field", "m", "-s", "1", "-o", "a.npy", "-o", again}),
                HasSubstr(std::string(again) + " is named twice"));
  }
  Accepted({"field", "m", "-s", "1", "-o", "a.npy", "-o", "b/a.npy"});
}

TEST_F(CommandLineTest, CommonOptionsMayComeBeforeOrAfterTheCommand) {
  EXPECT_EQ(Accepted({"--server", "a:1", "meshes"}).connection.server, "a:1");
  EXPECT_EQ(Accepted({"meshes", "--server", "a:1"}).connection.server, "a:1");
  EXPECT_TRUE(Accepted({"--json", "meshes"}).json);
  EXPECT_TRUE(Accepted({"meshes", "--json"}).json);
}

TEST_F(CommandLineTest, ServerFromTheEnvironmentYieldsToTheOption) {
  setenv("GEODESIC_SERVER", "env:7", 1);
  EXPECT_EQ(Accepted({"meshes"}).connection.server, "env:7");
  EXPECT_EQ(Accepted({"meshes", "--server", "a:1"}).connection.server, "a:1");
  unsetenv("GEODESIC_SERVER");
}

TEST_F(CommandLineTest, WrongValuesAreNamed) {
  for (const auto& [option, value, kind] :
       {std::tuple{"--view", "1", "view: AZIMUTH,ELEVATION"},
        {"--view", "0,91", "view: AZIMUTH,ELEVATION"},
        {"--size", "63x100", "size: WIDTHxHEIGHT"},
        {"--size", "100x99999", "size: WIDTHxHEIGHT"},
        {"--lambda", "0", "time to spread: a number above 0"}}) {
    EXPECT_THAT(Refused({"field", "m", "-s", "1", option, value}),
                HasSubstr(std::string("'") + value + "' is not a " + kind));
  }
  for (const char* timeout : {"0", "-1", "nan", "", "soon"}) {
    EXPECT_THAT(Refused({"meshes", "--timeout", timeout}),
                HasSubstr("is not a time: a number of seconds above 0\n"));
  }
}

TEST_F(CommandLineTest, WrongServersAreNamedAtOnce) {
  for (const char* server :
       {"", "localhost", ":99999", "http://", "http://localhost:50051",
        "localhost:", "localhost:0", "localhost:99999", "a b:1", "1:2:3", ":1",
        "[::1]", "dns:///localhost:1"}) {
    EXPECT_THAT(
        Refused({"meshes", "--server", server}),
        HasSubstr(std::string("'") + server + "' is not a server: HOST:PORT"));
    setenv("GEODESIC_SERVER", server, 1);
    if (*server != '\0') Refused({"meshes"});
    unsetenv("GEODESIC_SERVER");
  }
  EXPECT_EQ(Accepted({"--server", "[::1]:5", "meshes"}).connection.server,
            "[::1]:5");
  EXPECT_EQ(Accepted({"--server", "unix:/a", "meshes"}).connection.server,
            "unix:/a");
}

TEST_F(CommandLineTest, TlsNeedsAServersNameAndATokenDoesNot) {
  EXPECT_EQ(ExitCodeOf(ReadConnection({.tls = true}).status()),
            ExitCode::kFile);
  EXPECT_TRUE(ReadConnection({.server = "a:1", .tls = true}).ok());
  EXPECT_TRUE(ReadConnection({.token = "t"}).ok());
  EXPECT_FALSE(ReadConnection({.server = "a:1", .token = "t"}).ok());
}

TEST_F(CommandLineTest, MissingPartsAreNamed) {
  EXPECT_THAT(Refused({"server"}), HasSubstr("ACTION"));
  EXPECT_THAT(Refused({"server", "start"}), HasSubstr("status or stop"));
  EXPECT_THAT(Refused({}), HasSubstr("subcommand"));
  EXPECT_THAT(Refused({"upload"}), HasSubstr("FILE"));
}

TEST_F(CommandLineTest, TyposAreAnsweredByWhatWasMeant) {
  EXPECT_THAT(Refused({"fild", "m", "-s", "1"}),
              HasSubstr("there is no command fild; did you mean field?"));
  for (const auto& [typed, meant] : {std::pair{"feild", "field"},
                                     {"izolines", "isolines"},
                                     {"pathh", "path"}}) {
    EXPECT_THAT(Refused({typed}),
                HasSubstr(std::string("did you mean ") + meant + "?"));
  }
  EXPECT_THAT(Refused({"explode"}), HasSubstr("no command explode\n"));
  EXPECT_THAT(Refused({"field", "m", "--sorce", "3"}),
              HasSubstr("--sorce 3; did you mean --source?"));
  EXPECT_THAT(Refused({"field", "m", "-s", "1", "--sever=a:1"}),
              HasSubstr("--sever=a:1; did you mean --server?"));
}

TEST_F(CommandLineTest, HelpFitsATerminalAndHasExamples) {
  // What is printed by a command line that ends well at once.
  const auto text = [this](const std::vector<const char*>& words) {
    out_.str("");
    std::variant<CommandLine, ExitCode> parsed = Parse(words);
    EXPECT_EQ(std::get<ExitCode>(parsed), ExitCode::kOk);
    return out_.str();
  };
  EXPECT_THAT(text({"--version"}), HasSubstr("geodesic 0."));
  EXPECT_THAT(text({"--help"}), HasSubstr("Exit codes:"));
  EXPECT_THAT(text({"field", "--help"}), HasSubstr("POINT[:OFFSET]"));
  EXPECT_EQ(text({"help"}), text({"--help"}));
  EXPECT_EQ(text({"help", "field"}), text({"field", "--help"}));
  EXPECT_THAT(Refused({"help", "fild"}),
              HasSubstr("no command fild; did you mean field?"));
  std::string all_help = text({"--help"});
  for (const char* command :
       {"upload", "meshes", "info", "delete", "distance", "field", "path",
        "isolines", "matrix", "nearest", "sample", "logmap", "capabilities"}) {
    const std::string help = text({command, "--help"});
    EXPECT_THAT(help, HasSubstr("Examples:\n  geodesic ")) << command;
    all_help += help;
  }
  std::istringstream lines(all_help);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 80) << line;
  }
}

}  // namespace
}  // namespace geodesic::client
