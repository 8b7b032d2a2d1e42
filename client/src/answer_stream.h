// Asks a question and reads its streamed answer, as query.proto lays them down:
// the answer is a header, progress, parts and a trailer.

#ifndef GEODESIC_CLIENT_ANSWER_STREAM_H_
#define GEODESIC_CLIENT_ANSWER_STREAM_H_

#include <memory>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "call.h"
#include "geodesic/v1/matrix_service.pb.h"
#include "geodesic/v1/query.pb.h"
#include "geodesic_client/answer.h"
#include "translate.h"

namespace geodesic::client {

// A request with all of `query` that several questions have.
// Errors: INVALID_ARGUMENT for an unknown algorithm.
template <typename Request, typename Query>
absl::StatusOr<Request> MakeRequest(const Query& query) {
  absl::StatusOr<v1::Algorithm> algorithm = AlgorithmFromName(query.algorithm);
  if (!algorithm.ok()) return algorithm.status();
  Request request;
  request.set_mesh_digest(query.mesh_digest);
  request.set_algorithm(*algorithm);
  request.set_priority(ToProto(query.priority));
  if constexpr (requires { query.sources; }) {
    AddAll(query.sources, request.mutable_sources());
  }
  if constexpr (requires { query.targets; }) {
    AddAll(query.targets, request.mutable_targets());
  }
  if constexpr (requires { query.value_type; }) {
    request.set_value_type(ToProto(query.value_type));
  }
  if constexpr (requires { query.radius; }) {
    if (query.radius.has_value()) request.set_radius(*query.radius);
  }
  return request;
}

inline const v1::AnswerHeader& CommonHeader(const v1::AnswerHeader& header) {
  return header;
}
inline const v1::AnswerHeader& CommonHeader(const v1::MatrixHeader& header) {
  return header.answer();
}

// Reads `reader` to its end. `progress` takes the messages of that name with
// what is known by then, `take` the header and all parts; it may end the call
// by an error. Parts unknown here, which a later server may add, go to `take`
// too. `count` is called at the end, for the number of items that have come.
// Errors: the server's; those of `take`; DATA_LOSS if the stream breaks the
// protocol or is not complete.
template <typename Response, typename Progress, typename Take, typename Count>
absl::StatusOr<AnswerInfo> ReadAnswer(
    Call* call, std::unique_ptr<grpc::ClientReader<Response>> reader,
    const Progress& progress, const Take& take, const Count& count) {
  AnswerInfo info;
  bool has_header = false;
  bool has_trailer = false;
  uint64_t item_count = 0;
  const auto consume = [&](const Response& response) -> absl::Status {
    if (has_header == response.has_header() || has_trailer) {
      return absl::DataLossError("the server's answer is out of order");
    }
    if (response.has_header()) {
      has_header = true;
      const v1::AnswerHeader& header = CommonHeader(response.header());
      info.mesh_digest = header.mesh_digest();
      info.vertex_count = header.vertex_count();
      info.algorithm = AlgorithmName(header.algorithm());
      info.relative_tolerance = header.relative_tolerance();
      info.server_version = header.server_version();
    } else if (response.has_progress()) {
      progress(response.progress(), info);
      return absl::OkStatus();
    } else if (response.has_trailer()) {
      has_trailer = true;
      info.compute_seconds = response.trailer().compute_seconds();
      info.windows_propagated = response.trailer().windows_propagated();
      item_count = response.trailer().item_count();
      return absl::OkStatus();
    }
    return take(response);
  };
  absl::Status status = ReadStream(call, std::move(reader), consume);
  if (!status.ok()) return status;
  if (!has_trailer) {
    return absl::DataLossError("the server's answer ended without its trailer");
  }
  if (const uint64_t received = count(); received != item_count) {
    return absl::DataLossError(absl::StrCat("the server sent ", received,
                                            " of ", item_count, " items"));
  }
  return info;
}

// Takes the progress of one computation for a callback, which may be empty.
inline auto ReportTo(const SolveProgressCallback& callback) {
  return [&callback](const v1::SolveProgress& message, const AnswerInfo& info) {
    if (callback != nullptr) callback(FromProto(message, info.vertex_count));
  };
}

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_ANSWER_STREAM_H_
