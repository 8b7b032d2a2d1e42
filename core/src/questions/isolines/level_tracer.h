// The isolines of one level in one face.

#ifndef GEODESIC_QUESTIONS_ISOLINES_LEVEL_TRACER_H_
#define GEODESIC_QUESTIONS_ISOLINES_LEVEL_TRACER_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "questions/isolines/face_ways.h"
#include "questions/isolines/front.h"
#include "solver/windows/window.h"
#include "surface/plane_point.h"

namespace geodesic {

// A stretch of a front.
struct FrontArc {
  Front front;
  double begin = 0;  // parameter
  double run = 0;

  PlanePoint From() const { return front.At(begin); }
  PlanePoint To() const { return front.At(begin + run); }
  // Over its chord; of more than half a circle infinite.
  double Height() const;
};

// Below the level each way covers a convex part of the face, which its front
// bounds; the isoline is the boundary of what they cover together. It is
// followed front by front: each until another way covers it, or until it ends
// where its way does, at which place others pass on.
class LevelTracer {
 public:
  using Step = FaceWays::Step;

  // All outlive this object.
  LevelTracer(const FaceWays& ways, double level, const Step& step);

  struct Trace {
    std::vector<FrontArc> arcs;
    // Where it leaves the face; none if rounding kept it from getting there.
    std::optional<PlanePoint> exit;
  };
  // From a place of the perimeter that the isoline enters the face at.
  absl::StatusOr<Trace> TraceFrom(const PlanePoint& place);

  // The closed isolines that stay inside the face, but for those already
  // traced.
  absl::StatusOr<std::vector<std::vector<FrontArc>>> Loops();
  // Whether a front has a place in the face that no other way covers and no
  // trace has passed.
  absl::StatusOr<bool> HasUntraced();
  // Whether Loops has seen a piece that is neither part of these nor of a
  // trace.
  bool has_lost_some() const { return has_lost_some_; }

 private:
  struct Stretch {
    double run = 0;
    bool leaves_face = false;
  };
  Stretch NextStretch(const Front& front, double from);
  // The way on from a place of the isoline, whose stretch is set; none if there
  // is none.
  absl::StatusOr<std::optional<FrontArc>> GoOn(const PlanePoint& place,
                                               bool& leaves_face);
  bool MayHaveLoops() const;
  // Places of the front inside the face that no other way covers, one between
  // every two that are covered.
  std::vector<double> BarePlaces(const Front& front);
  bool Passes(const FrontArc& arc, const PlanePoint& place) const;
  bool IsTraced(const PlanePoint& place) const;
  // Follows the isoline from a place inside; whether that leads back there.
  absl::StatusOr<bool> Close(const FrontArc& first_stretch,
                             std::vector<FrontArc>& arcs);

  const FaceWays& ways_;
  const double level_;
  const Step& step_;
  const double shallow_;  // what is covered by no more is not
  std::vector<Front> fronts_;
  std::vector<FrontArc> traced_;
  std::vector<Interval> parts_;  // scratch
  bool has_lost_some_ = false;
};

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_ISOLINES_LEVEL_TRACER_H_
