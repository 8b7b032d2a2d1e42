#include "server/store/blob_tiers.h"

#include <vector>

#include "absl/strings/str_cat.h"

namespace geodesic::server {

std::optional<BlobInfo> BlobTiers::Find(const std::string& name) {
  return disk_ != nullptr ? disk_->Find(name) : std::nullopt;
}

absl::Status BlobTiers::Erase(const std::string& name) {
  return disk_ != nullptr
             ? disk_->Erase(name)
             : absl::NotFoundError(absl::StrCat("there is no ", name));
}

void BlobTiers::EraseIf(
    absl::FunctionRef<bool(std::string_view metadata)> is_erased) {
  if (disk_ == nullptr) return;
  std::vector<std::string> names;
  disk_->ForEach([&](const std::string& name, std::string_view metadata) {
    if (is_erased(metadata)) names.push_back(name);
  });
  for (const std::string& name : names) (void)disk_->Erase(name);
}

absl::StatusOr<BlobTier> BlobTiers::Read(const std::string& name,
                                         TakeBlob take) {
  absl::Status status = absl::NotFoundError(absl::StrCat("there is no ", name));
  if (disk_ != nullptr && disk_->Find(name).has_value()) {
    status = disk_->Read(name, take);
    if (status.ok()) return BlobTier::kDisk;
  }
  if (shared_ != nullptr) {
    status = shared_->Read(name, take);
    if (status.ok()) return BlobTier::kShared;
  }
  return status;
}

absl::Status BlobTiers::Keep(const std::string& name, std::string_view metadata,
                             std::span<const std::string_view> body) {
  return disk_ != nullptr ? disk_->Put(name, metadata, body) : absl::OkStatus();
}

void BlobTiers::Share(const std::string& name, std::string_view metadata,
                      std::span<const std::string_view> body) {
  if (shared_ != nullptr) (void)shared_->Put(name, metadata, body);
}

}  // namespace geodesic::server
