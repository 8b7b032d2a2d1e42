#include "server/security/file_text.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "server/store/posix_file.h"

namespace geodesic::server {

absl::StatusOr<std::string> ReadFileText(const std::string& path) {
  const auto failure = [&path] {
    return absl::ErrnoToStatus(errno, absl::StrCat("cannot read ", path));
  };
  // Otherwise a pipe that nobody writes to would never open.
  const FileDescriptor file(
      open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (file.get() < 0 || fcntl(file.get(), F_SETFL, 0) != 0) return failure();
  std::string text;
  std::array<char, 4096> part;
  for (;;) {
    const ssize_t count = read(file.get(), part.data(), part.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return failure();
    if (count == 0) return text;
    text.append(part.data(), static_cast<size_t>(count));
  }
}

}  // namespace geodesic::server
