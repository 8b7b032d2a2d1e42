#include "server/store/blobs.h"

#include "absl/strings/str_cat.h"

namespace geodesic::server {

absl::Status BlobBody::Read(std::span<char> bytes) {
  if (bytes.size() > bytes_left_) {
    return absl::DataLossError(absl::StrCat("the body has ", bytes_left_,
                                            " bytes left, not ", bytes.size()));
  }
  absl::Status status = ReadNext(bytes);
  if (!status.ok()) return status;
  hash_.Update({bytes.data(), bytes.size()});
  bytes_left_ -= bytes.size();
  return absl::OkStatus();
}

absl::Status BlobBody::Finish(const std::string& sha256) {
  if (bytes_left_ > 0) {
    return absl::InternalError(
        absl::StrCat(bytes_left_, " bytes of the body were not read"));
  }
  if (hash_.FinishHex() != sha256) {
    return absl::DataLossError(
        "the body does not have the digest the header names");
  }
  return absl::OkStatus();
}

}  // namespace geodesic::server
