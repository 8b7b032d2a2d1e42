// Who gets through to a server that speaks TLS, and with which certificates.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/integration/process.h"
#include "tests/security/secure_fixture.h"

namespace geodesic::client {
namespace {

using ::testing::HasSubstr;

ConnectionOptions Trusting(const TlsPaths& paths) {
  absl::StatusOr<TlsOptions> tls = ReadTlsFiles(paths);
  EXPECT_TRUE(tls.ok()) << tls.status();
  return {.tls = *tls};
}

class TlsTest : public SecureTest {
 protected:
  absl::Status Ask(const RunningServer& server,
                   const ConnectionOptions& options) const {
    return Client(server.address(), options).ListMeshes().status();
  }

  // geodesicd with flags under which it does not start; what it says.
  std::string Refusal(std::vector<std::string> flags) const {
    flags.insert(flags.begin(), GEODESICD_BINARY);
    const ProcessResult result = RunProgram(flags);
    EXPECT_NE(result.exit_code, 0);
    return result.err;
  }
};

TEST_F(TlsTest, ClientsThatTrustTheAuthorityAreServed) {
  const RunningServer server(folder_, TlsFlags(identity_));
  EXPECT_TRUE(Ask(server, Trusting({.authorities = authority_.path()})).ok());
  // By the other name in the certificate.
  ConnectionOptions options = Trusting({.authorities = authority_.path()});
  options.tls->server_name = "meshes.test";
  EXPECT_TRUE(Ask(server, options).ok());
}

TEST_F(TlsTest, OthersAreNot) {
  const RunningServer server(folder_, TlsFlags(identity_));
  const Authority stranger(folder_, "stranger");
  EXPECT_TRUE(absl::IsUnavailable(
      Ask(server, Trusting({.authorities = stranger.path()}))));
  // In clear to a TLS port.
  EXPECT_TRUE(absl::IsUnavailable(Ask(server, {})));
  // The certificate has another name.
  ConnectionOptions options = Trusting({.authorities = authority_.path()});
  options.tls->server_name = "elsewhere.test";
  EXPECT_TRUE(absl::IsUnavailable(Ask(server, options)));
}

TEST_F(TlsTest, WithClientAuthoritiesACertificateIsNeeded) {
  const Authority clients(folder_, "clients");
  const Identity friendly = clients.Issue("friend");
  const Identity foreign = authority_.Issue("foreign");
  std::vector<std::string> flags = TlsFlags(identity_);
  flags.insert(flags.end(), {"--tls-client-ca", clients.path()});
  const RunningServer server(folder_, flags);
  const auto with = [&](const Identity& identity) {
    return Trusting({.authorities = authority_.path(),
                     .certificate = identity.certificate,
                     .key = identity.key});
  };
  EXPECT_TRUE(Ask(server, with(friendly)).ok());
  EXPECT_TRUE(absl::IsUnavailable(Ask(server, with(foreign))));
  EXPECT_TRUE(absl::IsUnavailable(
      Ask(server, Trusting({.authorities = authority_.path()}))));
}

TEST_F(TlsTest, AChangedCertificateIsTakenUpWhileConnectionsLive) {
  const RunningServer server(folder_, TlsFlags(identity_));
  Client old_client(server.address(),
                    Trusting({.authorities = authority_.path()}));
  ASSERT_TRUE(old_client.ListMeshes().ok());

  const Authority next(folder_, "next");
  const Identity renewed = next.Issue("server");
  std::filesystem::rename(renewed.key, identity_.key);
  std::filesystem::rename(renewed.certificate, identity_.certificate);
  EXPECT_TRUE(Until([&] {
    return Ask(server, Trusting({.authorities = next.path()})).ok();
  }));
  EXPECT_TRUE(absl::IsUnavailable(
      Ask(server, Trusting({.authorities = authority_.path()}))));
  // The connection that was open goes on.
  EXPECT_TRUE(old_client.ListMeshes().ok());
}

TEST_F(TlsTest, FilesThatDoNotFitHarmNobody) {
  const RunningServer server(folder_, TlsFlags(identity_));
  const ConnectionOptions trusting =
      Trusting({.authorities = authority_.path()});
  const std::string whole = FileBytes(identity_.certificate);
  // gRPC itself aborts where it finds a file empty.
  WriteFile(identity_.certificate, "");
  EXPECT_TRUE(LogSays(identity_.certificate + " holds no certificate"));
  EXPECT_TRUE(Ask(server, trusting).ok());
  // What never ends, as by a wrong link.
  std::filesystem::remove(identity_.certificate);
  std::filesystem::create_symlink("/dev/zero", identity_.certificate);
  EXPECT_TRUE(LogSays("File too large"));
  EXPECT_TRUE(Ask(server, trusting).ok());
  std::filesystem::remove(identity_.certificate);
  // A chain that is not written to its end.
  WriteFile(identity_.certificate,
            whole + FileBytes(authority_.path()).substr(0, 300));
  EXPECT_TRUE(
      LogSays(identity_.certificate + " holds a certificate that is cut"));
  EXPECT_TRUE(Ask(server, trusting).ok());
  // The first of two files that are renewed.
  const Authority next(folder_, "next");
  const Identity renewed = next.Issue("renewed");
  WriteFile(identity_.certificate, FileBytes(renewed.certificate));
  EXPECT_TRUE(LogSays("is not the key of the certificate"));
  EXPECT_TRUE(Ask(server, trusting).ok());
  std::filesystem::remove(identity_.key);
  EXPECT_TRUE(LogSays("cannot read " + identity_.key));
  EXPECT_TRUE(Ask(server, trusting).ok());

  WriteFile(identity_.key, FileBytes(renewed.key));
  EXPECT_TRUE(Until([&] {
    return Ask(server, Trusting({.authorities = next.path()})).ok();
  }));
  EXPECT_TRUE(absl::IsUnavailable(Ask(server, trusting)));
}

TEST_F(TlsTest, TheCommandSpeaksTls) {
  const RunningServer server(folder_, TlsFlags(identity_));
  const ProcessResult good =
      RunProgram({GEODESIC_BINARY, "--server", server.address(), "--tls-ca",
                  authority_.path(), "meshes"});
  EXPECT_EQ(good.exit_code, 0) << good.err;
  const Authority stranger(folder_, "stranger");
  const ProcessResult bad =
      RunProgram({GEODESIC_BINARY, "--server", server.address(), "--tls-ca",
                  stranger.path(), "meshes"});
  EXPECT_EQ(bad.exit_code, 7);
  EXPECT_THAT(bad.err, HasSubstr("--tls-ca"));
}

TEST_F(TlsTest, TheCommandSaysWhyThereIsNoConnection) {
  const RunningServer server(folder_, TlsFlags(identity_));
  const Identity other = authority_.Issue("other");
  struct Case {
    std::vector<std::string> flags;
    std::string hint;
  };
  for (const Case& wrong : std::vector<Case>{
           {{}, "--tls-ca speaks TLS"},
           {{"--tls-ca", authority_.path(), "--tls-server-name", "else.test"},
            "--tls-server-name"},
           {{"--tls-ca", identity_.key}, "a file of TLS cannot be used"},
           {{"--tls-ca", authority_.path(), "--tls-cert", identity_.certificate,
             "--tls-key", other.key},
            "a file of TLS cannot be used"}}) {
    std::vector<std::string> command = {GEODESIC_BINARY, "--server",
                                        server.address()};
    command.insert(command.end(), wrong.flags.begin(), wrong.flags.end());
    command.push_back("meshes");
    const ProcessResult result = RunProgram(command);
    EXPECT_EQ(result.exit_code, 7) << wrong.hint;
    EXPECT_THAT(result.err, HasSubstr(wrong.hint));
  }
  const Authority clients(folder_, "clients");
  std::vector<std::string> flags = TlsFlags(identity_);
  flags.insert(flags.end(), {"--tls-client-ca", clients.path()});
  const RunningServer closed(folder_, flags);
  const ProcessResult result =
      RunProgram({GEODESIC_BINARY, "--server", closed.address(), "--tls-ca",
                  authority_.path(), "meshes"});
  EXPECT_THAT(result.err, HasSubstr("--tls-client-ca"));
}

TEST_F(TlsTest, WrongFilesAreNamedAtTheStart) {
  const Identity other = authority_.Issue("other");
  const std::string& certificate = identity_.certificate;
  EXPECT_THAT(Refusal({"--tls-cert", certificate, "--tls-key", other.key}),
              HasSubstr("is not the key"));
  EXPECT_THAT(Refusal({"--tls-cert", certificate, "--tls-key", certificate}),
              HasSubstr("no unencrypted private key"));
  EXPECT_THAT(Refusal({"--tls-cert", folder_ / "none", "--tls-key", other.key}),
              HasSubstr(folder_ / "none"));
}

TEST_F(TlsTest, AnExpiredCertificateIsToldAtTheStart) {
  const Identity expired = MakeExpired(folder_);
  const RunningServer server(folder_, TlsFlags(expired));
  EXPECT_THAT(FileBytes(folder_ / "server.log"),
              HasSubstr(expired.certificate + " has expired"));
}

}  // namespace
}  // namespace geodesic::client
