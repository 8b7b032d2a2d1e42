#include "server/engine/meshes/landmark_store.h"

#include <utility>

namespace geodesic::server {
namespace {

constexpr uint64_t kDigestBytes = 64;

uint64_t ChargeOf(const Mesh& mesh) {
  return Landmarks::PlannedBytes(mesh) + sizeof(Landmarks) + kDigestBytes;
}

}  // namespace

uint32_t LandmarkStore::CountOf(const std::string& digest) const {
  const LandmarksHandle landmarks = landmarks_.Peek(digest);
  return landmarks == nullptr ? 0 : landmarks->count();
}

bool LandmarkStore::CanHold(const Mesh& mesh) const {
  return landmarks_.CheckCapacity(ChargeOf(mesh)).ok();
}

absl::StatusOr<ByteReservation> LandmarkStore::Reserve(const Mesh& mesh) {
  return landmarks_.Reserve(ChargeOf(mesh));
}

void LandmarkStore::Insert(const std::string& digest, Landmarks landmarks,
                           ByteReservation room) {
  const uint32_t count = landmarks.count();
  landmarks_.Insert(
      digest, std::move(landmarks), std::move(room),
      [count](const Landmarks& present) { return present.count() >= count; });
}

}  // namespace geodesic::server
