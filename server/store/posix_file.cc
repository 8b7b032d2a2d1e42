#include "server/store/posix_file.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "absl/strings/str_cat.h"

namespace geodesic::server {
namespace {

// Linux transfers no more than 2 GiB in one call.
constexpr size_t kMostAtOnce = size_t{1} << 30;

absl::string_view View(std::string_view text) {
  return {text.data(), text.size()};
}

}  // namespace

FileDescriptor::~FileDescriptor() {
  if (number_ >= 0) close(number_);
}

absl::Status DiskError(int error, std::string_view verb,
                       std::string_view name) {
  const std::string message =
      absl::StrCat("the server cannot ", View(verb), " ", View(name),
                   " on its disk: ", strerror(error));
  switch (error) {
    case ENOENT:
      return absl::NotFoundError(message);
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
    case ENOMEM:
    case EMFILE:
    case ENFILE:
      return absl::ResourceExhaustedError(message);
    default:
      return absl::UnavailableError(message);
  }
}

absl::StatusOr<FileDescriptor> OpenFolder(int parent, const std::string& name) {
  if (mkdirat(parent, name.c_str(), 0700) != 0 && errno != EEXIST) {
    return DiskError(errno, "make folder", name);
  }
  FileDescriptor folder(
      openat(parent, name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.get() < 0) return DiskError(errno, "open folder", name);
  return folder;
}

absl::StatusOr<FileDescriptor> OpenToRead(int folder, const std::string& file,
                                          std::string_view name,
                                          int more_flags) {
  FileDescriptor opened(openat(
      folder, file.c_str(),
      O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | more_flags,
      0600));
  if (opened.get() < 0) return DiskError(errno, "open", name);
  struct stat facts {};
  if (fstat(opened.get(), &facts) != 0) {
    return DiskError(errno, "examine", name);
  }
  if (!S_ISREG(facts.st_mode)) {
    return absl::UnavailableError(
        absl::StrCat(View(name), " is no regular file"));
  }
  return opened;
}

absl::Status WriteAt(int file, uint64_t offset, std::string_view bytes,
                     std::string_view name) {
  while (!bytes.empty()) {
    const ssize_t count =
        pwrite(file, bytes.data(), std::min(bytes.size(), kMostAtOnce),
               static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return DiskError(errno, "write", name);
    bytes.remove_prefix(static_cast<size_t>(count));
    offset += static_cast<uint64_t>(count);
  }
  return absl::OkStatus();
}

absl::Status ReadAt(int file, uint64_t offset, std::span<char> bytes,
                    std::string_view name) {
  while (!bytes.empty()) {
    const ssize_t count =
        pread(file, bytes.data(), std::min(bytes.size(), kMostAtOnce),
              static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return DiskError(errno, "read", name);
    if (count == 0) {
      return absl::DataLossError(
          absl::StrCat(View(name), " ends at byte ", offset, ", too early"));
    }
    bytes = bytes.subspan(static_cast<size_t>(count));
    offset += static_cast<uint64_t>(count);
  }
  return absl::OkStatus();
}

absl::Status Sync(int file, std::string_view name) {
  if (fsync(file) != 0) return DiskError(errno, "flush", name);
  return absl::OkStatus();
}

absl::StatusOr<std::vector<std::string>> NamesIn(int folder) {
  // Opened again, because a listing moves the offset of its descriptor.
  const int copy = openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  DIR* listing = copy < 0 ? nullptr : fdopendir(copy);
  if (listing == nullptr) return DiskError(errno, "list", "--data-dir");
  std::vector<std::string> names;
  errno = 0;
  while (const dirent* entry = readdir(listing)) names.push_back(entry->d_name);
  const int error = errno;
  closedir(listing);
  if (error != 0) return DiskError(error, "list", "--data-dir");
  return names;
}

uint64_t OnDisk(uint64_t bytes) {
  constexpr uint64_t kBlock = 4096;
  return (bytes + kBlock - 1) / kBlock * kBlock;
}

}  // namespace geodesic::server
