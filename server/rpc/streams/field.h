// ComputeField.

#ifndef GEODESIC_SERVER_RPC_STREAMS_FIELD_H_
#define GEODESIC_SERVER_RPC_STREAMS_FIELD_H_

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/field_quantities.h"
#include "geodesic/v1/question_service.pb.h"
#include "server/engine/query_engine.h"
#include "server/rpc/messages/translation.h"
#include "server/rpc/streams/field_question.h"

namespace geodesic::server {

// Cuts the field off at the radius that was asked for, or at the last of the
// nearest targets that were, because it may reach further.
class FieldStream final : public FieldQuestion<v1::ComputeFieldRequest> {
 public:
  using FieldQuestion::FieldQuestion;

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  // What is copied before it is put.
  static constexpr uint64_t kNumbersAtOnce = 32768;

  absl::Status Translate(FieldRequest& question) override {
    absl::Status status =
        server::Translate(request(), engine().limits(), question);
    extras_ = question.extras;
    return status;
  }

  void Announce() override ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    codec::AnswerWriter& writer = this->writer();
    const auto announce = [&writer](const char* name, v1::ValueType type,
                                    std::vector<int64_t> shape) {
      return writer.Announce(name, type, shape);
    };
    const int64_t vertices = call().mesh->mesh->vertex_count();
    const auto targets = static_cast<int64_t>(call().query->targets.size());
    if (extras_.settled_order) {
      vertex_ = announce("settled_vertex", v1::VALUE_TYPE_UINT32, {-1});
      distance_ = announce("settled_distance", value_type(), {-1});
    } else {
      distance_ = announce("distance", value_type(), {vertices});
    }
    if (extras_.nearest_sources) {
      source_ = announce("nearest_source", v1::VALUE_TYPE_UINT32, {vertices});
    }
    if (extras_.gradients) {
      gradient_ = announce("gradient", value_type(), {vertices, 3});
    }
    if (extras_.certified_errors) {
      error_ = announce("certified_error", v1::VALUE_TYPE_FLOAT32, {vertices});
    }
    if (targets > 0) {
      target_ = announce("target_distance", value_type(), {targets});
    }
  }

  absl::StatusOr<NextMessage> FillBlocks() override
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    // Final vertices are sent even if the rest never comes.
    if (!PutSettled()) return NextMessage::kSend;
    return FieldQuestion::FillBlocks();
  }

  absl::StatusOr<NextMessage> FillFromField() override
      ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    if (!radius_.has_value()) Cut();
    if (!extras_.settled_order && !PutVertices()) return NextMessage::kSend;
    if (!PutTargets()) return NextMessage::kSend;
    const DistanceField& field = *answer().field;
    *trailer().mutable_statistics() = ToProto(field.statistics);
    // A whole field that lies within the radius was sent as a whole.
    const bool is_whole = std::isinf(field.settled_radius) && !was_cut_;
    const double settled =
        is_whole ? kInfinity : std::min(field.settled_radius, *radius_);
    // No approximate distance is exact, however far the field reaches.
    trailer().set_settled_radius(call().method.has_value() ? 0 : settled);
    return NextMessage::kSendLast;
  }

  std::string Variant() const override ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    // A progressive field is not resumed.
    if (!radius_.has_value()) return "";
    // One version of the program gives equal questions equal bits up to the
    // radius; and an exact field may answer a question with a tolerance.
    const DistanceField& field = *answer().field;
    const double numbers[] = {std::min(field.settled_radius, *radius_),
                              field.certified_error};
    return {reinterpret_cast<const char*>(numbers), sizeof(numbers)};
  }

  // Finds the radius, and whether vertices lie beyond.
  void Cut() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    radius_ = call().reach.radius;
    // What is settled was sent as it came, and may reach further.
    if (call().reach.LimitsTargets() && !extras_.settled_order) {
      std::vector<double> distances(call().query->targets.size());
      TargetReader targets;
      for (double& d : distances) d = targets.Next(call(), answer()).distance;
      const auto last = distances.begin() +
                        static_cast<std::ptrdiff_t>(call().reach.targets - 1);
      std::ranges::nth_element(distances, last);
      radius_ = std::min(*radius_, *last);
    }
    const auto is_beyond = [radius = *radius_](double d) {
      return d > radius && d < kInfinity;
    };
    was_cut_ = !std::isinf(*radius_) &&
               std::ranges::any_of(answer().field->distances, is_beyond);
  }

  // These return as AnswerWriter::Put.

  bool PutSettled() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    if (call().settled == nullptr) return true;
    for (;;) {
      const std::vector<SettledVertex> settled =
          call().settled->Read(settled_, kNumbersAtOnce);
      if (settled.empty()) return true;
      if (!writer().Put(vertex_, settled_, settled.size(),
                        [&](uint64_t i) { return settled[i].vertex; }) ||
          !writer().Put(distance_, settled_, settled.size(),
                        [&](uint64_t i) { return settled[i].distance; })) {
        return false;
      }
      settled_ += settled.size();
    }
  }

  bool PutVertices() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    const FieldAnswer& answer = this->answer();
    const std::vector<double>& all = answer.field->distances;
    const std::vector<float>& errors = answer.field->certified_errors;
    const uint64_t vertices = all.size();
    const double radius = *radius_;
    const bool is_whole =
        std::isinf(radius)
            ? writer().Put(distance_, 0, all)
            : writer().Put(distance_, 0, vertices, [&](uint64_t v) {
                return all[v] > radius ? kInfinity : all[v];
              });
    if (!is_whole) return false;
    if (extras_.nearest_sources &&
        !writer().Put(source_, 0, vertices, [&](uint64_t v) {
          const uint32_t source = answer.derived->nearest_sources[v];
          return source == kNoSource || all[v] > radius
                     ? kNoSource
                     : call().source_numbers[source];
        })) {
      return false;
    }
    if (extras_.gradients &&
        !writer().Put(gradient_, 0, 3 * vertices, [&](uint64_t i) {
          const Point& gradient = answer.derived->gradients[i / 3];
          return all[i / 3] > radius ? 0 : gradient[i % 3];
        })) {
      return false;
    }
    return !extras_.certified_errors ||
           writer().Put(error_, 0, vertices, [&](uint64_t v) {
             return errors.empty() || all[v] > radius ? 0.0f : errors[v];
           });
  }

  bool PutTargets() ABSL_EXCLUSIVE_LOCKS_REQUIRED(mutex_) {
    const uint64_t all = call().query->targets.size();
    while (targets_.next < all) {
      TargetReader targets = targets_;
      std::vector<double> distances(
          std::min<uint64_t>(kNumbersAtOnce, all - targets.next));
      for (double& distance : distances) {
        distance = targets.Next(call(), answer()).distance;
        if (distance <= *radius_) continue;
        was_cut_ |= distance < kInfinity;
        distance = kInfinity;
      }
      if (!writer().Put(target_, targets_.next, distances)) return false;
      targets_ = targets;
    }
    return true;
  }

  // Set by Translate and Announce, then constant:
  FieldExtras extras_;
  uint32_t vertex_ = 0;
  uint32_t distance_ = 0;
  uint32_t source_ = 0;
  uint32_t gradient_ = 0;
  uint32_t error_ = 0;
  uint32_t target_ = 0;

  // Entries of the log that were put.
  uint64_t settled_ ABSL_GUARDED_BY(mutex_) = 0;
  // Beyond which nothing is sent.
  std::optional<double> radius_ ABSL_GUARDED_BY(mutex_);
  bool was_cut_ ABSL_GUARDED_BY(mutex_) = false;  // there is something beyond
  // Of the targets that are to be put.
  TargetReader targets_ ABSL_GUARDED_BY(mutex_);
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_FIELD_H_
