#include "file_reader.h"

#include <sys/stat.h>

#include <cerrno>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"

namespace geodesic::client {

absl::StatusOr<FileReader> FileReader::Open(const std::string& path) {
  // A pipe would block the open, so its kind is looked at first.
  struct stat info = {};
  if (stat(path.c_str(), &info) != 0) {
    return absl::ErrnoToStatus(errno, absl::StrCat("cannot open ", path));
  }
  if (!S_ISREG(info.st_mode)) {
    return absl::InvalidArgumentError(
        absl::StrCat(path, " is not a regular file"));
  }
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) {
    return absl::ErrnoToStatus(errno, absl::StrCat("cannot open ", path));
  }
  return FileReader(path, file, static_cast<uint64_t>(info.st_size));
}

absl::Status FileReader::Read(std::string* buffer) {
  const size_t count =
      std::fread(buffer->data(), 1, buffer->size(), file_.get());
  if (count < buffer->size() && std::ferror(file_.get()) != 0) {
    return absl::DataLossError(absl::StrCat("cannot read ", path_));
  }
  buffer->resize(count);
  return absl::OkStatus();
}

}  // namespace geodesic::client
