// Reads a streamed answer as query.proto lays it down: a header, progress, the
// answer's parts, a trailer.

#ifndef GEODESIC_CLIENT_ANSWER_STREAM_H_
#define GEODESIC_CLIENT_ANSWER_STREAM_H_

#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "call.h"
#include "geodesic/v1/matrix_service.pb.h"
#include "geodesic/v1/query.pb.h"
#include "geodesic_client/answer.h"
#include "rpc_status.h"
#include "translate.h"

namespace geodesic::client {

inline const v1::AnswerHeader& CommonHeader(const v1::AnswerHeader& header) {
  return header;
}
inline const v1::AnswerHeader& CommonHeader(const v1::MatrixHeader& header) {
  return header.answer();
}

// What becomes of the messages of an answer. `header`, `progress` and `part`
// take what the response calls so; header and part return a status, and one
// that is not OK ends the call. `part` also gets parts unknown here, which a
// later server may add.
template <typename Header, typename Progress, typename Part>
struct AnswerHandlers {
  Header header;
  Progress progress;
  Part part;
};

// Reads `reader` to its end. `count` is called then, for the number of items
// that have come.
// Errors: the server's; those of the handlers; DATA_LOSS if the stream breaks
// the protocol or is not complete.
template <typename Response, typename Reader, typename Handlers, typename Count>
absl::StatusOr<AnswerInfo> ReadAnswer(Call* call, Reader reader,
                                      const Handlers& handlers,
                                      const Count& count) {
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
      return handlers.header(response.header());
    }
    if (response.has_progress()) {
      handlers.progress(response.progress(), info);
      return absl::OkStatus();
    }
    if (response.has_trailer()) {
      has_trailer = true;
      info.compute_seconds = response.trailer().compute_seconds();
      info.windows_propagated = response.trailer().windows_propagated();
      item_count = response.trailer().item_count();
      return absl::OkStatus();
    }
    return handlers.part(response);
  };

  Response response;
  absl::Status broken;
  while (broken.ok() && reader->Read(&response)) broken = consume(response);
  if (!broken.ok()) call->context()->TryCancel();
  const absl::Status status = FromRpcStatus(reader->Finish());
  if (!broken.ok()) return broken;
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

// Handlers for the answers of one computation.
template <typename Part>
auto SolveHandlers(const SolveProgressCallback& callback, Part part) {
  const auto header = [](const v1::AnswerHeader&) { return absl::OkStatus(); };
  const auto progress = [&callback](const v1::SolveProgress& message,
                                    const AnswerInfo& info) {
    if (callback != nullptr) callback(FromProto(message, info.vertex_count));
  };
  return AnswerHandlers<decltype(header), decltype(progress), Part>{
      header, progress, std::move(part)};
}

// What a request of any answer says about its computation.
template <typename Query, typename Request>
absl::Status SetCommon(const Query& query, Request* request) {
  absl::StatusOr<v1::Algorithm> algorithm = AlgorithmFromName(query.algorithm);
  if (!algorithm.ok()) return algorithm.status();
  request->set_mesh_digest(query.mesh_digest);
  request->set_algorithm(*algorithm);
  request->set_priority(ToProto(query.priority));
  return absl::OkStatus();
}

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_ANSWER_STREAM_H_
