#include "server/store/data_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string_view>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"

namespace geodesic::server {
namespace {

// "by process 123", if the file says so.
std::string Owner(int lock) {
  std::array<char, 32> text{};
  const ssize_t count = pread(lock, text.data(), text.size(), 0);
  const absl::string_view number = absl::StripAsciiWhitespace(
      absl::string_view(text.data(), count > 0 ? count : 0));
  return number.empty() ? "" : absl::StrCat(" by process ", number);
}

}  // namespace

absl::StatusOr<DataFolder> DataFolder::Open(const std::string& path) {
  absl::StatusOr<FileDescriptor> folder = OpenFolder(AT_FDCWD, path);
  if (!folder.ok()) {
    return absl::UnavailableError(
        absl::StrCat("--data-dir: ", folder.status().message()));
  }
  // Open for reading only: a disk with a file open for writing could not be
  // made read-only.
  absl::StatusOr<FileDescriptor> lock =
      OpenToRead(folder->get(), "lock", path + "/lock", O_CREAT);
  if (!lock.ok()) {
    return absl::UnavailableError(
        absl::StrCat("--data-dir: ", lock.status().message()));
  }
  if (flock(lock->get(), LOCK_EX | LOCK_NB) != 0) {
    return absl::UnavailableError(
        absl::StrCat("--data-dir ", path, " is in use", Owner(lock->get()),
                     "; each server needs a folder of its own"));
  }
  // For people and the message above only: the lock is the kernel's, and a
  // full or read-only disk must not keep a server from serving what it has.
  const FileDescriptor owner(
      openat(folder->get(), "lock", O_WRONLY | O_TRUNC | O_CLOEXEC));
  (void)WriteAt(owner.get(), 0, absl::StrCat(getpid(), "\n"), "lock");
  absl::StatusOr<std::unique_ptr<Quarantine>> quarantine =
      Quarantine::Open(folder->get());
  if (!quarantine.ok()) {
    return absl::UnavailableError(
        absl::StrCat("--data-dir: ", quarantine.status().message()));
  }
  return DataFolder(*std::move(folder), *std::move(lock),
                    *std::move(quarantine));
}

}  // namespace geodesic::server
