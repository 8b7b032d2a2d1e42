// A geodesicd of a test's own, and the command pointed at it.

#ifndef GEODESIC_TESTS_INTEGRATION_RUNNING_SERVER_H_
#define GEODESIC_TESTS_INTEGRATION_RUNNING_SERVER_H_

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tests/client/temporary_folder.h"
#include "tests/integration/process.h"

namespace geodesic::client {

class RunningServer {
 public:
  // Starts it, on a free loopback port unless the flags have --listen, and
  // waits until it serves. Its log is
  // added to server.log in the folder.
  // Errors: throws std::runtime_error if it ends first, or takes a minute.
  explicit RunningServer(const TemporaryFolder& folder,
                         const std::vector<std::string>& flags = {},
                         const std::string& program = GEODESICD_BINARY);

  // "127.0.0.1:PORT", or "unix:PATH".
  const std::string& address() const { return address_; }

  pid_t id() const { return process_->id(); }

  // Asks it to stop.
  void Terminate() const;

  // Ends it at once, as the kernel does with those that take too much memory.
  void Kill();
  // Asks it to read its tokens again.
  void Reload() const;

  // Its exit code, once it has ended.
  int Wait() { return process_->Wait().exit_code; }

 private:
  std::string address_;
  std::optional<Process> process_;
};

// A server, and a folder for files.
class IntegrationTest : public ::testing::Test {
 protected:
  // Runs `geodesic --server ... arguments`.
  ProcessResult Geodesic(const std::vector<std::string>& arguments) const;

  // The same with --json; what it printed.
  nlohmann::json GeodesicJson(const std::vector<std::string>& arguments,
                              int expected_exit_code = 0) const;

  // What it says when it ends with this code.
  std::string Refusal(const std::vector<std::string>& arguments,
                      int exit_code = 2) const;

  // Its command line, to start it otherwise.
  std::vector<std::string> CommandLine(
      const std::vector<std::string>& arguments) const;

  TemporaryFolder folder_;
  RunningServer server_{folder_};
};

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_INTEGRATION_RUNNING_SERVER_H_
