// A file system of a few bytes that only this process sees: one that can
// really be full or read-only.

#ifndef GEODESIC_TESTS_SUPPORT_SMALL_DISK_H_
#define GEODESIC_TESTS_SUPPORT_SMALL_DISK_H_

#include <cstdint>
#include <memory>
#include <string>

#include "absl/status/statusor.h"

namespace geodesic::test {

// A tmpfs in a mount namespace of this process's own.
class SmallDisk {
 public:
  // Mounts it on an existing folder.
  // Errors: PERMISSION_DENIED where the platform forbids it, saying why.
  static absl::StatusOr<std::unique_ptr<SmallDisk>> Mount(
      const std::string& folder, uint64_t bytes);
  ~SmallDisk();
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  absl::Status SetReadOnly(bool is_read_only);

 private:
  SmallDisk(std::string folder, uint64_t bytes)
      : folder_(std::move(folder)), bytes_(bytes) {}

  const std::string folder_;
  const uint64_t bytes_;
};

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_SMALL_DISK_H_
