#include "server/rpc/matrix_stream.h"

#include <memory>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "server/engine/status_details.h"
#include "server/rpc/call_deadline.h"
#include "server/rpc/field_translation.h"
#include "server/rpc/surface_translation.h"

namespace geodesic::server {

grpc::ServerWriteReactor<v1::ComputeMatrixResponse>* MatrixStream::Start(
    QueryEngine& engine, RequestLog& log, const std::string& version,
    grpc::CallbackServerContext& context,
    const v1::ComputeMatrixRequest& request) {
  return Launch(std::shared_ptr<MatrixStream>(
      new MatrixStream(engine, log, version, context, request)));
}

MatrixStream::MatrixStream(QueryEngine& engine, RequestLog& log,
                           const std::string& version,
                           grpc::CallbackServerContext& context,
                           const v1::ComputeMatrixRequest& request)
    : RowStream(engine, log, "ComputeMatrix", request.mesh_digest(), version,
                context),
      context_(context),
      request_(request) {}

absl::StatusOr<MatrixStream::Question> MatrixStream::Translate(
    const Limits& limits) const {
  Question question{.request = {.mesh_digest = request_.mesh_digest(),
                                .deadline = CallDeadline(context_)},
                    .priority = request_.priority()};
  const absl::StatusOr<v1::ValueType> value_type =
      ResolveValueType(request_.value_type());
  if (!value_type.ok()) return value_type.status();
  question.value_type = *value_type;
  const absl::StatusOr<Algorithm> algorithm = FromProto(request_.algorithm());
  if (!algorithm.ok()) return algorithm.status();
  Query& query = question.request.query;
  query.algorithm = *algorithm;
  switch (request_.layout()) {
    case v1::MATRIX_LAYOUT_UNSPECIFIED:
    case v1::MATRIX_LAYOUT_DENSE:
      break;
    case v1::MATRIX_LAYOUT_SPARSE:
      question.request.sparse = true;
      break;
    default:
      return InvalidField(
          "layout",
          absl::StrCat("layout is ", static_cast<int>(request_.layout()),
                       ", which this server does not know"));
  }
  const absl::Status status =
      AddRows(request_.sources(), limits, query, question.request.numbers);
  if (!status.ok()) return status;
  absl::StatusOr<std::vector<SurfacePoint>> targets =
      TargetsFromProto(request_.targets(), limits);
  if (!targets.ok()) return targets.status();
  query.targets = *std::move(targets);
  if (request_.has_max_distance()) {
    question.request.radius = request_.max_distance();
  }
  return question;
}

MatrixStream::Chunk MatrixStream::MakeChunk(v1::ComputeMatrixResponse& message,
                                            uint64_t row, uint64_t value_count,
                                            uint64_t offset) const {
  auto& chunk = *message.mutable_chunk();
  chunk.set_row(row);
  chunk.set_value_count(value_count);
  chunk.set_offset(offset);
  return {chunk.mutable_columns(), chunk.mutable_values()};
}

}  // namespace geodesic::server
