#include "server/store/quarantine.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <tuple>
#include <utility>

#include "absl/strings/str_cat.h"

namespace geodesic::server {
namespace {

constexpr size_t kMaxFiles = 1000;

}  // namespace

struct Quarantine::File {
  std::string name;
  uint64_t bytes = 0;
  timespec since;
};

absl::StatusOr<std::unique_ptr<Quarantine>> Quarantine::Open(
    int parent, uint64_t capacity) {
  absl::StatusOr<FileDescriptor> folder = OpenFolder(parent, "quarantine");
  if (!folder.ok()) return folder.status();
  std::unique_ptr<Quarantine> quarantine(
      new Quarantine(*std::move(folder), capacity));
  // The capacity may have been larger once.
  std::lock_guard lock(quarantine->mutex_);
  quarantine->MakeRoom("");
  return quarantine;
}

absl::StatusOr<std::string> Quarantine::Take(int folder,
                                             const std::string& file) {
  std::lock_guard lock(mutex_);
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
  MakeRoom(aside);
  return aside;
}

Quarantine::Contents Quarantine::Count() const {
  Contents contents;
  for (const File& file : List()) {
    ++contents.files;
    contents.bytes += file.bytes;
  }
  return contents;
}

std::vector<Quarantine::File> Quarantine::List() const {
  const absl::StatusOr<std::vector<std::string>> names = NamesIn(folder_.get());
  if (!names.ok()) return {};
  std::vector<File> files;
  for (const std::string& name : *names) {
    struct stat facts {};
    if (fstatat(folder_.get(), name.c_str(), &facts, AT_SYMLINK_NOFOLLOW) ==
            0 &&
        S_ISREG(facts.st_mode)) {
      // Being moved changes a file's status, not its content.
      files.push_back({name, OnDisk(facts.st_size), facts.st_ctim});
    }
  }
  std::sort(files.begin(), files.end(), [](const File& a, const File& b) {
    return std::tie(a.since.tv_sec, a.since.tv_nsec, a.name) <
           std::tie(b.since.tv_sec, b.since.tv_nsec, b.name);
  });
  return files;
}

void Quarantine::MakeRoom(const std::string& newest) {
  std::vector<File> files = List();
  // Clocks may have been set.
  std::stable_partition(files.begin(), files.end(),
                        [&](const File& file) { return file.name != newest; });
  size_t count = files.size();
  uint64_t bytes = 0;
  for (const File& file : files) bytes += file.bytes;
  for (const File& file : files) {
    if (bytes <= capacity_ && count <= kMaxFiles) return;
    if (unlinkat(folder_.get(), file.name.c_str(), 0) != 0) continue;
    ++evictions_;
    --count;
    bytes -= file.bytes;
  }
}

}  // namespace geodesic::server
