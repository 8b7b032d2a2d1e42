// One upload; its bytes are checked and counted before they are kept.

#ifndef GEODESIC_SERVER_ENGINE_MESHES_MESH_UPLOAD_H_
#define GEODESIC_SERVER_ENGINE_MESHES_MESH_UPLOAD_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "digest/sha256.h"
#include "geodesic/checkpoint.h"
#include "geodesic/read_mesh.h"
#include "geodesic/triangle_soup.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/base/limits.h"
#include "server/engine/meshes/mesh_catalogue.h"

namespace geodesic::server {

// Not thread-safe. Call Append for each chunk, then Finish, then
// ReserveForParse and Parse until is_parsed().
class MeshUpload {
 public:
  // Allocates nothing that only the header announces.
  // Errors: INVALID_ARGUMENT naming the field of the header;
  // RESOURCE_EXHAUSTED naming the limit that the header exceeds.
  static absl::StatusOr<std::unique_ptr<MeshUpload>> Start(
      UploadHeader header, const Limits& limits,
      std::shared_ptr<ByteBudget> budget);

  // Takes the bytes at `offset`.
  // Errors: INVALID_ARGUMENT when the offset is not the number of bytes so far
  // or more bytes come than were announced; RESOURCE_EXHAUSTED when the budget
  // has no room. An upload that has failed is of no further use.
  absl::Status Append(uint64_t offset, std::string_view data);

  // Ends the upload.
  // Errors: INVALID_ARGUMENT when bytes are missing.
  absl::Status Finish();

  // The key of the uploaded file. Empty for arrays, whose bytes do not say how
  // many of them are vertices. REQUIRES: Finish succeeded.
  const std::optional<FileKey>& file() const { return file_; }

  // The memory of such an upload's bytes and, for most files, of its triangles.
  static uint64_t BytesToParse(const UploadHeader& header);

  // Takes memory for the triangles, or for what compressed bytes hold.
  // REQUIRES: Finish succeeded.
  // Errors: as ByteReservation::GrowTo.
  absl::Status ReserveForParse();

  // Makes triangles from the bytes and frees them, in linear time. Returns
  // false if the bytes were compressed with gzip, which they are no more, or if
  // the memory taken is too small for the file; ReserveForParse then takes
  // more. What is compressed may hold `max_upload_bytes`. REQUIRES:
  // ReserveForParse succeeded.
  // Errors: INVALID_ARGUMENT naming line, byte or element, or when the header
  // expects another mesh; RESOURCE_EXHAUSTED when a limit is passed; what
  // `checkpoint` says.
  absl::StatusOr<bool> Parse(Checkpoint& checkpoint);
  bool is_parsed() const { return soup_.has_value(); }

  // REQUIRES: is_parsed().
  TriangleSoup& soup() { return *soup_; }
  const std::string& digest() const { return digest_; }

  // The memory of the bytes, or of the triangles once they are parsed.
  ByteReservation& memory() { return reservation_; }

  const UploadHeader& header() const { return header_; }

 private:
  MeshUpload(UploadHeader header, const Limits& limits,
             std::shared_ptr<ByteBudget> budget);

  std::string_view Bytes() const { return {bytes_.data(), bytes_.size()}; }
  uint64_t SoupBound() const { return soup_factor_ * bytes_.size(); }
  // Decompresses the bytes, or doubts how much they hold.
  absl::Status Inflate(Checkpoint& checkpoint);
  absl::Status FreeAndExplain(const absl::Status& status);
  absl::StatusOr<TriangleSoup> ParseArrays(Checkpoint& checkpoint) const;
  absl::StatusOr<TriangleSoup> ParseFile(const ReadLimits& limits) const;

  const UploadHeader header_;
  const Limits limits_;
  const std::shared_ptr<ByteBudget> budget_;
  ByteReservation reservation_;
  std::vector<char> bytes_;
  // As long as they are compressed: a bound on what they hold. Otherwise 0.
  uint64_t inflated_bound_ = 0;
  uint64_t soup_factor_;  // bound: triangles' bytes / upload's bytes
  Sha256 hash_;
  std::optional<FileKey> file_;
  std::optional<TriangleSoup> soup_;
  std::string digest_;  // of soup_
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESHES_MESH_UPLOAD_H_
