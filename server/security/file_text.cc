#include "server/security/file_text.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "server/store/posix_file.h"

namespace geodesic::server {
namespace {

// Far more than any tokens or certificates take.
constexpr size_t kMostBytes = 4 << 20;

// How long nothing may come of a pipe.
constexpr int kPatienceMs = 1000;

}  // namespace

absl::StatusOr<std::string> ReadFileText(const std::string& path) {
  const auto failure = [&path](int error) {
    return absl::ErrnoToStatus(error, absl::StrCat("cannot read ", path));
  };
  // Otherwise a pipe that nobody writes to would never open.
  const FileDescriptor file(
      open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (file.get() < 0) return failure(errno);
  std::string text;
  std::array<char, 4096> part;
  for (;;) {
    pollfd ready = {.fd = file.get(), .events = POLLIN};
    if (poll(&ready, 1, kPatienceMs) == 0) {
      return absl::DeadlineExceededError(absl::StrCat(
          "cannot read ", path, ": nothing has come of it for a second"));
    }
    const ssize_t count = read(file.get(), part.data(), part.size());
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (count < 0) return failure(errno);
    if (count == 0) return text;
    text.append(part.data(), static_cast<size_t>(count));
    if (text.size() > kMostBytes) return failure(EFBIG);
  }
}

}  // namespace geodesic::server
