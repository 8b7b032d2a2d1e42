#include "server/rpc/streams/field_stream.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "geodesic/field_quantities.h"
#include "geodesic_types/field_path.h"
#include "server/engine/base/argument_checks.h"
#include "server/rpc/messages/translation.h"

namespace geodesic::server {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// 512 KiB a message: large enough to stream at the speed of memory, small
// enough to cost little when a reader stalls.
constexpr uint64_t kValuesPerChunk = 65536;
// Distances, gradients and labels together are four times as large.
constexpr uint64_t kVerticesPerRichChunk = 16384;
constexpr size_t kSettledPerChunk = 32768;

}  // namespace

FieldChunks::FieldChunks(const FieldCall& call, FieldAnswer answer,
                         FieldExtras extras, v1::ValueType value_type,
                         uint64_t first_vertex)
    : call_(call),
      answer_(std::move(answer)),
      extras_(extras),
      value_type_(value_type),
      radius_(std::min(call.reach.radius, RadiusOfTargets())),
      next_vertex_(first_vertex) {
  // Distances sent before the stream broke may have been cut, too.
  const std::span<const double> all = answer_.field->distances;
  if (std::isinf(radius_)) return;
  for (const double distance : all.first(std::min(first_vertex, all.size()))) {
    Cut(distance);
  }
}

double FieldChunks::RadiusOfTargets() const {
  // What is settled was sent as it came, and may reach further.
  if (!call_.reach.LimitsTargets() || extras_.settled_order) return kInfinity;
  std::vector<double> distances(call_.query->targets.size());
  TargetReader targets;
  for (double& d : distances) d = targets.Next(call_, answer_).distance;
  const auto last =
      distances.begin() + static_cast<std::ptrdiff_t>(call_.reach.targets - 1);
  std::ranges::nth_element(distances, last);
  return *last;
}

double FieldChunks::Cut(double distance) {
  if (distance <= radius_) return distance;
  was_cut_ |= distance < kInfinity;
  return kInfinity;
}

bool FieldChunks::Next(v1::FieldChunk& chunk) {
  const std::span<const double> all = answer_.field->distances;
  if (next_vertex_ >= all.size()) return false;
  const uint64_t most =
      extras_.NeedTrace() ? kVerticesPerRichChunk : kValuesPerChunk;
  const std::span<const double> part =
      all.subspan(next_vertex_, std::min(most, all.size() - next_vertex_));
  chunk.set_offset(next_vertex_);
  if (std::isinf(radius_)) {
    SetValues(part, value_type_, *chunk.mutable_distances());
  } else {
    values_.clear();
    for (const double distance : part) values_.push_back(Cut(distance));
    SetValues(values_, value_type_, *chunk.mutable_distances());
  }
  if (extras_.nearest_sources) {
    std::string& bytes = *chunk.mutable_nearest_sources();
    bytes.clear();
    for (size_t v = next_vertex_; v < next_vertex_ + part.size(); ++v) {
      const uint32_t source = answer_.derived->nearest_sources[v];
      AppendBytes(source == kNoSource || all[v] > radius_
                      ? kNoSource
                      : call_.source_numbers[source],
                  bytes);
    }
  }
  if (extras_.certified_errors) {
    const std::vector<float>& errors = answer_.field->certified_errors;
    std::string& bytes = *chunk.mutable_certified_errors();
    bytes.clear();
    for (size_t v = next_vertex_; v < next_vertex_ + part.size(); ++v) {
      AppendBytes(errors.empty() || all[v] > radius_ ? 0.0f : errors[v], bytes);
    }
  }
  if (extras_.gradients) {
    values_.clear();
    for (size_t v = next_vertex_; v < next_vertex_ + part.size(); ++v) {
      const Point gradient =
          all[v] > radius_ ? Point{} : answer_.derived->gradients[v];
      values_.insert(values_.end(), gradient.begin(), gradient.end());
    }
    SetValues(values_, value_type_, *chunk.mutable_gradients());
  }
  next_vertex_ += part.size();
  return true;
}

bool FieldChunks::NextTargets(v1::TargetChunk& chunk) {
  const uint64_t all = call_.query->targets.size();
  if (targets_.next >= all) return false;
  const uint64_t end = std::min(targets_.next + kValuesPerChunk, all);
  chunk.set_offset(targets_.next);
  values_.clear();
  while (targets_.next < end) {
    values_.push_back(Cut(targets_.Next(call_, answer_).distance));
  }
  SetValues(values_, value_type_, *chunk.mutable_distances());
  return true;
}

double FieldChunks::settled_radius() const {
  const double settled = answer_.field->settled_radius;
  // A whole field that lies within the radius was sent as a whole.
  if (std::isinf(settled) && !was_cut_) return settled;
  return std::min(settled, radius_);
}

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
      engine().fields().Compute(question, Shared(this));
  if (!call.ok()) return call.status();
  call_ = *std::move(call);
  KeepQuestion();
  if (call_->answer.has_value()) answer_ = *std::exchange(call_->answer, {});
  return absl::OkStatus();
}

void FieldStream::Cancel() { engine().fields().Cancel(*call_); }

void FieldStream::OnProgress(const Progress& progress) {
  Update([&] { progress_ = ToProto(progress); });
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
  // Final vertices are sent even if the rest never comes.
  if (FillSettled(message)) return NextMessage::kSend;
  if (!answer_.has_value()) {
    if (!progress_.has_value()) return NextMessage::kWait;
    *message.mutable_progress() = *std::exchange(progress_, {});
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
  chunks_.emplace(*call_, answer, extras_, value_type_, first_vertex);
  field_id_ = MakeFieldId();
  if (resumption_.has_value() && resumption_->field_id() != field_id_) {
    return FieldNotKept();
  }
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

std::string FieldStream::MakeFieldId() {
  // One version of the program gives equal questions equal bits up to `radius`.
  const double radius =
      std::min(chunks_->answer().field->settled_radius, chunks_->radius());
  question_.Update({reinterpret_cast<const char*>(&radius), sizeof(radius)});
  // An exact field may answer a question with a tolerance.
  const double error = chunks_->answer().field->certified_error;
  question_.Update({reinterpret_cast<const char*>(&error), sizeof(error)});
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
  // The message is reused.
  chunk.clear_field_id();
  if (!chunks_->Next(chunk)) return false;
  if (!field_id_.empty()) chunk.set_field_id(std::exchange(field_id_, {}));
  entry().add_bytes(chunk.distances().size() + chunk.nearest_sources().size() +
                    chunk.gradients().size() + chunk.certified_errors().size());
  return true;
}

bool FieldStream::FillTargets(v1::ComputeFieldResponse& message) {
  v1::TargetChunk& chunk = *message.mutable_targets();
  if (!chunks_->NextTargets(chunk)) return false;
  entry().add_bytes(chunk.distances().size());
  return true;
}

AlgorithmChoice FieldStream::algorithm() const {
  if (call_->method.has_value()) return *call_->method;
  return call_->query->algorithm;
}

void FieldStream::FillHeader(v1::FieldHeader& header) const {
  header.set_mesh_digest(call_->mesh->digest);
  header.set_vertex_count(call_->mesh->mesh->vertex_count());
  for (std::string& note : Notes(call_->mesh->summary)) {
    header.add_mesh_notes(std::move(note));
  }
  header.set_algorithm(ToProto(algorithm()));
  if (call_->method.has_value()) {
    *header.mutable_approximation() = ToProto(*call_->method);
  }
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
  const double error = answer.field->certified_error;
  trailer.set_relative_tolerance(RelativeTolerance(algorithm(), error));
  if (error > 0) trailer.set_certified_error(error);
  trailer.set_server_version(version());
  // No approximate distance is exact, however far the field reaches.
  trailer.set_settled_radius(
      call_->method.has_value() ? 0 : chunks_->settled_radius());
}

}  // namespace geodesic::server
