#include "server/engine/meshes/method_store.h"

#include <limits>
#include <utility>

#include "absl/strings/cord.h"

namespace geodesic::server {
namespace {

constexpr uint64_t kEntryBytes = 256;

// A payload of what CheckPrepared answers.
constexpr char kNotPrepared[] = "geodesic/not-prepared";

// Before all others.
constexpr MethodChoice kFirst = {.lambda =
                                     -std::numeric_limits<double>::infinity()};

}  // namespace

absl::Status CheckPrepared(const std::optional<MethodHandle>& method) {
  if (!method.has_value() || method->method != nullptr) {
    return absl::OkStatus();
  }
  absl::Status status =
      absl::UnavailableError("the mesh is not prepared for this method yet");
  status.SetPayload(kNotPrepared, absl::Cord());
  return status;
}

bool IsNotPrepared(const absl::Status& status) {
  return status.GetPayload(kNotPrepared).has_value();
}

std::optional<RowMethod> RowMethodOf(
    const std::optional<MethodHandle>& method) {
  if (!method.has_value()) return std::nullopt;
  return RowMethod{method->choice.method, method->method};
}

MethodHandle MethodStore::ToHandle(const MeshHandle& mesh,
                                   const Methods::Handle& kept) {
  return {
      .mesh = mesh,
      .choice = kept->description.choice,
      .method = std::shared_ptr<const PreparedMethod>(kept, kept->method.get()),
      .prepare_seconds = kept->description.prepare_seconds};
}

std::optional<MethodHandle> MethodStore::Find(const MeshHandle& mesh,
                                              const MethodChoice& choice) {
  const Methods::Handle kept = methods_.Find({mesh->digest, choice});
  // A mesh that went and came back is another object.
  if (kept == nullptr || kept->mesh.lock() != mesh) return std::nullopt;
  return ToHandle(mesh, kept);
}

absl::StatusOr<MethodHandle> MethodStore::Insert(const MethodHandle& made) {
  const uint64_t bytes = made.method->bytes();
  absl::StatusOr<ByteReservation> room = methods_.Reserve(bytes + kEntryBytes);
  if (!room.ok()) return room.status();
  const Methods::Handle kept =
      methods_
          .Insert({made.mesh->digest, made.choice},
                  {{made.choice, bytes, made.prepare_seconds},
                   made.mesh,
                   made.method},
                  *std::move(room),
                  [&](const Kept& present) {
                    return present.mesh.lock() == made.mesh;
                  })
          .value;
  return ToHandle(made.mesh, kept);
}

void MethodStore::EraseMesh(const std::string& digest) {
  methods_.EraseIf([&](const Key& key) { return key.mesh_digest == digest; });
}

std::vector<MethodDescription> MethodStore::Describe(
    const std::string& digest) const {
  std::vector<MethodDescription> all;
  for (const Methods::Handle& kept :
       methods_.List({digest, kFirst}, methods_.size())) {
    const MeshHandle mesh = kept->mesh.lock();
    if (mesh == nullptr || mesh->digest != digest) break;
    all.push_back(kept->description);
  }
  return all;
}

}  // namespace geodesic::server
