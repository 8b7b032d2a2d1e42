// The command `geodesic`.

#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <ostream>
#include <stop_token>
#include <streambuf>
#include <string>
#include <thread>
#include <utility>
#include <variant>

#include "absl/strings/str_cat.h"
#include "client/cli/command_line.h"
#include "client/cli/own_server/own_server.h"
#include "client/cli/terminal/text.h"
#include "geodesic_client/errors.h"

namespace geodesic::client {
namespace {

// Buffers what is written to standard output. The stream is bad once a write
// has failed, and Finish says why. If the reader of a pipe closes its end,
// SIGPIPE ends the process, as with most tools. Not thread-safe.
class StandardOutput : private std::streambuf {
 public:
  // Opens /dev/null, for reading only, in place of a closed standard input,
  // output or error. Otherwise a file or connection would take its number.
  StandardOutput() {
    int descriptor = 0;
    while ((descriptor = open("/dev/null", O_RDONLY | O_CLOEXEC)) >= 0 &&
           descriptor <= STDERR_FILENO) {
    }
    close(descriptor);
    setp(buffer_.data(), buffer_.data() + buffer_.size());
  }

  std::ostream& stream() { return stream_; }

  // Writes what is buffered and closes standard output.
  // Errors: those of the first write that failed.
  absl::Status Finish() {
    sync();
    if (close(STDOUT_FILENO) != 0 && error_ == 0) error_ = errno;
    return error_ == 0
               ? absl::OkStatus()
               : absl::ErrnoToStatus(error_, "cannot write standard output");
  }

 private:
  int_type overflow(int_type c) override {
    if (sync() != 0) return traits_type::eof();
    return traits_type::eq_int_type(c, traits_type::eof())
               ? traits_type::not_eof(c)
               : sputc(traits_type::to_char_type(c));
  }

  int sync() override {
    for (const char* next = pbase(); error_ == 0 && next != pptr();) {
      const ssize_t count =
          write(STDOUT_FILENO, next, static_cast<size_t>(pptr() - next));
      if (count >= 0) {
        next += count;
      } else if (errno != EINTR) {
        error_ = errno;
      }
    }
    setp(buffer_.data(), buffer_.data() + buffer_.size());
    return error_ == 0 ? 0 : -1;
  }

  std::array<char, 1 << 16> buffer_;
  // errno of the first write that failed.
  int error_ = 0;
  std::ostream stream_{this};
};

// While it lives, SIGINT, SIGTERM and SIGHUP request a stop instead of ending
// the process; a later one ends it at once with exit code 130. Those that are
// ignored stay so, as nohup and a shell's background want. It must be made
// before any other thread, since that would otherwise take the signals.
class InterruptListener {
 public:
  InterruptListener() {
    // This thread and those made from it block the signals, so that they wait
    // for sigwait.
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, kWake);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
      struct sigaction before = {};
      sigaction(signal, nullptr, &before);
      if (before.sa_handler != SIG_IGN) sigaddset(&signals, signal);
    }
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    thread_ = std::thread([this, signals] {
      int signal = 0;
      Clock::time_point first;
      while (sigwait(&signals, &signal) == 0 && signal != kWake) {
        if (source_.request_stop()) {
          first = Clock::now();
        } else if (Clock::now() - first > kOneInterrupt) {
          _exit(static_cast<int>(ExitCode::kInterrupted));
        }
      }
    });
  }
  ~InterruptListener() {
    pthread_kill(thread_.native_handle(), kWake);
    thread_.join();
  }
  InterruptListener(const InterruptListener&) = delete;
  InterruptListener& operator=(const InterruptListener&) = delete;

  std::stop_token stop() const { return source_.get_token(); }

 private:
  using Clock = std::chrono::steady_clock;

  // Who sends a signal to a process and to its group, as timeout(1) does, means
  // one: what is under way is still cleared away.
  static constexpr std::chrono::milliseconds kOneInterrupt{500};
  // Serves only to end the thread.
  static constexpr int kWake = SIGUSR1;

  std::stop_source source_;
  std::thread thread_;
};

int TerminalWidth() {
  winsize size = {};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0
             ? size.ws_col
             : 80;
}

ProgressDisplay::Style ProgressStyle(bool quiet) {
  if (quiet) return ProgressDisplay::Style::kNone;
  return isatty(STDERR_FILENO) != 0 ? ProgressDisplay::Style::kBar
                                    : ProgressDisplay::Style::kLines;
}

// {"code": "NOT_FOUND", "reason": ..., "message": ..., "exit_code": 5}.
Json ErrorToJson(const absl::Status& status, ExitCode exit_code) {
  return {{"code", absl::StatusCodeToString(status.code())},
          {"reason", ErrorReason(status)},
          {"message", std::string(status.message())},
          {"exit_code", static_cast<int>(exit_code)}};
}

// What a command's error means when its server was started by `geodesic`: that
// it may have ended meanwhile.
absl::Status WithFateOf(const OwnServer& server, pid_t process,
                        absl::Status status) {
  if (!absl::IsUnavailable(status) && !absl::IsCancelled(status)) return status;
  if (server.Running() == process) return status;
  return NoServer(absl::UnavailableError(
      absl::StrCat("the server that geodesic had started ended in the middle (",
                   status.message(), "; its log is ", server.log_path(),
                   "): run the command again, which starts another")));
}

// Sets `server` to the address of the server that was asked.
absl::Status RunCommand(const CommandLine& line, std::string* server,
                        Json* json, std::ostream& out) {
  InterruptListener interrupt;
  absl::StatusOr<ConnectionOptions> connection =
      ReadConnection(line.connection);
  if (!connection.ok()) return connection.status();
  CallOptions call = {.stop = interrupt.stop()};
  if (line.timeout.has_value()) {
    call.timeout = std::chrono::duration<double>(*line.timeout);
  }
  std::optional<OwnServer> own;
  std::optional<pid_t> process;
  if (server->empty() || line.command.is_about_own_server) {
    absl::StatusOr<OwnServer> opened = OwnServer::Open();
    if (!opened.ok()) return opened.status();
    own = *std::move(opened);
    *server = own->address();
  }
  if (own.has_value() && !line.command.is_about_own_server) {
    const absl::StatusOr<pid_t> started =
        AwaitOwnServer(*own, line.command.needs_page, call);
    if (call.stop.stop_requested()) return Interrupted();
    if (!started.ok()) return started.status();
    process = *started;
  }
  std::optional<PageFiles> page;
  if (process.has_value() && line.command.needs_page) page = own->page();
  Client client(*server, *std::move(connection));
  absl::Status status =
      line.command.run({.client = client,
                        .server = *server,
                        .call = call,
                        .json = line.json ? json : nullptr,
                        .quiet = line.quiet,
                        .out = out,
                        .err = std::cerr,
                        .progress_style = ProgressStyle(line.quiet),
                        // Some terminals wrap after the last column.
                        .terminal_width = TerminalWidth() - 1,
                        .page = page});
  if (absl::IsCancelled(status) && call.stop.stop_requested()) {
    return Interrupted();
  }
  return process.has_value() ? WithFateOf(*own, *process, std::move(status))
                             : status;
}

ExitCode ParseAndRun(int argc, const char* const* argv, std::ostream& out) {
  std::variant<CommandLine, ExitCode> parsed =
      ParseCommandLine(argc, argv, out, std::cerr);
  if (const auto* ended = std::get_if<ExitCode>(&parsed)) return *ended;
  const auto& line = std::get<CommandLine>(parsed);
  Json json = Json::object();
  std::string server = line.connection.server;
  const absl::Status status = RunCommand(line, &server, &json, out);
  // If the output failed, Finish reports it.
  if (!out) return ExitCode::kOk;
  const ExitCode exit_code = status.ok() ? ExitCode::kOk : ExitCodeOf(status);
  // The object keeps the results from before the error.
  if (!status.ok()) json["error"].update(ErrorToJson(status, exit_code));
  if (line.json) PrintJson(json, &out);
  if (!status.ok()) {
    std::cerr << "geodesic: " << Printable(Explain(status, server))
              << std::endl;
  }
  return exit_code;
}

}  // namespace
}  // namespace geodesic::client

int main(int argc, char** argv) {
  using namespace geodesic::client;
  // The command reports failures itself. Users who want gRPC's own log can set
  // the variable.
  setenv("GRPC_VERBOSITY", "NONE", /*overwrite=*/0);
  StandardOutput out;
  ExitCode exit_code = ParseAndRun(argc, argv, out.stream());
  if (const absl::Status status = out.Finish(); !status.ok()) {
    std::cerr << "geodesic: " << std::string(status.message()) << std::endl;
    exit_code = ExitCode::kFile;
  }
  return static_cast<int>(exit_code);
}
