// The folder in which a server keeps what outlives it; one server at a time.

#ifndef GEODESIC_SERVER_STORE_DATA_FOLDER_H_
#define GEODESIC_SERVER_STORE_DATA_FOLDER_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "absl/status/statusor.h"
#include "server/locks/mutex.h"
#include "server/store/posix_file.h"

namespace geodesic::server {

// The folder "quarantine", with the latest hundred damaged files. Every call
// lists it, because people take files away. Thread-safe; calls wait for the
// disk.
class Quarantine {
 public:
  // Errors: as OpenFolder.
  static absl::StatusOr<std::unique_ptr<Quarantine>> Open(int parent);

  // Moves a file here and returns its new name. Removes the oldest file if
  // there are too many.
  // Errors: as DiskError; the file is then where it was.
  absl::StatusOr<std::string> Take(int folder, const std::string& file);

  struct Contents {
    size_t files = 0;
    uint64_t bytes = 0;  // in blocks of 4 KiB, as disks count
    // The file that was moved here first.
    std::string oldest;
  };
  // All empty if the folder cannot be listed. O(files).
  Contents Count() const;

 private:
  explicit Quarantine(FileDescriptor folder) : folder_(std::move(folder)) {}

  const FileDescriptor folder_;
  Mutex mutex_;  // held while files come and go
};

// Holds the folder's locks; the kernel releases them when the process dies.
class DataFolder {
 public:
  // Makes the folder if there is none, readable by this user alone; its parents
  // must exist.
  // Errors: UNAVAILABLE naming the process that holds a lock, or why the
  // folder cannot be made or opened.
  static absl::StatusOr<DataFolder> Open(const std::string& path);

  int descriptor() const { return folder_.get(); }
  Quarantine& quarantine() const { return *quarantine_; }

 private:
  DataFolder(FileDescriptor folder, FileDescriptor lock,
             std::unique_ptr<Quarantine> quarantine)
      : folder_(std::move(folder)),
        lock_(std::move(lock)),
        quarantine_(std::move(quarantine)) {}

  FileDescriptor folder_;
  FileDescriptor lock_;
  std::unique_ptr<Quarantine> quarantine_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_STORE_DATA_FOLDER_H_
