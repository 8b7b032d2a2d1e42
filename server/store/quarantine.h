// Damaged files, set aside for people to look at.

#ifndef GEODESIC_SERVER_STORE_QUARANTINE_H_
#define GEODESIC_SERVER_STORE_QUARANTINE_H_

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "server/store/posix_file.h"

namespace geodesic::server {

// As much as any one mesh that a server takes by default.
inline constexpr uint64_t kQuarantineBytes = uint64_t{4} << 30;

// The folder "quarantine", bounded in bytes (in blocks of 4 KiB, as disks
// count) and to a thousand files: beyond that the oldest go. What is there is
// listed whenever somebody asks, for people take files away. Thread-safe; all
// calls wait for the disk.
class Quarantine {
 public:
  // Errors: as OpenFolder.
  static absl::StatusOr<std::unique_ptr<Quarantine>> Open(int parent,
                                                          uint64_t capacity);

  // Moves a file here and returns its new name. It is the last to go, but goes
  // too if it alone is more than the capacity.
  // Errors: as DiskError; the file is then where it was.
  absl::StatusOr<std::string> Take(int folder, const std::string& file);

  struct Contents {
    size_t files = 0;
    uint64_t bytes = 0;
  };
  // Nothing of a folder that cannot be listed. O(files).
  Contents Count() const;

  uint64_t capacity() const { return capacity_; }
  // Files that went to make room, since the start.
  uint64_t evictions() const { return evictions_; }

 private:
  struct File;

  Quarantine(FileDescriptor folder, uint64_t capacity)
      : folder_(std::move(folder)), capacity_(capacity) {}

  // In the order in which they came.
  std::vector<File> List() const;
  // `newest` is the last to go. REQUIRES: mutex_ held.
  void MakeRoom(const std::string& newest);

  const FileDescriptor folder_;
  const uint64_t capacity_;
  std::atomic<uint64_t> evictions_ = 0;
  std::mutex mutex_;  // held while files come and go
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_STORE_QUARANTINE_H_
