#include "server/rpc/isoline_stream.h"

#include <cmath>
#include <utility>

#include "absl/strings/str_cat.h"
#include "server/engine/argument_checks.h"
#include "server/engine/status_details.h"
#include "server/rpc/call_deadline.h"
#include "server/rpc/field_translation.h"
#include "server/rpc/polyline.h"
#include "server/rpc/surface_translation.h"

namespace geodesic::server {
namespace {

absl::Status CheckLevels(const google::protobuf::RepeatedField<double>& levels,
                         const Limits& limits) {
  if (levels.empty()) {
    return InvalidField("levels", "levels is empty: name at least one");
  }
  for (int i = 0; i < levels.size(); ++i) {
    if (std::isfinite(levels[i]) && levels[i] > 0) continue;
    const std::string field = absl::StrCat("levels[", i, "]");
    return InvalidField(field, absl::StrCat(field, " is ", levels[i],
                                            "; it must be finite and > 0"));
  }
  return CheckCount("levels", levels.size(), "max_levels", limits.max_levels);
}

uint64_t BytesOf(const std::vector<Isoline>& isolines) {
  uint64_t bytes = isolines.capacity() * sizeof(Isoline);
  for (const Isoline& isoline : isolines) {
    bytes += isoline.points.capacity() * sizeof(SurfacePoint) +
             isoline.positions.capacity() * sizeof(Point);
  }
  return bytes;
}

}  // namespace

grpc::ServerWriteReactor<v1::ComputeIsolinesResponse>* IsolineStream::Start(
    QueryEngine& engine, RequestLog& log, const std::string& version,
    grpc::CallbackServerContext& context,
    const v1::ComputeIsolinesRequest& request) {
  return Launch(std::shared_ptr<IsolineStream>(
      new IsolineStream(engine, log, version, context, request)));
}

IsolineStream::IsolineStream(QueryEngine& engine, RequestLog& log,
                             const std::string& version,
                             grpc::CallbackServerContext& context,
                             const v1::ComputeIsolinesRequest& request)
    : QuestionStream(engine, log, "ComputeIsolines", request.mesh_digest(),
                     version, context),
      context_(context),
      request_(request) {}

absl::Status IsolineStream::Ask() {
  absl::Status status = CheckLevels(request_.levels(), engine().limits());
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
  question.work = [isolines = isolines_,
                   levels = std::vector<double>(request_.levels().begin(),
                                                request_.levels().end())](
                      const Mesh& mesh, const Query& query,
                      const SolveOptions& options, Checkpoint& checkpoint,
                      ByteReservation& memory) -> absl::Status {
    absl::StatusOr<std::vector<Isoline>> found =
        geodesic::ComputeIsolines(mesh, query, levels, options, checkpoint);
    if (!found.ok()) return found.status();
    *isolines = *std::move(found);
    return memory.GrowTo(BytesOf(*isolines));
  };
  absl::StatusOr<QuestionCall> call = engine().StartQuestion(
      std::move(question),
      std::static_pointer_cast<IsolineStream>(shared_from_this()));
  if (!call.ok()) return call.status();
  call_ = *std::move(call);
  SetSubject(call_.mesh, call_.algorithm);
  return absl::OkStatus();
}

void IsolineStream::Cancel() { engine().Cancel(call_); }

void IsolineStream::OnProgress(const Progress& progress) {
  SetProgress(progress);
}

void IsolineStream::OnDone(const JobReport& report) {
  SetFinished(report.status, {report.seconds, report.windows_propagated},
              [] {});
}

absl::StatusOr<bool> IsolineStream::FillPart(
    v1::ComputeIsolinesResponse& message) {
  if (next_isoline_ == isolines_->size()) return false;
  const Isoline& isoline = (*isolines_)[next_isoline_];
  v1::Isoline& proto = *message.mutable_isoline();
  proto.set_number(next_isoline_);
  proto.set_level(isoline.level);
  proto.set_is_closed(isoline.is_closed);
  next_point_ = SetPiece(isoline.points, isoline.positions, next_point_,
                         *proto.mutable_piece());
  entry().add_bytes(proto.piece().positions().size());
  if (next_point_ == isoline.points.size()) {
    ++next_isoline_;
    next_point_ = 0;
  }
  return true;
}

uint64_t IsolineStream::item_count() const { return next_isoline_; }

}  // namespace geodesic::server
