#include "tests/integration/running_server.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace geodesic::client {
namespace {

// Reads the line that the server writes once it serves; throws if it ends
// first, or takes a minute.
std::string ReadLine(int pipe, pid_t server) {
  const auto ended = static_cast<int>(syscall(SYS_pidfd_open, server, 0));
  std::string line;
  while (!line.ends_with('\n')) {
    std::array<pollfd, 2> ready = {{{pipe, POLLIN, 0}, {ended, POLLIN, 0}}};
    char c = 0;
    if (poll(ready.data(), ready.size(), 60'000) <= 0 ||
        (ready[0].revents & POLLIN) == 0 || read(pipe, &c, 1) != 1) {
      throw std::runtime_error("the server does not start");
    }
    line.push_back(c);
  }
  close(ended);
  line.pop_back();
  return line;
}

}  // namespace

RunningServer::RunningServer(const TemporaryFolder& folder,
                             const std::vector<std::string>& flags,
                             const std::string& program) {
  // A named pipe as the port file: reading it waits for the server.
  const std::string port_file = folder / "port";
  if (mkfifo(port_file.c_str(), 0600) != 0) {
    throw std::runtime_error("cannot make a named pipe");
  }
  // Open for writing too, so that it never looks ended before it has begun.
  const int pipe = open(port_file.c_str(), O_RDWR | O_CLOEXEC);
  std::vector<std::string> arguments = {program, "--port-file", port_file};
  if (std::ranges::find(flags, "--listen") == flags.end()) {
    arguments.insert(arguments.end(), {"--listen", "127.0.0.1:0"});
  }
  arguments.insert(arguments.end(), flags.begin(), flags.end());
  process_.emplace(arguments, folder / "server.log");
  const std::string line = ReadLine(pipe, process_->id());
  address_ = (line.starts_with('/') ? "unix:" : "127.0.0.1:") + line;
  close(pipe);
  std::filesystem::remove(port_file);
}

void RunningServer::Terminate() const { process_->Signal(SIGTERM); }

void RunningServer::Kill() {
  process_->Signal(SIGKILL);
  process_->Wait();
}

void RunningServer::Reload() const { process_->Signal(SIGHUP); }

std::vector<std::string> IntegrationTest::CommandLine(
    const std::vector<std::string>& arguments) const {
  std::vector<std::string> words = {GEODESIC_BINARY, "--server",
                                    server_.address()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

ProcessResult IntegrationTest::Geodesic(
    const std::vector<std::string>& arguments) const {
  return RunProgram(CommandLine(arguments));
}

nlohmann::json IntegrationTest::GeodesicJson(
    const std::vector<std::string>& arguments, int expected_exit_code) const {
  std::vector<std::string> words = arguments;
  words.push_back("--json");
  const ProcessResult result = Geodesic(words);
  EXPECT_EQ(result.exit_code, expected_exit_code) << result.err;
  nlohmann::json json = nlohmann::json::parse(result.out, nullptr, false);
  EXPECT_FALSE(json.is_discarded()) << result.out;
  return json;
}

std::string IntegrationTest::Refusal(const std::vector<std::string>& arguments,
                                     int exit_code) const {
  const ProcessResult result = Geodesic(arguments);
  EXPECT_EQ(result.exit_code, exit_code) << result.out << result.err;
  return result.err;
}

}  // namespace geodesic::client
