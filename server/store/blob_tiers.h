// The places where a server keeps what it can make again, one behind the other:
// its own disk, then a tier that it shares with other servers.

#ifndef GEODESIC_SERVER_STORE_BLOB_TIERS_H_
#define GEODESIC_SERVER_STORE_BLOB_TIERS_H_

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "absl/functional/function_ref.h"
#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "server/store/blob_store.h"
#include "server/store/blobs.h"

namespace geodesic::server {

enum class BlobTier {
  kDisk,
  kShared,
};

// Find, Erase and EraseIf are about the disk alone: they say and do what needs
// no other server. What is in the shared tier stays there until it expires,
// since a mesh that goes here may well be asked about elsewhere. Thread-safe.
class BlobTiers {
 public:
  // Either may be null. REQUIRES: both outlive the object.
  BlobTiers(BlobStore* disk, Blobs* shared) : disk_(disk), shared_(shared) {}

  // See BlobStore.
  std::optional<BlobInfo> Find(const std::string& name);
  absl::Status Erase(const std::string& name);
  // Erases what has such metadata; what cannot be erased stays.
  void EraseIf(absl::FunctionRef<bool(std::string_view metadata)> is_erased);

  // Hands `take` the blob on disk and, if it is not there or `take` refuses it,
  // the one in the shared tier. Returns which it was that `take` accepted.
  // Errors: those of the last; see Blobs.
  absl::StatusOr<BlobTier> Read(const std::string& name, TakeBlob take);

  // Keeps a blob on disk, if there is one. Errors: as BlobStore::Put.
  absl::Status Keep(const std::string& name, std::string_view metadata,
                    std::span<const std::string_view> body);

  // Puts a blob that was made here into the shared tier, if there is one and
  // can. Takes no longer than copying it.
  void Share(const std::string& name, std::string_view metadata,
             std::span<const std::string_view> body);

  bool has_disk() const { return disk_ != nullptr; }
  bool has_shared() const { return shared_ != nullptr; }

 private:
  BlobStore* const disk_;
  Blobs* const shared_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_STORE_BLOB_TIERS_H_
