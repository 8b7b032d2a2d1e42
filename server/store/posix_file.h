// Files and folders by descriptor, with errors as absl::Status.

#ifndef GEODESIC_SERVER_STORE_POSIX_FILE_H_
#define GEODESIC_SERVER_STORE_POSIX_FILE_H_

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace geodesic::server {

// Closes the file when destroyed. Movable; changes are not thread-safe.
class FileDescriptor {
 public:
  FileDescriptor() = default;
  explicit FileDescriptor(int number) : number_(number) {}
  FileDescriptor(FileDescriptor&& other) noexcept
      : number_(std::exchange(other.number_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~FileDescriptor();

  int get() const { return number_; }
  // The caller closes it.
  int Release() { return std::exchange(number_, -1); }

 private:
  int number_ = -1;
};

// The error of a failure with errno `error` to `verb` the file `name`:
//   NOT_FOUND: there is no such file;
//   RESOURCE_EXHAUSTED: the disk, a quota, a file's bound, memory or the table
//     of open files is full;
//   UNAVAILABLE: anything else (read-only, no permission, a broken disk).
absl::Status DiskError(int error, std::string_view verb, std::string_view name);

// Opens a folder. Makes it (mode 0700), but not its parents, if there is none.
absl::StatusOr<FileDescriptor> OpenFolder(int parent, const std::string& name);

// Opens a regular file for reading. Follows no link, and fails without waiting
// for anything else that has the name, such as a pipe. `more_flags` of open(2):
// with O_CREAT the file is made (mode 0600) when there is none. `name` is for
// messages.
// Errors: as DiskError; UNAVAILABLE: it is no regular file.
absl::StatusOr<FileDescriptor> OpenToRead(int folder, const std::string& file,
                                          std::string_view name,
                                          int more_flags = 0);

// The names in a folder, among them "." and "..". Errors: as DiskError.
absl::StatusOr<std::vector<std::string>> NamesIn(int folder);

// The bytes that a file of this size takes on disk, in blocks of 4 KiB.
uint64_t OnDisk(uint64_t bytes);

// Writes or reads all of `bytes` at `offset`. `name` is for messages.
// Errors: as DiskError; ReadAt: DATA_LOSS when the file ends before.
absl::Status WriteAt(int file, uint64_t offset, std::string_view bytes,
                     std::string_view name);
absl::Status ReadAt(int file, uint64_t offset, std::span<char> bytes,
                    std::string_view name);

// Returns when the file's content, or the folder's names, are on disk.
absl::Status Sync(int file, std::string_view name);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_STORE_POSIX_FILE_H_
