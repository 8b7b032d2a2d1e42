#include "server/rpc/streams/prepare_stream.h"

#include <utility>
#include <variant>

#include "geodesic_types/field_path.h"
#include "server/rpc/messages/translation.h"

namespace geodesic::server {
namespace {

// Whether a mesh has all its landmarks.
bool HasLandmarks(MeshLibrary& meshes, const ResidentMesh& mesh) {
  const LandmarksHandle landmarks = meshes.landmarks().Find(mesh.digest);
  return landmarks != nullptr && !landmarks->next().has_value();
}

// What the landmarks of a mesh take.
uint64_t LandmarkBytes(MeshLibrary& meshes, const ResidentMesh& mesh) {
  const LandmarksHandle landmarks = meshes.landmarks().Find(mesh.digest);
  return landmarks == nullptr ? 0 : landmarks->bytes();
}

}  // namespace

absl::Status PrepareStream::Ask() {
  const absl::StatusOr<AlgorithmChoice> choice =
      FromProto(request().algorithm(), request().approximation());
  if (!choice.ok()) return choice.status();
  const absl::StatusOr<bool> is_batch = IsBatch(request().priority());
  if (!is_batch.ok()) return is_batch.status();
  choice_ = *choice;
  const auto* method = std::get_if<MethodChoice>(&choice_);
  if (method == nullptr && choice_ != AlgorithmChoice(kDefaultAlgorithm)) {
    return InvalidField("algorithm",
                        "algorithm: exact algorithms prepare nothing but the "
                        "landmarks of the default one; leave it out for these, "
                        "or name an approximate algorithm");
  }
  MeshLibrary& meshes = engine().meshes();
  absl::StatusOr<MeshHandle> mesh =
      meshes.Get(request().mesh_digest(), "mesh_digest");
  if (!mesh.ok()) return mesh.status();
  mesh_ = *std::move(mesh);
  if (method == nullptr && !meshes.landmarks().CanHold(*mesh_->mesh)) {
    return meshes.landmarks().Reserve(*mesh_->mesh).status();
  }
  was_prepared_ = method == nullptr
                      ? HasLandmarks(meshes, *mesh_)
                      : engine().methods().Find(mesh_, *method).has_value();
  absl::StatusOr<MethodJobs::Ticket> ticket = engine().methods().Prepare(
      mesh_, method == nullptr ? std::nullopt : std::optional(*method),
      {.done =
           [self = Shared(this)](const absl::StatusOr<Prepared>& prepared) {
             self->Update([&] { self->prepared_ = prepared; });
           },
       .progress =
           [self = Shared(this)](const Progress& progress) {
             self->Update([&] { self->progress_ = ToProto(progress); });
           }},
      requester(*is_batch));
  if (ticket.ok()) ticket_ = *std::move(ticket);
  return ticket.status();
}

absl::StatusOr<NextMessage> PrepareStream::Fill(
    v1::PrepareMethodResponse& message) {
  if (!std::exchange(has_header_, true)) {
    *message.mutable_header() = MakeHeader(*mesh_, choice_, version());
    return NextMessage::kSend;
  }
  if (!prepared_.has_value()) {
    if (!progress_.has_value()) return NextMessage::kWait;
    *message.mutable_progress() = *std::exchange(progress_, {});
    return NextMessage::kSend;
  }
  if (!prepared_->ok()) return prepared_->status();
  const Prepared& prepared = **prepared_;
  v1::PrepareMethodTrailer& trailer = *message.mutable_trailer();
  trailer.set_already_prepared(was_prepared_);
  trailer.set_prepared_bytes(prepared.method == nullptr
                                 ? LandmarkBytes(engine().meshes(), *mesh_)
                                 : prepared.method->bytes());
  trailer.set_prepare_seconds(prepared.prepare_seconds);
  return NextMessage::kSendLast;
}

}  // namespace geodesic::server
