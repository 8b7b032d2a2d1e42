#include "client/cli/own_server/runtime_folder.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

#include "absl/strings/str_cat.h"

namespace geodesic::client {
namespace {

std::string Place() {
  const char* runtime = getenv("XDG_RUNTIME_DIR");
  struct stat file = {};
  if (runtime != nullptr && runtime[0] == '/' && stat(runtime, &file) == 0 &&
      S_ISDIR(file.st_mode) && file.st_uid == geteuid()) {
    return absl::StrCat(runtime, "/geodesic");
  }
  return absl::StrCat("/tmp/geodesic-", geteuid());
}

// Says what is wrong with the folder; empty if it is this user's alone.
std::string Flaw(const struct stat& file) {
  if (!S_ISDIR(file.st_mode)) return "is not a folder";
  if (file.st_uid != geteuid()) {
    return absl::StrCat("belongs to user ", file.st_uid, ", not to ",
                        geteuid());
  }
  return (file.st_mode & (S_IRWXG | S_IRWXO)) == 0
             ? ""
             : "can be opened by other users";
}

}  // namespace

absl::StatusOr<std::string> RuntimeFolder() {
  const std::string path = Place();
  if (mkdir(path.c_str(), S_IRWXU) != 0 && errno != EEXIST) {
    return absl::ErrnoToStatus(errno, absl::StrCat("cannot make ", path));
  }
  // Nobody but its owner can put another in place of a folder in /tmp, which is
  // sticky, or in a folder of the user's own. So it stays what is seen here.
  struct stat file = {};
  if (lstat(path.c_str(), &file) != 0) {
    return absl::ErrnoToStatus(errno, absl::StrCat("cannot look at ", path));
  }
  if (const std::string flaw = Flaw(file); !flaw.empty()) {
    return absl::FailedPreconditionError(absl::StrCat(
        path, " ", flaw,
        ", so no server is started in it: remove it, set XDG_RUNTIME_DIR to a "
        "folder of your own, or name a server with --server"));
  }
  return path;
}

}  // namespace geodesic::client
