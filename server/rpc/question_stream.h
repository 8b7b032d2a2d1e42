// What the streams of one question share: header, progress, parts, trailer.

#ifndef GEODESIC_SERVER_RPC_QUESTION_STREAM_H_
#define GEODESIC_SERVER_RPC_QUESTION_STREAM_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/algorithm.h"
#include "geodesic/checkpoint.h"
#include "server/engine/mesh_store.h"
#include "server/rpc/answer_stream.h"
#include "server/rpc/field_translation.h"
#include "server/rpc/request_log.h"

namespace geodesic::server {

// What an answer cost.
struct AnswerCost {
  double seconds = 0;
  uint64_t windows_propagated = 0;
};

// A derived class asks the engine, names the mesh in Ask, calls SetFinished
// once the answer is there, and makes the parts.
template <typename Response>
class QuestionStream : public AnswerStream<Response> {
 protected:
  // REQUIRES: `engine` and `version` outlive the call.
  QuestionStream(QueryEngine& engine, RequestLog& log, std::string_view method,
                 const std::string& mesh_digest, const std::string& version,
                 grpc::CallbackServerContext& context)
      : AnswerStream<Response>(engine, log, method, mesh_digest, context),
        version_(version) {}

  // Fills the next part of the answer; false when there is none left. Under the
  // stream's lock, after SetFinished.
  virtual absl::StatusOr<bool> FillPart(Response& message) = 0;

  // Items that were sent, for the trailer.
  virtual uint64_t item_count() const = 0;

  // For Ask:
  void SetSubject(MeshHandle mesh, Algorithm algorithm) {
    mesh_ = std::move(mesh);
    algorithm_ = algorithm;
  }

  void SetProgress(const Progress& progress) {
    this->Update([&] {
      progress_ = progress;
      progress_->distances = {};  // valid during this call only
    });
  }

  // `change` puts the answer where FillPart finds it.
  template <typename Change>
  void SetFinished(absl::Status status, AnswerCost cost, Change change) {
    this->Update([&] {
      change();
      cost_ = cost;
      status_ = std::move(status);
    });
  }

  const MeshHandle& mesh() const { return mesh_; }

 private:
  absl::StatusOr<NextMessage> Fill(Response& message) final {
    if (!std::exchange(has_header_, true)) {
      FillHeader(*message.mutable_header());
      return NextMessage::kSend;
    }
    if (!status_.has_value()) {
      if (!progress_.has_value()) return NextMessage::kWait;
      *message.mutable_progress() = ToProto(*std::exchange(progress_, {}));
      return NextMessage::kSend;
    }
    if (!status_->ok()) return *status_;
    absl::StatusOr<bool> has_part = FillPart(message);
    if (!has_part.ok()) return has_part.status();
    if (*has_part) return NextMessage::kSend;
    v1::AnswerTrailer& trailer = *message.mutable_trailer();
    trailer.set_compute_seconds(cost_.seconds);
    trailer.set_windows_propagated(cost_.windows_propagated);
    trailer.set_item_count(item_count());
    return NextMessage::kSendLast;
  }

  void FillHeader(v1::AnswerHeader& header) const {
    header = MakeHeader(*mesh_, algorithm_, version_);
  }

  const std::string& version_;
  MeshHandle mesh_;
  Algorithm algorithm_ = kDefaultAlgorithm;

  // Guarded by the stream's lock:
  bool has_header_ = false;
  std::optional<Progress> progress_;  // newer than what was sent
  std::optional<absl::Status> status_;
  AnswerCost cost_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_QUESTION_STREAM_H_
