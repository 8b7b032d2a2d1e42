#include "server/rpc/streams/field_stream.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geodesic/field_quantities.h"
#include "server/rpc/messages/translation.h"

namespace geodesic::server {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// What is copied before it is put.
constexpr uint64_t kNumbersAtOnce = 32768;

// The distance of the last target that was asked for; +infinity if all are.
double RadiusOfTargets(const FieldCall& call, const FieldAnswer& answer,
                       FieldExtras extras) {
  // What is settled was sent as it came, and may reach further.
  if (!call.reach.LimitsTargets() || extras.settled_order) return kInfinity;
  std::vector<double> distances(call.query->targets.size());
  TargetReader targets;
  for (double& d : distances) d = targets.Next(call, answer).distance;
  const auto last =
      distances.begin() + static_cast<std::ptrdiff_t>(call.reach.targets - 1);
  std::ranges::nth_element(distances, last);
  return *last;
}

}  // namespace

FieldCut::FieldCut(const FieldCall& call, const FieldAnswer& answer,
                   FieldExtras extras)
    : settled_radius_(answer.field->settled_radius),
      radius_(
          std::min(call.reach.radius, RadiusOfTargets(call, answer, extras))),
      was_cut_(!std::isinf(radius_) &&
               std::ranges::any_of(answer.field->distances, [&](double d) {
                 return d > radius_ && d < kInfinity;
               })) {}

double FieldCut::Target(double distance) {
  if (distance <= radius_) return distance;
  was_cut_ |= distance < kInfinity;
  return kInfinity;
}

double FieldCut::settled_radius() const {
  // A whole field that lies within the radius is sent as a whole.
  if (std::isinf(settled_radius_) && !was_cut_) return settled_radius_;
  return std::min(settled_radius_, radius_);
}

absl::Status FieldStream::Translate(FieldRequest& question) {
  absl::Status status =
      server::Translate(request(), engine().limits(), question);
  extras_ = question.extras;
  return status;
}

void FieldStream::Announce() {
  const int64_t vertices = call().mesh->mesh->vertex_count();
  if (extras_.settled_order) {
    settled_vertex_ =
        writer().Announce("settled_vertex", v1::VALUE_TYPE_UINT32, {-1});
    distance_ = writer().Announce("settled_distance", value_type(), {-1});
  } else {
    distance_ = writer().Announce("distance", value_type(), {vertices});
  }
  if (extras_.nearest_sources) {
    nearest_source_ =
        writer().Announce("nearest_source", v1::VALUE_TYPE_UINT32, {vertices});
  }
  if (extras_.gradients) {
    gradient_ = writer().Announce("gradient", value_type(), {vertices, 3});
  }
  if (extras_.certified_errors) {
    certified_error_ = writer().Announce("certified_error",
                                         v1::VALUE_TYPE_FLOAT32, {vertices});
  }
  const auto targets = static_cast<int64_t>(call().query->targets.size());
  if (targets > 0) {
    target_distance_ =
        writer().Announce("target_distance", value_type(), {targets});
  }
}

absl::StatusOr<NextMessage> FieldStream::FillBlocks() {
  // Final vertices are sent even if the rest never comes.
  if (!PutSettled()) return NextMessage::kSend;
  return FieldQuestion::FillBlocks();
}

absl::StatusOr<NextMessage> FieldStream::FillFromField() {
  if (!cut_.has_value()) cut_.emplace(call(), answer(), extras_);
  if (!extras_.settled_order && !PutVertices()) return NextMessage::kSend;
  if (!PutTargets()) return NextMessage::kSend;
  *trailer().mutable_statistics() = ToProto(answer().field->statistics);
  // No approximate distance is exact, however far the field reaches.
  trailer().set_settled_radius(
      call().method.has_value() ? 0 : cut_->settled_radius());
  return NextMessage::kSendLast;
}

std::string FieldStream::Variant() const {
  // A progressive field is not resumed.
  if (!cut_.has_value()) return "";
  // One version of the program gives equal questions equal bits up to the
  // radius; and an exact field may answer a question with a tolerance.
  const DistanceField& field = *answer().field;
  const double numbers[] = {std::min(field.settled_radius, cut_->radius()),
                            field.certified_error};
  return {reinterpret_cast<const char*>(numbers), sizeof(numbers)};
}

bool FieldStream::PutSettled() {
  if (call().settled == nullptr) return true;
  for (;;) {
    const std::vector<SettledVertex> settled =
        call().settled->Read(settled_, kNumbersAtOnce);
    if (settled.empty()) return true;
    if (!writer().Put(settled_vertex_, settled_, settled.size(),
                      [&](uint64_t i) { return settled[i].vertex; }) ||
        !writer().Put(distance_, settled_, settled.size(),
                      [&](uint64_t i) { return settled[i].distance; })) {
      return false;
    }
    settled_ += settled.size();
  }
}

bool FieldStream::PutVertices() {
  const std::vector<double>& all = answer().field->distances;
  const uint64_t vertices = all.size();
  const double radius = cut_->radius();
  const bool is_whole =
      std::isinf(radius)
          ? writer().Put(distance_, 0, all)
          : writer().Put(distance_, 0, vertices, [&](uint64_t v) {
              return all[v] > radius ? kInfinity : all[v];
            });
  if (!is_whole) return false;
  if (extras_.nearest_sources &&
      !writer().Put(nearest_source_, 0, vertices, [&](uint64_t v) {
        const uint32_t source = answer().derived->nearest_sources[v];
        return source == kNoSource || all[v] > radius
                   ? kNoSource
                   : call().source_numbers[source];
      })) {
    return false;
  }
  if (extras_.gradients &&
      !writer().Put(gradient_, 0, 3 * vertices, [&](uint64_t i) {
        return all[i / 3] > radius ? 0
                                   : answer().derived->gradients[i / 3][i % 3];
      })) {
    return false;
  }
  const std::vector<float>& errors = answer().field->certified_errors;
  return !extras_.certified_errors ||
         writer().Put(certified_error_, 0, vertices, [&](uint64_t v) {
           return errors.empty() || all[v] > radius ? 0.0f : errors[v];
         });
}

bool FieldStream::PutTargets() {
  const uint64_t all = call().query->targets.size();
  while (targets_.next < all) {
    TargetReader targets = targets_;
    std::vector<double> distances(
        std::min<uint64_t>(kNumbersAtOnce, all - targets.next));
    for (double& distance : distances) {
      distance = cut_->Target(targets.Next(call(), answer()).distance);
    }
    if (!writer().Put(target_distance_, targets_.next, distances)) return false;
    targets_ = targets;
  }
  return true;
}

}  // namespace geodesic::server
