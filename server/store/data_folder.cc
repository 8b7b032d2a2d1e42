#include "server/store/data_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"

namespace geodesic::server {
namespace {

// Files in the quarantine.
constexpr size_t kMaxFiles = 100;

// "by process 123", if the file says so.
std::string Owner(int lock) {
  std::array<char, 32> text{};
  const ssize_t count = pread(lock, text.data(), text.size(), 0);
  const absl::string_view number = absl::StripAsciiWhitespace(
      absl::string_view(text.data(), count > 0 ? count : 0));
  return number.empty() ? "" : absl::StrCat(" by process ", number);
}

absl::Status Unusable(const absl::Status& why) {
  return absl::UnavailableError(absl::StrCat("--data-dir: ", why.message()));
}

}  // namespace

absl::StatusOr<std::unique_ptr<Quarantine>> Quarantine::Open(int parent) {
  absl::StatusOr<FileDescriptor> folder = OpenFolder(parent, "quarantine");
  if (!folder.ok()) return folder.status();
  return std::unique_ptr<Quarantine>(new Quarantine(*std::move(folder)));
}

absl::StatusOr<std::string> Quarantine::Take(int folder,
                                             const std::string& file) {
  MutexLock lock(mutex_);
  // Done before the new one comes, which may look oldest if the clock was set.
  if (const Contents contents = Count(); contents.files >= kMaxFiles) {
    unlinkat(folder_.get(), contents.oldest.c_str(), 0);
  }
  // A file of this name may have come before.
  std::string aside = file;
  struct stat facts {};
  for (int i = 1;
       fstatat(folder_.get(), aside.c_str(), &facts, AT_SYMLINK_NOFOLLOW) == 0;
       ++i) {
    aside = absl::StrCat(file, ".", i);
  }
  if (renameat(folder, file.c_str(), folder_.get(), aside.c_str()) != 0) {
    return DiskError(errno, "move", file);
  }
  fsync(folder_.get());
  fsync(folder);
  return aside;
}

Quarantine::Contents Quarantine::Count() const {
  const absl::StatusOr<std::vector<std::string>> names = NamesIn(folder_.get());
  if (!names.ok()) return {};
  Contents contents;
  timespec since{};  // of the oldest
  for (const std::string& name : *names) {
    struct stat facts {};
    if (fstatat(folder_.get(), name.c_str(), &facts, AT_SYMLINK_NOFOLLOW) !=
            0 ||
        !S_ISREG(facts.st_mode)) {
      continue;
    }
    // A move sets the time of status change, not that of modification.
    const timespec& moved = facts.st_ctim;
    if (contents.files == 0 ||
        std::tie(moved.tv_sec, moved.tv_nsec, name) <
            std::tie(since.tv_sec, since.tv_nsec, contents.oldest)) {
      contents.oldest = name;
      since = moved;
    }
    ++contents.files;
    contents.bytes += OnDisk(facts.st_size);
  }
  return contents;
}

absl::StatusOr<DataFolder> DataFolder::Open(const std::string& path) {
  absl::StatusOr<FileDescriptor> folder = OpenFolder(AT_FDCWD, path);
  if (!folder.ok()) return Unusable(folder.status());
  // The folder is locked, and a file in it: a file may be replaced, and some
  // network disks lock no folders. Opened for reading: a disk with a file open
  // for writing cannot be made read-only.
  absl::StatusOr<FileDescriptor> lock =
      OpenToRead(folder->get(), "lock", path + "/lock", O_CREAT);
  if (!lock.ok()) return Unusable(lock.status());
  if (flock(lock->get(), LOCK_EX | LOCK_NB) != 0 ||
      (flock(folder->get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)) {
    return absl::UnavailableError(
        absl::StrCat("--data-dir ", path, " is in use", Owner(lock->get()),
                     "; each server needs a folder of its own"));
  }
  // The number is for people and the message above. Errors are ignored: a
  // server with a full or read-only disk must still serve what it has.
  const FileDescriptor owner(
      openat(folder->get(), "lock", O_WRONLY | O_TRUNC | O_CLOEXEC));
  (void)WriteAt(owner.get(), 0, absl::StrCat(getpid(), "\n"), "lock");
  absl::StatusOr<std::unique_ptr<Quarantine>> quarantine =
      Quarantine::Open(folder->get());
  if (!quarantine.ok()) return Unusable(quarantine.status());
  return DataFolder(*std::move(folder), *std::move(lock),
                    *std::move(quarantine));
}

}  // namespace geodesic::server
