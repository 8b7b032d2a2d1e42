// Client::ComputeField and StreamField. Each reads a server stream, into its
// final buffer or for the callback. ComputeField resumes a stream that breaks.

#include <algorithm>
#include <string>
#include <utility>

#include "assemblers.h"
#include "connection.h"
#include "geodesic_client/errors.h"
#include "rpc_status.h"
#include "translate.h"

namespace geodesic::client {
namespace {

absl::StatusOr<v1::ComputeFieldRequest> ToRequest(const FieldQuery& query,
                                                  bool progressive) {
  auto request = MakeRequest<v1::ComputeFieldRequest>(query);
  if (!request.ok()) return request;
  if (query.stop_after_targets.has_value()) {
    request->set_stop_after_targets(*query.stop_after_targets);
  }
  if (query.nearest_sources) {
    request->add_quantities(v1::FIELD_QUANTITY_NEAREST_SOURCE);
  }
  if (query.gradients) request->add_quantities(v1::FIELD_QUANTITY_GRADIENT);
  if (query.certified_errors) {
    request->add_quantities(v1::FIELD_QUANTITY_CERTIFIED_ERROR);
  }
  request->set_progressive(progressive);
  return request;
}

// Reads one stream to its end.
absl::Status ReceiveStream(v1::FieldService::Stub* stub,
                           const v1::ComputeFieldRequest& request,
                           const CallOptions& options,
                           FieldAssembler* assembler) {
  Call call(options, request.mesh_digest());
  return ReadStream(&call, stub->ComputeField(call.context(), request),
                    [assembler](const v1::ComputeFieldResponse& message) {
                      return assembler->Consume(message);
                    });
}

// Prepares the next stream after one has failed. Returns false if there is to
// be none. Before an answer has begun, gRPC itself tries again.
bool ReadOn(const absl::Status& failed, int attempts,
            const CallOptions& options, FieldAssembler* assembler,
            v1::ComputeFieldRequest* request) {
  if (ErrorReason(failed) == "FIELD_NOT_KEPT") {
    assembler->Restart();
    request->clear_resumption();
    return attempts < kMaxAttempts;
  }
  if (!WaitToRetry(failed, attempts, options.stop)) return false;
  const FieldAssembler::Position position = assembler->Resume();
  request->clear_resumption();
  if (!position.field_id.empty()) {
    request->mutable_resumption()->set_field_id(position.field_id);
    request->mutable_resumption()->set_first_vertex(position.first_vertex);
  }
  return true;
}

absl::StatusOr<Field> Receive(v1::FieldService::Stub* stub,
                              const FieldQuery& query,
                              const SettledCallback& on_settled,
                              const CallOptions& options,
                              const SolveProgressCallback& progress,
                              bool retry) {
  absl::StatusOr<v1::ComputeFieldRequest> request =
      ToRequest(query, on_settled != nullptr);
  if (!request.ok()) return request.status();
  FieldAssembler assembler(query, on_settled, progress);
  bool begun = false;
  uint64_t most = 0;  // that has been received
  for (int attempts = 1;; ++attempts) {
    const absl::Status status =
        ReceiveStream(stub, *request, options, &assembler);
    if (status.ok()) return std::move(assembler).Finish();
    begun |= assembler.has_header();
    // Distances that were handed out cannot be taken back.
    if (!retry || !begun || on_settled != nullptr) return status;
    // Attempts count only while nothing new arrives.
    if (assembler.received() > most) attempts = 1;
    most = std::max(most, assembler.received());
    if (!ReadOn(status, attempts, options, &assembler, &*request)) {
      return status;
    }
  }
}

}  // namespace

absl::StatusOr<Field> Client::ComputeField(
    const FieldQuery& query, const CallOptions& options,
    const SolveProgressCallback& progress) {
  return Receive(connection_->fields.get(), query, nullptr, options, progress,
                 connection_->retry);
}

absl::StatusOr<Field> Client::StreamField(
    const FieldQuery& query, const SettledCallback& on_settled,
    const CallOptions& options, const SolveProgressCallback& progress) {
  return Receive(connection_->fields.get(), query, on_settled, options,
                 progress, connection_->retry);
}

}  // namespace geodesic::client
