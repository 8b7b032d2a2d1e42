#include "server/store/quarantine.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <tuple>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"

namespace geodesic::server {
namespace {

constexpr size_t kMaxFiles = 100;

}  // namespace

absl::StatusOr<std::unique_ptr<Quarantine>> Quarantine::Open(int parent) {
  absl::StatusOr<FileDescriptor> folder = OpenFolder(parent, "quarantine");
  if (!folder.ok()) return folder.status();
  return std::unique_ptr<Quarantine>(new Quarantine(*std::move(folder)));
}

absl::StatusOr<std::string> Quarantine::Take(int folder,
                                             const std::string& file) {
  std::lock_guard lock(mutex_);
  // Before the new one comes, which clocks may take for the oldest.
  if (const Contents contents = Count(); contents.files >= kMaxFiles) {
    unlinkat(folder_.get(), contents.oldest.c_str(), 0);
  }
  // A name can be damaged more than once.
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
    // Being moved changes a file's status, not its content.
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

}  // namespace geodesic::server
