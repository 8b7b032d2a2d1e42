#include "server/unix_socket.h"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"

namespace geodesic::server {
namespace {

constexpr std::string_view kScheme = "unix:";

// Whether a server takes connections there.
bool Answers(const sockaddr_un& address) {
  const int probe = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const bool answers =
      probe >= 0 && connect(probe, reinterpret_cast<const sockaddr*>(&address),
                            sizeof(address)) == 0;
  if (probe >= 0) close(probe);
  return answers;
}

}  // namespace

std::optional<std::string> SocketPath(std::string_view address) {
  if (!address.starts_with(kScheme)) return std::nullopt;
  return std::string(address.substr(kScheme.size()));
}

absl::Status CheckSocketPath(const std::string& path) {
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  const auto is_plain = [](unsigned char c) {
    return absl::ascii_isalnum(c) ||
           std::string_view("/._-+@,~").find(static_cast<char>(c)) !=
               std::string_view::npos;
  };
  if (!path.starts_with('/') || path.size() >= sizeof(address.sun_path) ||
      !std::ranges::all_of(path, is_plain)) {
    return absl::InvalidArgumentError(
        absl::StrCat("\"unix:", path,
                     "\" is not unix:PATH with an absolute path of at most ",
                     sizeof(address.sun_path) - 1,
                     " letters, digits and any of / . _ - + @ , ~"));
  }
  std::ranges::copy(path, address.sun_path);
  struct stat file = {};
  if (lstat(path.c_str(), &file) == 0 && !S_ISSOCK(file.st_mode)) {
    return absl::UnavailableError(absl::StrCat(
        "cannot listen on unix:", path, ": something else has that name"));
  }
  if (Answers(address)) {
    return absl::UnavailableError(absl::StrCat(
        "cannot listen on unix:", path, ": another server answers there"));
  }
  return absl::OkStatus();
}

PrivateFiles::PrivateFiles() : before_(umask(S_IRWXG | S_IRWXO)) {}
PrivateFiles::~PrivateFiles() { umask(before_); }

}  // namespace geodesic::server
