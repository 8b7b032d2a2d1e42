// Tokens from the file to the command line, with real programs over TLS.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>
#include <vector>

#include "digest/sha256.h"
#include "geodesic_client/errors.h"
#include "tests/integration/meshes.h"
#include "tests/integration/process.h"
#include "tests/security/secure_fixture.h"

namespace geodesic::client {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class TokensTest : public SecureTest {
 protected:
  // Knows this token alone, which may read. Replaced as a whole, as one should.
  void WriteToken(const std::string& token) const {
    const std::string text = R"({"tokens": [{"name": "owner-of-)" +
                             token.substr(0, 4) + R"(", "sha256": ")" +
                             Sha256Hex(token) + R"(", "scopes": ["read"]})";
    WriteFile(folder_ / "tokens.new", text + "]}");
    std::filesystem::rename(folder_ / "tokens.new", folder_ / "tokens.json");
  }

  std::vector<std::string> Flags() const {
    std::vector<std::string> flags = TlsFlags(identity_);
    flags.insert(flags.end(), {"--token-file", folder_ / "tokens.json"});
    return flags;
  }

  absl::Status Ask(const RunningServer& server,
                   const std::string& token) const {
    return Connect(server, token).ListMeshes().status();
  }

  // The command, over TLS.
  ProcessResult Command(const RunningServer& server,
                        std::vector<std::string> words) const {
    words.insert(words.begin(), {GEODESIC_BINARY, "--server", server.address(),
                                 "--tls-ca", authority_.path()});
    return RunProgram(words);
  }
};

TEST_F(TokensTest, AChangedFileIsTakenUpWhileConnectionsLive) {
  WriteToken("old-token");
  const RunningServer server(folder_, Flags());
  Client client = Connect(server, "old-token");
  ASSERT_TRUE(client.ListMeshes().ok());
  WriteToken("new-token");
  EXPECT_TRUE(Until([&] { return !client.ListMeshes().ok(); }));
  EXPECT_EQ(ErrorReason(client.ListMeshes().status()), "TOKEN_UNKNOWN");
  EXPECT_TRUE(Ask(server, "new-token").ok());
}

TEST_F(TokensTest, ASignalMakesTheServerReadTheFileAgain) {
  WriteToken("good-token");
  const RunningServer server(folder_, Flags());
  server.Reload();
  EXPECT_TRUE(LogSays("read again"));
  EXPECT_TRUE(Ask(server, "good-token").ok());
}

TEST_F(TokensTest, NoTokenGetsIntoTheLog) {
  WriteToken("read-token");
  {
    RunningServer server(folder_, Flags());
    EXPECT_TRUE(Ask(server, "read-token").ok());
    EXPECT_FALSE(Ask(server, "stray-token").ok());
    server.Terminate();
    server.Wait();
  }
  const std::string log = FileBytes(folder_ / "server.log");
  EXPECT_THAT(log, HasSubstr("client=owner-of-read"));
  EXPECT_THAT(log, HasSubstr("reason=TOKEN_UNKNOWN"));
  for (const std::string secret : {"read-token", "stray-token"}) {
    EXPECT_THAT(log, Not(HasSubstr(secret)));
    EXPECT_THAT(log, Not(HasSubstr(Sha256Hex(secret))));
  }
}

TEST_F(TokensTest, TheCommandTakesTokensThreeWays) {
  WriteToken("read-token");
  const RunningServer server(folder_, Flags());
  EXPECT_EQ(Command(server, {"--token", "read-token", "meshes"}).exit_code, 0);
  WriteFile(folder_ / "token", "read-token\n");
  EXPECT_EQ(
      Command(server, {"--token-file", folder_ / "token", "meshes"}).exit_code,
      0);
  setenv("GEODESIC_TOKEN", "read-token", 1);
  EXPECT_EQ(Command(server, {"meshes"}).exit_code, 0);
  unsetenv("GEODESIC_TOKEN");

  const ProcessResult none = Command(server, {"meshes"});
  EXPECT_EQ(none.exit_code, 5);
  EXPECT_THAT(none.err, HasSubstr("--token-file"));
  const ProcessResult missing =
      Command(server, {"--token-file", folder_ / "nothing", "meshes"});
  EXPECT_EQ(missing.exit_code, 3);
  EXPECT_THAT(missing.err, HasSubstr(folder_ / "nothing"));
}

TEST_F(TokensTest, WhatIsNoTokenIsRefused) {
  WriteToken("read-token");
  const RunningServer server(folder_, Flags());
  WriteFile(folder_ / "empty", "");
  for (const char* option : {"--token-file", "--tls-ca"}) {
    const ProcessResult empty =
        RunProgram({GEODESIC_BINARY, option, folder_ / "empty", "meshes"});
    EXPECT_EQ(empty.exit_code, 3) << option;
    EXPECT_THAT(empty.err, HasSubstr(folder_ / "empty"));
  }
  for (const char* text : {"read-token\n", "read\ttoken",
                           "r\xc3\xa9"
                           "ad"}) {
    const ProcessResult bad = Command(server, {"--token", text, "meshes"});
    EXPECT_EQ(bad.exit_code, 3) << text;
    EXPECT_THAT(bad.err, HasSubstr("--token"));
    EXPECT_EQ(ErrorReason(Ask(server, text)), "TOKEN_UNKNOWN") << text;
  }
}

TEST_F(TokensTest, AnEmptiedFileIsReportedAndTheOldTokensStay) {
  WriteToken("read-token");
  const RunningServer server(folder_, Flags());
  WriteFile(folder_ / "tokens.json", "");
  server.Reload();
  EXPECT_TRUE(LogSays("the tokens stay as they were"));
  EXPECT_TRUE(Ask(server, "read-token").ok());
}

TEST_F(TokensTest, APipeInPlaceOfTheFileHoldsNobodyUp) {
  WriteToken("read-token");
  const RunningServer server(folder_, Flags());
  const std::string file = folder_ / "tokens.json";
  std::filesystem::remove(file);
  ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
  EXPECT_TRUE(LogSays("the tokens stay as they were"));
  EXPECT_TRUE(Ask(server, "read-token").ok());
}

TEST_F(TokensTest, AFileIsReadAgainThatLooksAsBefore) {
  const std::filesystem::path file = folder_ / "tokens.json";
  WriteToken("next-token");
  const std::string next = FileBytes(file);
  WriteToken("read-token");
  const RunningServer server(folder_, Flags());
  const auto time = std::filesystem::last_write_time(file);
  WriteFile(file, next);
  std::filesystem::last_write_time(file, time);
  EXPECT_TRUE(Until([&] { return Ask(server, "next-token").ok(); }));
}

TEST_F(TokensTest, TheCommandSendsNoTokenToOthersInClear) {
  for (const char* server : {"meshes.test:1", "127.0.0.1.meshes.test:1"}) {
    const ProcessResult result =
        RunProgram({GEODESIC_BINARY, "--server", server, "--token",
                    "read-token", "meshes"});
    EXPECT_EQ(result.exit_code, 3) << server;
    EXPECT_THAT(result.err, HasSubstr("in clear")) << server;
    EXPECT_THAT(result.err, Not(HasSubstr("read-token")));
  }
}

TEST_F(TokensTest, AMalformedFileKeepsTheServerFromStarting) {
  WriteFile(folder_ / "tokens.json", "{\"tokens\": 1}");
  const ProcessResult result =
      RunProgram({GEODESICD_BINARY, "--listen", "127.0.0.1:0", "--token-file",
                  folder_ / "tokens.json"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("tokens.json"));
}

}  // namespace
}  // namespace geodesic::client
