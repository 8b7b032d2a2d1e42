// Traces the paths of a question from its field.

#ifndef GEODESIC_SERVER_ENGINE_ROWS_PATH_WORK_H_
#define GEODESIC_SERVER_ENGINE_ROWS_PATH_WORK_H_

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/valid_query.h"
#include "server/engine/base/byte_budget.h"
#include "server/engine/fields/field_engine.h"
#include "server/engine/jobs/row_pipeline.h"

namespace geodesic::server {

// One question. Const functions are thread-safe.
class PathWork {
 public:
  // REQUIRES: `answer` has a tracer of paths; the call has a target.
  PathWork(const FieldCall& call, const FieldAnswer& answer);

  // Each has some of the targets, in order.
  uint64_t rows() const { return first_targets_.size(); }

  // Their paths, charged to `memory`. Beyond the reach of the question there
  // are none. Errors: as PathTracer::ToTarget, ByteReservation::GrowTo.
  absl::StatusOr<AnswerRow> Answer(uint64_t row, Checkpoint& checkpoint,
                                   ByteReservation memory) const;

 private:
  const FieldCall call_;
  const FieldAnswer answer_;
  std::vector<TargetReader> first_targets_;  // of each row
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_ROWS_PATH_WORK_H_
