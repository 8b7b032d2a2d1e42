// geodesicd: the geodesic query server.

#include <fcntl.h>
#include <malloc.h>
#include <pthread.h>
#include <signal.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>

#include "absl/strings/str_cat.h"
#include "server/options/options.h"
#include "server/periodic.h"
#include "server/server.h"
#include "server/unix_socket.h"

namespace geodesic::server {
namespace {

constexpr int kCannotStart = 1;
constexpr int kRequestsCancelled = 3;

// The signals that ProcessSignals handles.
sigset_t WatchedSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGHUP);
  return signals;
}

// While it lives, calls `received` for each of these signals, from an ordinary
// thread, where any function may be called.
// REQUIRES: the signals are blocked in every thread.
class ProcessSignals {
 public:
  explicit ProcessSignals(std::function<void(int signal)> received)
      : thread_([received = std::move(received)](const std::stop_token& stop) {
          const sigset_t signals = WatchedSignals();
          for (int signal = 0;;) {
            if (sigwait(&signals, &signal) != 0) continue;
            if (stop.stop_requested()) return;
            received(signal);
          }
        }) {}

  // Waits for a call of `received` that is under way.
  ~ProcessSignals() {
    thread_.request_stop();
    // Wakes sigwait, which then finds the request.
    pthread_kill(thread_.native_handle(), SIGTERM);
  }

 private:
  std::jthread thread_;
};

// Writes the file, if one is named. A pipe that nobody reads is not waited for.
bool WriteLine(const std::string& path, const std::string& line) {
  if (path.empty()) return true;
  const int probe = open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
  if (probe < 0 && errno == ENXIO) return false;
  std::ofstream file(path);
  const bool is_written = static_cast<bool>(file << line << '\n' << std::flush);
  if (probe >= 0) close(probe);
  return is_written;
}

// As many descriptors as this process may have. The soft limit of most systems
// is 1,024, for programs that call select().
void RaiseDescriptorLimit() {
  rlimit limit = {};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  setrlimit(RLIMIT_NOFILE, &limit);
}

int Run(const ServerOptions& options) {
  RaiseDescriptorLimit();
  // Blocked before any thread starts, so every thread inherits it.
  const sigset_t watched = WatchedSignals();
  pthread_sigmask(SIG_BLOCK, &watched, nullptr);
  // Makes a write beyond a file size limit fail instead of ending the server.
  signal(SIGXFSZ, SIG_IGN);
  // The same when whoever reads the log has gone.
  signal(SIGPIPE, SIG_IGN);
  const std::shared_ptr<spdlog::logger> logger =
      spdlog::stderr_color_mt("geodesicd");
  logger->set_level(spdlog::level::from_str(options.log_level));

  // Larger blocks are given back as soon as they are freed. Else glibc raises
  // this to the largest that was freed, up to 32 MiB, and the threads' heaps
  // keep more than all that is counted until the next trim.
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
  Server server(options, logger);
  if (const absl::Status status = server.Start(); !status.ok()) {
    logger->critical("{}", status.ToString());
    return kCannotStart;
  }
  const std::optional<std::string> socket = SocketPath(options.listen);
  // The other file says that the server serves, so it comes last.
  if (!options.web_listen.empty() &&
      !WriteLine(options.web_port_file, std::to_string(server.web_port()))) {
    logger->critical("cannot write --web-port-file {}", options.web_port_file);
    return kCannotStart;
  }
  const std::string port = socket ? *socket : std::to_string(server.port());
  if (!WriteLine(options.port_file, port)) {
    logger->critical("cannot write --port-file {}", options.port_file);
    return kCannotStart;
  }
  const std::string address =
      socket ? options.listen
             : absl::StrCat(options.listen.substr(0, options.listen.rfind(':')),
                            ":", server.port());
  logger->info("geodesicd {} serves on {} {}", ServerVersion(), address,
               options.tls.enabled() ? "over TLS" : "in clear");
  // By itself glibc only gives back free memory at the end of a heap, of which
  // each thread has one. When many readers leave, their messages are freed
  // between smaller allocations that stay, and it would keep a gigabyte for
  // good. A trim takes less than 1 ms when there is little to give back, and
  // about 10 ms for each 100 MiB.
  const std::jthread trimmer =
      Every(std::chrono::seconds(5), [] { malloc_trim(0); });
  const ProcessSignals signals([&](int signal) {
    if (signal == SIGHUP) {
      server.Reload();
    } else {
      server.Shutdown(options.drain);
    }
  });
  switch (server.Wait()) {
    case Server::Ending::kInOrder:
      return EXIT_SUCCESS;
    case Server::Ending::kCancelled:
      break;
    case Server::Ending::kStuck:
      // Nothing is acknowledged that is not on the disk.
      logger->flush();
      std::_Exit(kRequestsCancelled);
  }
  return kRequestsCancelled;
}

}  // namespace
}  // namespace geodesic::server

int main(int argc, char** argv) {
  using geodesic::server::CommandLine;
  const CommandLine command_line = geodesic::server::ParseCommandLine(
      argc, argv, std::string(geodesic::server::ServerVersion()));
  if (command_line.exit_code) return *command_line.exit_code;
  try {
    return geodesic::server::Run(command_line.options);
  } catch (const std::exception& error) {
    spdlog::critical("geodesicd: {}", error.what());
    return geodesic::server::kCannotStart;
  }
}
