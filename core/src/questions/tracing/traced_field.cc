#include "questions/tracing/traced_field.h"

#include <cmath>
#include <span>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"

namespace geodesic {
namespace {

absl::Status CheckSize(size_t size, size_t expected, const char* what) {
  if (size == expected) return absl::OkStatus();
  return absl::InvalidArgumentError(
      absl::StrCat("the field has ", size, " ", what, ", not ", expected,
                   ": it was solved without a trace, or for another mesh or "
                   "another query"));
}

// Every pseudo-source and half-edge that a trace names must exist.
absl::Status CheckArrivals(std::span<const Arrival> arrivals, const Mesh& mesh,
                           size_t anchors) {
  for (const Arrival& arrival : arrivals) {
    if (arrival.pseudo_source == kNoPseudoSource) continue;
    if (arrival.pseudo_source >= mesh.vertex_count() + anchors ||
        (arrival.entry != kNoHalfEdge &&
         arrival.entry >= mesh.half_edge_count())) {
      return absl::InvalidArgumentError(
          absl::StrCat("the field's trace names pseudo-source ",
                       arrival.pseudo_source, " and half-edge ", arrival.entry,
                       ": it was solved for another mesh or another query"));
    }
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<TracedField> TracedField::Create(const Mesh& mesh,
                                                const ValidQuery& query,
                                                const DistanceField& field) {
  absl::Status status =
      CheckSize(field.distances.size(), mesh.vertex_count(), "distances");
  status.Update(CheckSize(field.arrivals.size(), mesh.vertex_count(),
                          "arrivals at vertices"));
  status.Update(CheckSize(field.target_distances.size(), query->targets.size(),
                          "distances of targets"));
  status.Update(CheckSize(field.target_arrivals.size(), query->targets.size(),
                          "arrivals at targets"));
  if (!status.ok()) return status;
  TracedField traced(mesh, query,
                     {.vertices = field.distances,
                      .targets = field.target_distances,
                      .vertex_arrivals = field.arrivals,
                      .target_arrivals = field.target_arrivals,
                      .exponent = mesh.scale_exponent()});
  status.Update(CheckArrivals(field.arrivals, mesh, traced.anchors_.size()));
  status.Update(
      CheckArrivals(field.target_arrivals, mesh, traced.anchors_.size()));
  if (!status.ok()) return status;
  return traced;
}

double TracedField::Scaled(double distance) const {
  return std::ldexp(distance, -distances_.exponent);
}

}  // namespace geodesic
