#include "server/rpc/sample_stream.h"

#include <algorithm>
#include <utility>

#include "server/engine/argument_checks.h"
#include "server/engine/status_details.h"
#include "server/rpc/call_deadline.h"
#include "server/rpc/field_translation.h"
#include "server/rpc/surface_translation.h"

namespace geodesic::server {
namespace {

constexpr uint64_t kSamplesPerChunk = 16384;

}  // namespace

grpc::ServerWriteReactor<v1::SampleFarthestPointsResponse>* SampleStream::Start(
    QueryEngine& engine, RequestLog& log, const std::string& version,
    grpc::CallbackServerContext& context,
    const v1::SampleFarthestPointsRequest& request) {
  return Launch(std::shared_ptr<SampleStream>(
      new SampleStream(engine, log, version, context, request)));
}

SampleStream::SampleStream(QueryEngine& engine, RequestLog& log,
                           const std::string& version,
                           grpc::CallbackServerContext& context,
                           const v1::SampleFarthestPointsRequest& request)
    : QuestionStream(engine, log, "SampleFarthestPoints", request.mesh_digest(),
                     version, context),
      context_(context),
      request_(request) {}

absl::Status SampleStream::Ask() {
  const uint64_t count = request_.count();
  if (count == 0) {
    return InvalidField("count", "count is 0; it must be at least 1");
  }
  absl::Status status = CheckCount("samples", count, "max_samples",
                                   engine().limits().max_samples);
  if (!status.ok()) return status;
  absl::StatusOr<Requester> requester = MakeRequester(request_.priority());
  if (!requester.ok()) return requester.status();
  QuestionRequest question{.mesh_digest = request_.mesh_digest(),
                           .deadline = CallDeadline(context_),
                           .requester = *std::move(requester)};
  const absl::StatusOr<Algorithm> algorithm = FromProto(request_.algorithm());
  if (!algorithm.ok()) return algorithm.status();
  question.query.algorithm = *algorithm;
  status = AddSources(request_.sources(), engine().limits(), question.query,
                      question.numbers);
  if (!status.ok()) return status;
  question.work = [samples = samples_, count](
                      const Mesh& mesh, const Query& query,
                      const SolveOptions& options, Checkpoint& checkpoint,
                      ByteReservation& memory) -> absl::Status {
    absl::Status room =
        memory.GrowTo(std::min<uint64_t>(count, mesh.vertex_count()) *
                      sizeof(FarthestSample));
    if (!room.ok()) return room;
    absl::StatusOr<std::vector<FarthestSample>> found =
        geodesic::SampleFarthestPoints(
            mesh, query, static_cast<uint32_t>(count), options, checkpoint);
    if (!found.ok()) return found.status();
    *samples = *std::move(found);
    return absl::OkStatus();
  };
  absl::StatusOr<QuestionCall> call = engine().StartQuestion(
      std::move(question),
      std::static_pointer_cast<SampleStream>(shared_from_this()));
  if (!call.ok()) return call.status();
  call_ = *std::move(call);
  SetSubject(call_.mesh, call_.algorithm);
  return absl::OkStatus();
}

void SampleStream::Cancel() { engine().Cancel(call_); }

void SampleStream::OnProgress(const Progress& progress) {
  SetProgress(progress);
}

void SampleStream::OnDone(const JobReport& report) {
  SetFinished(report.status, {report.seconds, report.windows_propagated},
              [] {});
}

absl::StatusOr<bool> SampleStream::FillPart(
    v1::SampleFarthestPointsResponse& message) {
  const uint64_t end =
      std::min<uint64_t>(next_sample_ + kSamplesPerChunk, samples_->size());
  if (next_sample_ == end) return false;
  v1::SampleChunk& chunk = *message.mutable_samples();
  chunk.clear_samples();
  for (; next_sample_ < end; ++next_sample_) {
    const FarthestSample& sample = (*samples_)[next_sample_];
    v1::FarthestSample& proto = *chunk.add_samples();
    proto.set_vertex(sample.vertex);
    proto.set_distance(sample.distance);
  }
  return true;
}

uint64_t SampleStream::item_count() const { return next_sample_; }

}  // namespace geodesic::server
