#include "tests/support/small_disk.h"

#include <sched.h>
#include <sys/mount.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "absl/strings/str_cat.h"

namespace geodesic::test {
namespace {

absl::Status Denied(const char* what) {
  return absl::PermissionDeniedError(
      absl::StrCat("this machine forbids to ", what, ": ", strerror(errno)));
}

// Root may have the mount namespace at once; others get one with a user
// namespace in which they are root.
absl::Status EnterNamespace() {
  if (unshare(CLONE_NEWNS) != 0) {
    const uid_t user = getuid();
    const gid_t group = getgid();
    if (unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) {
      return Denied("make a namespace for mounts");
    }
    std::ofstream("/proc/self/setgroups") << "deny";
    std::ofstream("/proc/self/uid_map") << "0 " << user << " 1";
    std::ofstream("/proc/self/gid_map") << "0 " << group << " 1";
  }
  if (mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) {
    return Denied("make mounts private");
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<std::unique_ptr<SmallDisk>> SmallDisk::Mount(
    const std::string& folder, uint64_t bytes) {
  if (absl::Status status = EnterNamespace(); !status.ok()) return status;
  const std::string options = absl::StrCat("size=", bytes, ",mode=0700");
  if (mount("small-disk", folder.c_str(), "tmpfs", 0, options.c_str()) != 0) {
    return Denied("mount a tmpfs");
  }
  return std::unique_ptr<SmallDisk>(new SmallDisk(folder, bytes));
}

SmallDisk::~SmallDisk() { umount2(folder_.c_str(), MNT_DETACH); }

absl::Status SmallDisk::SetReadOnly(bool is_read_only) {
  const std::string options = absl::StrCat("size=", bytes_, ",mode=0700");
  if (mount("small-disk", folder_.c_str(), "tmpfs",
            MS_REMOUNT | (is_read_only ? MS_RDONLY : 0),
            options.c_str()) != 0) {
    return Denied("remount a tmpfs");
  }
  return absl::OkStatus();
}

}  // namespace geodesic::test
