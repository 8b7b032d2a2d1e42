#include "server/engine/meshes/decimation_store.h"

#include <utility>

namespace geodesic::server {

uint64_t DecimationStore::BytesOf(uint64_t faces) {
  constexpr uint64_t kEntryBytes = 256;
  return faces * sizeof(Triangle) + kEntryBytes;
}

absl::StatusOr<DecimationHandle> DecimationStore::Insert(
    DecimationKey key, std::vector<Triangle> triangles) {
  absl::StatusOr<ByteReservation> room =
      decimations_.Reserve(BytesOf(triangles.size()));
  if (!room.ok()) return room.status();
  return decimations_
      .Insert(std::move(key), std::move(triangles), *std::move(room))
      .value;
}

void DecimationStore::EraseMesh(const std::string& digest) {
  decimations_.EraseIf(
      [&](const DecimationKey& key) { return key.mesh_digest == digest; });
}

}  // namespace geodesic::server
