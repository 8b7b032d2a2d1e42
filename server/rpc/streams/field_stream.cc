#include "server/rpc/streams/field_stream.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "geodesic/field_path.h"
#include "server/engine/base/argument_checks.h"
#include "server/rpc/messages/field_translation.h"
#include "server/rpc/messages/value_bytes.h"

namespace geodesic::server {
namespace {

constexpr size_t kSettledPerChunk = 32768;

}  // namespace

absl::Status FieldStream::Ask() {
  const absl::StatusOr<v1::ValueType> value_type =
      ResolveValueType(request().value_type());
  if (!value_type.ok()) return value_type.status();
  value_type_ = *value_type;
  FieldRequest question;
  absl::Status status = BeginQuestion(question);
  if (status.ok()) status = Translate(request(), engine().limits(), question);
  if (!status.ok()) return status;
  extras_ = question.extras;
  absl::StatusOr<FieldCall> call =
      engine().ComputeField(question, Shared(this));
  if (!call.ok()) return call.status();
  call_ = *std::move(call);
  KeepQuestion();
  if (call_->answer.has_value()) answer_ = *std::exchange(call_->answer, {});
  return absl::OkStatus();
}

void FieldStream::Cancel() { engine().Cancel(*call_); }

void FieldStream::OnProgress(const Progress& progress) {
  Update([&] {
    progress_ = progress;
    progress_->distances = {};  // valid during this call only
  });
}

void FieldStream::OnField(const absl::StatusOr<FieldAnswer>& answer) {
  Update([&] { answer_ = answer; });
}

absl::StatusOr<NextMessage> FieldStream::Fill(
    v1::ComputeFieldResponse& message) {
  if (!std::exchange(header_sent_, true)) {
    FillHeader(*message.mutable_header());
    return NextMessage::kSend;
  }
  // What is final goes out even if the rest never comes.
  if (FillSettled(message)) return NextMessage::kSend;
  if (!answer_.has_value()) {
    if (!progress_.has_value()) return NextMessage::kWait;
    *message.mutable_progress() = ToProto(*std::exchange(progress_, {}));
    return NextMessage::kSend;
  }
  if (!answer_->ok()) return answer_->status();
  if (!chunks_.has_value()) {
    if (absl::Status status = StartChunks(); !status.ok()) return status;
  }
  if (!extras_.settled_order && FillChunk(message)) return NextMessage::kSend;
  if (FillTargets(message)) return NextMessage::kSend;
  FillTrailer(*message.mutable_trailer());
  return NextMessage::kSendLast;
}

absl::Status FieldStream::StartChunks() {
  const FieldAnswer& answer = **answer_;
  const uint64_t first_vertex =
      resumption_.has_value() ? resumption_->first_vertex() : 0;
  const uint64_t vertices = call_->mesh->mesh->vertex_count();
  if (first_vertex > vertices) {
    return InvalidField(
        "resumption.first_vertex",
        absl::StrCat("resumption.first_vertex is ", first_vertex,
                     "; the mesh has ", vertices, " vertices"));
  }
  field_id_ = MakeFieldId(answer);
  if (resumption_.has_value() && resumption_->field_id() != field_id_) {
    return FieldNotKept();
  }
  chunks_.emplace(*call_, answer, extras_, value_type_, first_vertex);
  return absl::OkStatus();
}

void FieldStream::KeepQuestion() {
  v1::ComputeFieldRequest& question = request();
  if (question.has_resumption()) resumption_ = question.resumption();
  question.clear_resumption();
  question.clear_priority();
  question_.Update(version());
  question_.Update(question.SerializeAsString());
}

std::string FieldStream::MakeFieldId(const FieldAnswer& answer) {
  // Equal questions get equal bits, from the same program and as far as the
  // search came.
  const double radius =
      std::min(answer.field->settled_radius, call_->reach.radius);
  question_.Update({reinterpret_cast<const char*>(&radius), sizeof(radius)});
  return question_.FinishHex();
}

bool FieldStream::FillSettled(v1::ComputeFieldResponse& message) {
  if (call_->settled == nullptr) return false;
  const std::vector<SettledVertex> settled =
      call_->settled->Read(settled_, kSettledPerChunk);
  if (settled.empty()) return false;
  v1::SettledChunk& chunk = *message.mutable_settled();
  chunk.set_offset(settled_);
  chunk.mutable_vertices()->clear();
  std::vector<double> distances;
  distances.reserve(settled.size());
  for (const SettledVertex& vertex : settled) {
    AppendBytes(vertex.vertex, *chunk.mutable_vertices());
    distances.push_back(vertex.distance);
  }
  SetValues(distances, value_type_, *chunk.mutable_distances());
  settled_ += settled.size();
  entry().add_bytes(chunk.vertices().size() + chunk.distances().size());
  return true;
}

bool FieldStream::FillChunk(v1::ComputeFieldResponse& message) {
  v1::FieldChunk& chunk = *message.mutable_chunk();
  // The message is used again and again.
  chunk.clear_field_id();
  if (!chunks_->Next(chunk)) return false;
  if (!field_id_.empty()) chunk.set_field_id(std::exchange(field_id_, {}));
  entry().add_bytes(chunk.distances().size() + chunk.nearest_sources().size() +
                    chunk.gradients().size());
  return true;
}

bool FieldStream::FillTargets(v1::ComputeFieldResponse& message) {
  v1::TargetChunk& chunk = *message.mutable_targets();
  if (!chunks_->NextTargets(chunk)) return false;
  entry().add_bytes(chunk.distances().size());
  return true;
}

void FieldStream::FillHeader(v1::FieldHeader& header) const {
  header.set_mesh_digest(call_->mesh->digest);
  header.set_vertex_count(call_->mesh->mesh->vertex_count());
  header.set_algorithm(ToProto(call_->query->algorithm));
  header.set_origin(ToProto(call_->origin));
  header.set_value_type(value_type_);
  header.set_target_count(call_->query->targets.size());
}

void FieldStream::FillTrailer(v1::FieldTrailer& trailer) const {
  const FieldAnswer& answer = chunks_->answer();
  trailer.set_origin(ToProto(call_->origin == FieldOrigin::kJoined
                                 ? FieldOrigin::kJoined
                                 : answer.origin));
  *trailer.mutable_statistics() = ToProto(answer.field->statistics);
  trailer.set_relative_tolerance(kRelativeTolerance);
  trailer.set_server_version(version());
  trailer.set_settled_radius(chunks_->settled_radius());
}

}  // namespace geodesic::server
