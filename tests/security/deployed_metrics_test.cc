// What the dashboard, the alarms and the manual name is what a server shows.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>
#include <vector>

#include "digest/sha256.h"
#include "tests/integration/meshes.h"
#include "tests/security/secure_fixture.h"
#include "tests/support/http_get.h"

namespace geodesic::client {
namespace {

using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;

std::set<std::string> Matches(const std::string& text,
                              const std::string& pattern) {
  std::set<std::string> found;
  const std::regex regex(pattern);
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end;
       ++it) {
    found.insert((*it)[1]);
  }
  return found;
}

// Histograms are named by what Prometheus makes of them.
std::set<std::string> NamedIn(const std::string& file) {
  return Matches(FileBytes(PROJECT_FOLDER "/" + file),
                 "(geodesic_[a-z_]+?)(_bucket|_sum|_count)?\\b");
}

// A server with everything that has metrics, after something of each kind.
class DeployedMetricsTest : public SecureTest {
 protected:
  DeployedMetricsTest() {
    WriteFile(tokens_, R"({"tokens": [{"name": "tester", "scopes": ["admin"],
                           "sha256": ")" +
                           Sha256Hex("good-token") + R"("}]})");
    std::vector<std::string> flags = TlsFlags(identity_);
    flags.insert(flags.end(),
                 {"--token-file", tokens_, "--data-dir", folder_ / "data",
                  "--metrics-listen", "127.0.0.1:0",
                  // Nobody answers there, which has metrics, too.
                  "--shared-tier", "unix:" + (folder_ / "redis")});
    const RunningServer server(folder_, flags);
    std::smatch port;
    const std::string log = FileBytes(folder_ / "server.log");
    EXPECT_TRUE(
        std::regex_search(log, port, std::regex("metrics on port (\\d+)")));
    Client client = Connect(server, "good-token");
    const auto upload = client.UploadArrays(PlanarGrid(200));
    EXPECT_TRUE(upload.ok()) << upload.status();
    EXPECT_TRUE(client
                    .ComputeField({.mesh_digest = upload->mesh.digest,
                                   .sources = {{VertexPoint{0}}}})
                    .ok());
    EXPECT_FALSE(Connect(server, "bad-token").ListMeshes().ok());
    server.Reload();
    // The last to be counted: a request ends after its answer, a job too.
    EXPECT_TRUE(Until([&] {
      shown_ = Matches(geodesic::test::HttpGet(std::stoi(port[1]), "/metrics"),
                       "# TYPE (geodesic_[a-z_]+) ");
      return shown_.contains("geodesic_token_reloads_total") &&
             shown_.contains("geodesic_errors_total") &&
             shown_.contains("geodesic_stream_seconds") &&
             shown_.contains("geodesic_job_run_seconds");
    })) << ::testing::PrintToString(shown_);
  }

  const std::string tokens_ = folder_ / "tokens.json";
  std::set<std::string> shown_;  // families of the page
};

TEST_F(DeployedMetricsTest, AreThere) {
  for (const char* file :
       {"deploy/grafana-dashboard.json", "deploy/prometheus-alerts.yaml",
        "docs/operations.md"}) {
    const std::set<std::string> named = NamedIn(file);
    EXPECT_THAT(named, Not(IsEmpty()));
    EXPECT_THAT(shown_, IsSupersetOf(named)) << file;
  }
}

TEST_F(DeployedMetricsTest, AreInTheManual) {
  EXPECT_THAT(NamedIn("docs/operations.md"), IsSupersetOf(shown_));
}

}  // namespace
}  // namespace geodesic::client
