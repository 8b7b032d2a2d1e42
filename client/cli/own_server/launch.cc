#include "client/cli/own_server/launch.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_split.h"
#include "client/cli/own_server/descriptor.h"

extern char** environ;

namespace geodesic::client {
namespace {

// The numbers of inherited descriptors in the server.
constexpr int kKeptOpen = 3;
constexpr int kReady = 4;
// This process's copies are above them, or one would overwrite another.
constexpr int kAbove = 10;

// Logs grow without bound otherwise.
constexpr off_t kMostLogBytes = 1 << 20;

// How often a wait looks whether it is to stop.
constexpr int kLookMs = 50;

constexpr std::string_view kSharedServersSettings[] = {
    "CONFIG",         "LISTEN",         "PORT_FILE",       "TLS_CERT",
    "TLS_KEY",        "TLS_CLIENT_CA",  "TOKEN_FILE",      "INSECURE_LISTEN",
    "METRICS_LISTEN", "CHANNELZ",       "DATA_DIR",        "WEB",
    "WEB_PORT_FILE",  "WEB_TOKEN_FILE", "WEB_ALLOW_ORIGIN"};

std::vector<std::string> ServerEnvironment(std::chrono::seconds idle_time) {
  const std::string kPrefix = "GEODESICD_";
  // The first mention of a variable counts, so defaults come last.
  std::vector<std::string> variables;
  for (char** next = environ; *next != nullptr; ++next) {
    const std::string_view variable = *next;
    const std::string_view name = variable.substr(0, variable.find('='));
    const bool is_shared_servers =
        name.starts_with(kPrefix) &&
        std::ranges::count(kSharedServersSettings,
                           name.substr(kPrefix.size())) > 0;
    if (!is_shared_servers) variables.emplace_back(variable);
  }
  if (getenv("GEODESICD_EXIT_WHEN_IDLE") == nullptr) {
    variables.push_back(
        absl::StrCat(kPrefix, "EXIT_WHEN_IDLE=", idle_time.count()));
  }
  if (getenv("GEODESICD_LOG_LEVEL") == nullptr) {
    variables.push_back(absl::StrCat(kPrefix, "LOG_LEVEL=warn"));
  }
  return variables;
}

std::vector<char*> Pointers(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

Descriptor CopyAbove(int descriptor) {
  return Descriptor(fcntl(descriptor, F_DUPFD_CLOEXEC, kAbove));
}

// Its process, in a session of its own without this process's descriptors,
// blocked signals and working folder.
absl::StatusOr<pid_t> Spawn(const Launch& launch, int log, int ready) {
  const Descriptor kept_open = CopyAbove(launch.kept_open);
  const Descriptor output = CopyAbove(log);
  const Descriptor pipe = CopyAbove(ready);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY,
                                   0);
  posix_spawn_file_actions_adddup2(&files, output.get(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, output.get(), STDERR_FILENO);
  posix_spawn_file_actions_adddup2(&files, kept_open.get(), kKeptOpen);
  posix_spawn_file_actions_adddup2(&files, pipe.get(), kReady);
  posix_spawn_file_actions_addclosefrom_np(&files, kReady + 1);
  posix_spawn_file_actions_addchdir_np(&files, "/");
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID |
                                            POSIX_SPAWN_SETSIGMASK |
                                            POSIX_SPAWN_SETSIGDEF);
  sigset_t signals;
  sigemptyset(&signals);
  posix_spawnattr_setsigmask(&attributes, &signals);
  sigfillset(&signals);
  posix_spawnattr_setsigdefault(&attributes, &signals);

  std::vector<std::string> words = {
      launch.program, "--listen", absl::StrCat("unix:", launch.socket_path),
      "--port-file", absl::StrCat("/proc/self/fd/", kReady)};
  if (launch.page) {
    words.insert(words.end(), {"--web", "127.0.0.1:0", "--web-port-file",
                               launch.page->port_path(), "--web-token-file",
                               launch.page->hash_path()});
  }
  std::vector<std::string> variables =
      ServerEnvironment(launch.page ? kIdleTimeWithPage : kIdleTime);
  pid_t process = -1;
  const int error =
      posix_spawn(&process, launch.program.c_str(), &files, &attributes,
                  Pointers(words).data(), Pointers(variables).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) {
    return absl::UnavailableError(
        absl::StrCat("cannot start ", launch.program, ": ",
                     absl::ErrnoToStatus(error, "").message()));
  }
  return process;
}

// The last lines of the file from `begin` on, which one message can hold.
std::string LastWords(const std::string& path, off_t begin) {
  constexpr size_t kLines = 5;
  std::ifstream file(path, std::ios::binary);
  file.seekg(begin);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    if (!line.empty()) lines.push_back(line);
  }
  if (lines.size() > kLines) lines.erase(lines.begin(), lines.end() - kLines);
  return lines.empty() ? "it said nothing" : absl::StrJoin(lines, "; ");
}

// How a wait for the first line in a pipe ended.
enum class Ended { kLine, kClosed, kLate, kStopped };

Ended AwaitLine(int pipe, std::chrono::steady_clock::time_point until,
                const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    if (std::chrono::steady_clock::now() > until) return Ended::kLate;
    pollfd ready = {pipe, POLLIN, 0};
    if (poll(&ready, 1, kLookMs) <= 0) continue;
    char c = 0;
    const ssize_t count = read(pipe, &c, 1);
    if (count == 1 && c == '\n') return Ended::kLine;
    if (count == 0) return Ended::kClosed;
  }
  return Ended::kStopped;
}

// "exit code 1" or "signal 9".
std::string HowItEnded(pid_t process) {
  int status = 0;
  waitpid(process, &status, 0);
  return WIFSIGNALED(status)
             ? absl::StrCat("it ended by signal ", WTERMSIG(status))
             : absl::StrCat("it ended with exit code ", WEXITSTATUS(status));
}

bool IsProgram(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error) &&
         access(path.c_str(), X_OK) == 0;
}

}  // namespace

absl::StatusOr<std::string> FindServerProgram() {
  std::error_code error;
  const std::filesystem::path self =
      std::filesystem::read_symlink("/proc/self/exe", error);
  std::string beside = self.parent_path() / "geodesicd";
  if (!error && IsProgram(beside)) return beside;
  const char* path = getenv("PATH");
  const std::vector<std::string> folders =
      absl::StrSplit(path == nullptr ? "" : path, ':');
  for (const std::string& folder : folders) {
    if (folder.empty()) continue;
    std::string program =
        std::filesystem::absolute(std::filesystem::path(folder), error) /
        "geodesicd";
    if (!error && IsProgram(program)) return program;
  }
  return absl::NotFoundError(absl::StrCat(
      "there is no geodesicd to start, neither ", beside,
      " nor in PATH: install it, or name a server with --server HOST:PORT"));
}

absl::Status LaunchServer(const Launch& launch,
                          std::chrono::steady_clock::time_point until,
                          const std::stop_token& stop) {
  const Descriptor log(
      open(launch.log_path.c_str(),
           O_WRONLY | O_CREAT | O_APPEND | O_NOFOLLOW | O_CLOEXEC,
           S_IRUSR | S_IWUSR));
  if (!log.is_open()) {
    return absl::ErrnoToStatus(errno,
                               absl::StrCat("cannot open ", launch.log_path));
  }
  struct stat file = {};
  fstat(log.get(), &file);
  if (file.st_size > kMostLogBytes && ftruncate(log.get(), 0) == 0) {
    file.st_size = 0;
  }
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) {
    return absl::ErrnoToStatus(errno, "cannot make a pipe");
  }
  const Descriptor ready(ends[0]);
  Descriptor write_end(ends[1]);
  const absl::StatusOr<pid_t> process =
      Spawn(launch, log.get(), write_end.get());
  if (!process.ok()) return process.status();
  write_end = Descriptor();
  std::string why;
  switch (AwaitLine(ready.get(), until, stop)) {
    case Ended::kLine:
      return absl::OkStatus();
    case Ended::kStopped:
      return absl::CancelledError("stopped while a server starts");
    case Ended::kClosed:
      why = HowItEnded(*process);
      break;
    case Ended::kLate:
      kill(*process, SIGKILL);
      HowItEnded(*process);
      why = "it did not serve in time";
      break;
  }
  return absl::UnavailableError(absl::StrCat(
      launch.program, " does not start: ", why, "; ",
      LastWords(launch.log_path, file.st_size), " (", launch.log_path, ")"));
}

}  // namespace geodesic::client
