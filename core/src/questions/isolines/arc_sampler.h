// Points on arcs, as many as a polyline needs to stay near them.

#ifndef GEODESIC_QUESTIONS_ISOLINES_ARC_SAMPLER_H_
#define GEODESIC_QUESTIONS_ISOLINES_ARC_SAMPLER_H_

#include <functional>
#include <span>

#include "absl/status/status.h"
#include "questions/isolines/level_tracer.h"
#include "surface/plane_point.h"

namespace geodesic {

// Of arcs that follow each other. No chord of the polyline is farther from them
// than `chord_error`, which may be infinite.
class ArcSampler {
 public:
  // Takes the next point; what it returns stops the sampling.
  using Emit = std::function<absl::Status(const PlanePoint&)>;

  // Told how many arcs were looked at; what it returns stops the sampling.
  using Step = FaceWays::Step;

  // `emit` and `step` outlive this object.
  ArcSampler(double chord_error, const Emit& emit, const Step& step)
      : chord_error_(chord_error), emit_(emit), step_(step) {}

  // What lies between the ends; at least two points where they coincide.
  absl::Status Between(std::span<const FrontArc> arcs) const;
  // All around a loop, at least three points.
  absl::Status Around(std::span<const FrontArc> loop) const;

 private:
  // Between ends that differ.
  absl::Status Within(std::span<const FrontArc> arcs) const;
  // Between the ends of a loop, at least two points.
  absl::Status Thirds(std::span<const FrontArc> loop) const;
  absl::Status Along(const FrontArc& arc) const;

  const double chord_error_;
  const Emit& emit_;
  const Step& step_;
};

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_ISOLINES_ARC_SAMPLER_H_
