// Reads the stream that answers a question.

#ifndef GEODESIC_CLIENT_READ_ANSWER_H_
#define GEODESIC_CLIENT_READ_ANSWER_H_

#include <cstdint>
#include <memory>

#include "absl/status/status.h"
#include "assemblers.h"
#include "connection.h"
#include "geodesic/v1/query.pb.h"
#include "geodesic_client/answer.h"
#include "translate.h"

namespace geodesic::client {

// What the headers and trailers of all answers have.
template <typename Header>
const v1::AnswerHeader& CommonHeader(const Header& header) {
  if constexpr (requires { header.answer(); }) {
    return header.answer();
  } else {
    return header;
  }
}
template <typename Trailer>
const v1::AnswerTrailer& CommonTrailer(const Trailer& trailer) {
  if constexpr (requires { trailer.answer(); }) {
    return trailer.answer();
  } else {
    return trailer;
  }
}

// What an answer says about itself before its parts.
inline void ReadHeader(const v1::AnswerHeader& header, AnswerInfo* info) {
  info->mesh_digest = header.mesh_digest();
  info->vertex_count = header.vertex_count();
  info->algorithm = AlgorithmName(header.algorithm());
  if (header.has_approximation()) {
    info->approximation = FromProto(header.approximation());
  }
  info->mesh_notes = {header.mesh_notes().begin(), header.mesh_notes().end()};
  info->relative_tolerance = header.relative_tolerance();
  info->server_version = header.server_version();
}

// Reads an answer to its end. As query.proto defines, it is a header, progress,
// parts and a trailer. `info` receives what the answer says about itself.
// `progress` is called with progress messages and `info` as known by then.
// `take` is called with the header, the trailer and all parts, also unknown
// ones that a later server may add; if it returns an error, the call ends.
// `count` is called at the end and returns how many items have arrived. Errors:
// the server's; those of `take`; DATA_LOSS if the stream breaks the protocol or
// is not complete.
template <typename Response, typename Progress, typename Take, typename Count>
absl::Status ReadAnswer(Call* call,
                        std::unique_ptr<grpc::ClientReader<Response>> reader,
                        const Progress& progress, const Take& take,
                        const Count& count, AnswerInfo* info) {
  bool has_header = false;
  bool has_trailer = false;
  uint64_t item_count = 0;
  const auto consume = [&](const Response& response) -> absl::Status {
    if (has_header == response.has_header() || has_trailer) {
      return absl::DataLossError("the server's answer is out of order");
    }
    if (response.has_header()) {
      has_header = true;
      ReadHeader(CommonHeader(response.header()), info);
    } else if (response.has_progress()) {
      progress(response.progress(), *info);
      return absl::OkStatus();
    } else if (response.has_trailer()) {
      has_trailer = true;
      const v1::AnswerTrailer& trailer = CommonTrailer(response.trailer());
      info->compute_seconds = trailer.compute_seconds();
      info->windows_propagated = trailer.windows_propagated();
      if (trailer.has_certified_error()) {
        info->certified_error = trailer.certified_error();
      }
      item_count = trailer.item_count();
    }
    return take(response);
  };
  absl::Status status = ReadStream(call, std::move(reader), consume);
  if (!status.ok()) return status;
  if (!has_trailer) {
    return absl::DataLossError("the server's answer ended without its trailer");
  }
  return CheckCount("items", count(), item_count);
}

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_READ_ANSWER_H_
