#include "server/engine/meshes/mesh_build.h"

#include <cstdint>
#include <utility>

#include "absl/strings/str_cat.h"
#include "geodesic/field_path.h"
#include "server/engine/meshes/mesh_digest.h"

namespace geodesic::server {

MeshBuild::MeshBuild(MeshLibrary& library, std::unique_ptr<MeshUpload> upload)
    : library_(library), upload_(std::move(upload)) {}

absl::Status MeshBuild::Reserve() {
  return soup_.has_value() ? ReserveForMesh() : upload_->ReserveForParse();
}

absl::Status MeshBuild::ReserveForMesh() {
  const uint64_t vertices = soup_->positions.size();
  const uint64_t faces = soup_->triangles.size();
  ByteReservation& memory = upload_->memory();
  const uint64_t held = memory.bytes();
  absl::Status status =
      memory.GrowTo(held + MeshLibrary::BytesToBuild(vertices, faces));
  if (!status.ok()) return status;
  absl::StatusOr<ByteReservation> room =
      library_.ReserveResident(digest_, vertices, faces);
  if (!room.ok()) {
    // Who waits holds no more than it has.
    memory.ShrinkTo(held);
    return room.status();
  }
  room_ = *std::move(room);
  return absl::OkStatus();
}

absl::StatusOr<std::optional<UploadResult>> MeshBuild::Run(
    Checkpoint& checkpoint) {
  if (!soup_.has_value()) {
    absl::StatusOr<std::optional<TriangleSoup>> soup =
        upload_->Parse(checkpoint);
    if (!soup.ok()) return soup.status();
    if (!soup->has_value()) return std::nullopt;
    soup_ = **std::move(soup);
    if (absl::Status s = checkpoint.Poll({}); !s.ok()) return s;
    if (absl::Status status = TakeDigest(); !status.ok()) return status;
    if (auto present = library_.FindBuilt(digest_, *upload_)) return present;
    absl::Status fits = library_.CheckCapacity(digest_, soup_->positions.size(),
                                               soup_->triangles.size());
    if (!fits.ok()) return fits;
    // Usually it is there, and the job need not wait again.
    if (!ReserveForMesh().ok()) return std::nullopt;
  }
  return library_.Build(*std::move(soup_), digest_, *upload_, std::move(room_),
                        checkpoint);
}

absl::Status MeshBuild::TakeDigest() {
  digest_ = MeshDigest(soup_->positions, soup_->triangles);
  const std::string& expected = upload_->header().expected_digest;
  if (expected.empty() || expected == digest_) return absl::OkStatus();
  return InvalidField("header.expected_digest",
                      absl::StrCat("the mesh has digest ", digest_,
                                   ", not the expected ", expected));
}

}  // namespace geodesic::server
