// Following a whole shortest path back, for PathTracer and TargetSearch.

#ifndef GEODESIC_QUESTIONS_TRACING_PATH_TRACER_H_
#define GEODESIC_QUESTIONS_TRACING_PATH_TRACER_H_

#include "absl/status/statusor.h"
#include "geodesic/path.h"
#include "questions/tracing/traced_field.h"
#include "solver/work_meter.h"

namespace geodesic {

// `distance`: the field's at `end`, in the unit of the file. Cost as
// FollowBack. Errors: INTERNAL: the trace does not lead back; the meter's.
absl::StatusOr<GeodesicPath> TracePath(const TracedField& field, PathEnd end,
                                       double distance, WorkMeter& meter);

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_TRACING_PATH_TRACER_H_
