// Asks a question and reads its answer.

#ifndef GEODESIC_CLIENT_ASK_H_
#define GEODESIC_CLIENT_ASK_H_

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <type_traits>

#include "absl/status/status.h"
#include "codec/answer_reader.h"
#include "connection.h"
#include "geodesic/v1/answer.pb.h"
#include "geodesic_client/answer.h"
#include "geodesic_client/errors.h"
#include "geodesic_client/field.h"
#include "rpc_status.h"
#include "translate.h"

namespace geodesic::client {

// Hands on the progress of one computation. `callback` may be empty.
inline TakeProgress ReportTo(const SolveProgressCallback& callback) {
  return [&callback](const v1::SolveProgress& progress, uint64_t vertices) {
    if (callback != nullptr) callback(FromProto(progress, vertices));
  };
}

// The same of `total` computations, `before` of which have been reported.
inline TakeProgress ReportTo(const CountProgressCallback& callback,
                             uint64_t total, uint64_t before = 0) {
  return [=, &callback](const v1::SolveProgress& progress, uint64_t) {
    if (callback != nullptr)
      callback(before + progress.items_finished(), total);
  };
}

// What an answer says about itself.
inline void ReadInfo(const codec::AnswerReader& reader, AnswerInfo* info) {
  const v1::AnswerHeader& header = reader.header();
  const v1::AnswerTrailer& trailer = reader.trailer();
  info->mesh_digest = header.mesh_digest();
  info->vertex_count = header.vertex_count();
  info->mesh_notes = {header.mesh_notes().begin(), header.mesh_notes().end()};
  info->algorithm = AlgorithmName(header.algorithm());
  if (header.has_approximation()) {
    info->approximation = FromProto(header.approximation());
  }
  info->server_version = header.server_version();
  info->relative_tolerance = trailer.relative_tolerance();
  if (trailer.has_certified_error()) {
    info->certified_error = trailer.certified_error();
  }
  info->compute_seconds = trailer.compute_seconds();
  info->windows_propagated = trailer.windows_propagated();
}
inline void ReadInfo(const codec::AnswerReader& reader, Field* field) {
  ReadInfo(reader, static_cast<AnswerInfo*>(field));
  const v1::AnswerTrailer& trailer = reader.trailer();
  field->origin = FromProto(trailer.origin());
  field->statistics = FromProto(trailer.statistics());
  field->settled_radius = trailer.settled_radius();
}

template <typename Request, typename Info>
absl::Status Client::Connection::Ask(
    Question<Request> question, absl::StatusOr<Request> request,
    const CallOptions& options, const TakeProgress& progress,
    codec::AnswerReader* reader, Info* info,
    const std::function<absl::Status()>& take) const {
  if (!request.ok()) return request.status();
  uint64_t most = 0;  // that has been received
  for (int attempts = 1;; ++attempts) {
    absl::Status taken;
    Call call(options, request->mesh_digest());
    absl::Status status = ReadStream(
        &call, (questions.get()->*question)(call.context(), *request),
        [&](const v1::Answer& message) {
          taken = reader->Consume(message);
          if (taken.ok() && message.has_progress()) {
            progress(message.progress(), reader->header().vertex_count());
          }
          if (taken.ok() && take != nullptr) taken = take();
          return taken;
        });
    if (status.ok() && !reader->has_trailer()) {
      return absl::DataLossError(
          "the server's answer ended without its trailer");
    }
    if (status.ok()) ReadInfo(*reader, info);
    if (status.ok() || !taken.ok() || !retry) return status;
    // Attempts count only while nothing new arrives.
    if (reader->received() > most) attempts = 1;
    most = std::max(most, reader->received());
    std::optional<v1::Resumption> rest = reader->Resume();
    const bool is_lost = ErrorReason(status) == "ANSWER_NOT_KEPT";
    if (is_lost) rest.reset();
    if constexpr (requires { request->progressive(); }) {
      if (request->progressive()) rest.reset();  // It cannot be resumed.
    }
    // What was handed out cannot be taken back.
    if (!rest.has_value() && take != nullptr && most > 0) return status;
    if (is_lost ? attempts >= kMaxAttempts
                : !WaitToRetry(status, attempts, options.stop)) {
      return status;
    }
    request->clear_resumption();
    if (rest.has_value()) {
      *request->mutable_resumption() = *std::move(rest);
    } else {
      reader->Restart();
    }
  }
}

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_ASK_H_
