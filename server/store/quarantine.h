// Damaged files, set aside for people to look at.

#ifndef GEODESIC_SERVER_STORE_QUARANTINE_H_
#define GEODESIC_SERVER_STORE_QUARANTINE_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "absl/status/statusor.h"
#include "server/store/posix_file.h"

namespace geodesic::server {

// The folder "quarantine", with the latest hundred files. What is there is
// listed whenever somebody asks, for people take files away. Thread-safe; all
// calls wait for the disk.
class Quarantine {
 public:
  // Errors: as OpenFolder.
  static absl::StatusOr<std::unique_ptr<Quarantine>> Open(int parent);

  // Moves a file here and returns its new name. When it is one too many, the
  // oldest goes.
  // Errors: as DiskError; the file is then where it was.
  absl::StatusOr<std::string> Take(int folder, const std::string& file);

  struct Contents {
    size_t files = 0;
    uint64_t bytes = 0;  // in blocks of 4 KiB, as disks count
    // The file that came first.
    std::string oldest;
  };
  // Nothing of a folder that cannot be listed. O(files).
  Contents Count() const;

 private:
  explicit Quarantine(FileDescriptor folder) : folder_(std::move(folder)) {}

  const FileDescriptor folder_;
  std::mutex mutex_;  // held while files come and go
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_STORE_QUARANTINE_H_
