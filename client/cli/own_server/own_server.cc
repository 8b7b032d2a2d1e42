#include "client/cli/own_server/own_server.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

#include "absl/strings/str_cat.h"
#include "client/cli/own_server/descriptor.h"
#include "client/cli/own_server/launch.h"
#include "client/cli/own_server/runtime_folder.h"
#include "client/cli/terminal/exit_code.h"
#include "digest/sha256.h"

namespace geodesic::client {
namespace {

using std::chrono::steady_clock;

// How long to wait for a server to start, or to end its requests.
constexpr std::chrono::seconds kPatience{60};

// How long a server may take to accept a connection. One that is stopped, by a
// signal or a debugger, accepts none.
constexpr timeval kAccept = {.tv_sec = 1, .tv_usec = 0};

// How often files that cannot be waited for are looked at.
constexpr std::chrono::milliseconds kLook{10};

// How long a server that takes connections may take to answer.
constexpr std::chrono::seconds kAnswer{20};

// Of `most` and the call's timeout the shorter.
steady_clock::duration Within(steady_clock::duration most,
                              const CallOptions& call) {
  const auto timeout =
      call.timeout.value_or(std::chrono::duration<double>(most));
  return timeout < most
             ? std::chrono::duration_cast<steady_clock::duration>(timeout)
             : most;
}

// Servers that end while they are asked, one after the other.
constexpr int kMostTries = 3;

// A wait of a few looks that ends when it is stopped or takes too long.
class Patience {
 public:
  explicit Patience(const CallOptions& call)
      : stop_(call.stop),
        until_(steady_clock::now() + Within(kPatience, call)) {}

  steady_clock::time_point until() const { return until_; }

  // Waits for the next look.
  // Errors: CANCELLED; DEADLINE_EXCEEDED.
  absl::Status Wait() {
    std::unique_lock lock(mutex_);
    never_.wait_for(lock, stop_, kLook, [] { return false; });
    if (stop_.stop_requested()) return absl::CancelledError("stopped");
    return steady_clock::now() < until_
               ? absl::OkStatus()
               : absl::DeadlineExceededError("waited too long");
  }

 private:
  const std::stop_token stop_;
  const steady_clock::time_point until_;
  std::mutex mutex_;
  std::condition_variable_any never_;
};

// A file to be locked, made if it is missing.
absl::StatusOr<Descriptor> OpenLock(const std::string& path) {
  Descriptor file(open(path.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC,
                       S_IRUSR | S_IWUSR));
  if (file.is_open()) return file;
  return absl::ErrnoToStatus(errno, absl::StrCat("cannot open ", path));
}

bool TryLock(const Descriptor& file) {
  return flock(file.get(), LOCK_EX | LOCK_NB) == 0;
}

bool HasEnded(const Descriptor& process) {
  pollfd ended = {process.get(), POLLIN, 0};
  return poll(&ended, 1, 0) == 1;
}

// Tells builds of one version apart; empty if there is no geodesicd.
std::string BuildMark() {
  const absl::StatusOr<std::string> program = FindServerProgram();
  struct stat file = {};
  if (!program.ok() || stat(program->c_str(), &file) != 0) return "";
  const std::string build =
      absl::StrCat(*program, " ", file.st_size, " ", file.st_mtim.tv_sec, " ",
                   file.st_mtim.tv_nsec);
  return "-" + Sha256Hex(build).substr(0, 8);
}

}  // namespace

absl::StatusOr<OwnServer> OwnServer::Open() {
  absl::StatusOr<std::string> folder = RuntimeFolder();
  if (!folder.ok()) return FileError(folder.status());
  OwnServer server(
      absl::StrCat(*folder, "/geodesicd-", GEODESIC_VERSION, BuildMark()));
  if (server.socket_path().size() >= sizeof(sockaddr_un::sun_path)) {
    return FileError(absl::FailedPreconditionError(absl::StrCat(
        server.socket_path(),
        " is too long for a socket: set XDG_RUNTIME_DIR to a folder with a "
        "shorter path, or name a server with --server")));
  }
  return server;
}

std::optional<pid_t> OwnServer::Running() const {
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  std::ranges::copy(socket_path(), address.sun_path);
  const Descriptor probe(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  setsockopt(probe.get(), SOL_SOCKET, SO_SNDTIMEO, &kAccept, sizeof(kAccept));
  if (connect(probe.get(), reinterpret_cast<const sockaddr*>(&address),
              sizeof(address)) != 0) {
    return std::nullopt;
  }
  ucred peer = {};
  socklen_t size = sizeof(peer);
  if (getsockopt(probe.get(), SOL_SOCKET, SO_PEERCRED, &peer, &size) != 0) {
    return std::nullopt;
  }
  return peer.pid;
}

absl::StatusOr<pid_t> OwnServer::Start(std::optional<pid_t> ending,
                                       bool needs_page,
                                       const CallOptions& call) const {
  if (needs_page && !page().Url() && Running()) {
    ending = Running();
    const absl::StatusOr<bool> stopped = Stop(call);
    if (!stopped.ok()) return NoServer(stopped.status());
  }
  const auto usable = [&]() -> std::optional<pid_t> {
    const std::optional<pid_t> process = Running();
    return process == ending ? std::nullopt : process;
  };
  if (const auto process = usable()) return *process;
  const absl::StatusOr<std::string> program = FindServerProgram();
  if (!program.ok()) return NoServer(program.status());
  const absl::StatusOr<Descriptor> starting = OpenLock(stem_ + ".starting");
  if (!starting.ok()) return NoServer(starting.status());
  const absl::StatusOr<Descriptor> alive = OpenLock(stem_ + ".alive");
  if (!alive.ok()) return NoServer(alive.status());
  Patience patience(call);
  bool is_starter = false;
  for (;;) {
    is_starter = is_starter || TryLock(*starting);
    if (const auto process = usable()) return *process;
    if (is_starter && TryLock(*alive)) break;
    const absl::Status status = patience.Wait();
    if (absl::IsCancelled(status)) return NoServer(status);
    if (!status.ok()) {
      return NoServer(absl::UnavailableError(absl::StrCat(
          "a server or a command holds ", stem_,
          is_starter ? ".alive" : ".starting", ", but no server answers at ",
          address(), ": `geodesic server stop` ends one that serves")));
    }
  }
  page().Remove();
  absl::Status status = needs_page ? page().Prepare() : absl::OkStatus();
  if (!status.ok()) return NoServer(status);
  status =
      LaunchServer({.program = *program,
                    .socket_path = socket_path(),
                    .log_path = log_path(),
                    .kept_open = alive->get(),
                    .page = needs_page ? std::optional(page()) : std::nullopt},
                   patience.until(), call.stop);
  if (!status.ok()) return NoServer(status);
  if (const auto process = Running()) return *process;
  return NoServer(absl::UnavailableError(absl::StrCat(
      "the server that was started has ended (its log: ", log_path(), ")")));
}

absl::StatusOr<bool> OwnServer::Stop(const CallOptions& call) const {
  const std::optional<pid_t> process = Running();
  if (!process) {
    const absl::StatusOr<Descriptor> alive = OpenLock(stem_ + ".alive");
    if (!alive.ok() || TryLock(*alive)) return false;
    return absl::UnavailableError(absl::StrCat(
        "a process holds ", stem_, ".alive, but takes no connections: `fuser ",
        stem_, ".alive` says which"));
  }
  const Descriptor handle(
      static_cast<int>(syscall(SYS_pidfd_open, *process, 0)));
  // The number may have become another process's before it was opened.
  if (!handle.is_open() || Running() != process) return false;
  if (syscall(SYS_pidfd_send_signal, handle.get(), SIGTERM, nullptr, 0) != 0) {
    return absl::ErrnoToStatus(errno,
                               absl::StrCat("cannot stop process ", *process));
  }
  Patience patience(call);
  while (!HasEnded(handle)) {
    const absl::Status status = patience.Wait();
    if (absl::IsDeadlineExceeded(status)) {
      return absl::DeadlineExceededError(
          absl::StrCat("process ", *process, " was asked to end, but has not"));
    }
    if (!status.ok()) return status;
  }
  return true;
}

absl::StatusOr<pid_t> AwaitOwnServer(const OwnServer& server, bool needs_page,
                                     const CallOptions& call) {
  std::optional<pid_t> ending;
  absl::Status status;
  for (int i = 0; i < kMostTries; ++i) {
    absl::StatusOr<pid_t> process = server.Start(ending, needs_page, call);
    if (!process.ok()) return process;
    Client client(server.address(), {.retry = false});
    const absl::StatusOr<Capabilities> capabilities = client.GetCapabilities(
        {.timeout = Within(kAnswer, call), .stop = call.stop});
    if (capabilities.ok() && capabilities->version != GEODESIC_VERSION) {
      (void)server.Stop(call);
      return NoServer(absl::FailedPreconditionError(absl::StrCat(
          "this is geodesic " GEODESIC_VERSION
          ", but the geodesicd found has "
          "version ",
          capabilities->version,
          ": install both of one version, or name a server with --server")));
    }
    if (capabilities.ok()) return process;
    status = capabilities.status();
    if (!absl::IsUnavailable(status)) break;
    ending = *process;
  }
  return NoServer(absl::Status(
      status.code(), absl::StrCat("the server at ", server.address(),
                                  " does not answer: ", status.message(),
                                  " (its log: ", server.log_path(), ")")));
}

}  // namespace geodesic::client
