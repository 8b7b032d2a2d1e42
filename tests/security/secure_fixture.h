// A server that speaks TLS, with certificates made by the openssl command.

#ifndef GEODESIC_TESTS_SECURITY_SECURE_FIXTURE_H_
#define GEODESIC_TESTS_SECURITY_SECURE_FIXTURE_H_

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "absl/status/status.h"
#include "geodesic_client/client.h"
#include "tests/client/temporary_folder.h"
#include "tests/integration/running_server.h"
#include "tests/support/until.h"

namespace geodesic::client {

// Paths of PEM files.
struct Identity {
  std::string certificate;
  std::string key;
};

class Authority {
 public:
  // Makes it in `folder`, which outlives it; `name` begins its files' names.
  Authority(const TemporaryFolder& folder, const std::string& name);

  // A certificate for the DNS name meshes.test and the address 127.0.0.1.
  Identity Issue(const std::string& name) const;

  // Path of its own certificate.
  const std::string& path() const { return own_.certificate; }

 private:
  const TemporaryFolder& folder_;
  const std::string name_;
  const Identity own_;
};

// A certificate of nobody's but its own, whose day has passed.
Identity MakeExpired(const TemporaryFolder& folder);

using geodesic::test::Until;

// A server's identity, and clients that trust its authority.
class SecureTest : public ::testing::Test {
 protected:
  static std::vector<std::string> TlsFlags(const Identity& identity) {
    return {"--tls-cert", identity.certificate, "--tls-key", identity.key};
  }

  Client Connect(const RunningServer& server, const std::string& token) const {
    return Client(server.address(),
                  {.tls = *ReadTlsFiles({.authorities = authority_.path()}),
                   .token = token});
  }

  // Whether the server's log comes to say this.
  bool LogSays(const std::string& words) const {
    return Until([&] {
      return FileBytes(folder_ / "server.log").find(words) != std::string::npos;
    });
  }

  TemporaryFolder folder_;
  const Authority authority_{folder_, "ca"};
  const Identity identity_ = authority_.Issue("server");
};

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_SECURITY_SECURE_FIXTURE_H_
