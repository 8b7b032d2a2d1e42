#include "server/engine/rows/path_work.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "geodesic/path.h"

namespace geodesic::server {
namespace {

// Few, since a reader may let those of a few rows wait; and more than one,
// since each row waits for a thread.
constexpr uint64_t kPathsPerRow = 16;

}  // namespace

PathWork::PathWork(const FieldCall& call, const FieldAnswer& answer)
    : call_(call), answer_(answer) {
  TargetReader targets;
  while (targets.next < call_.query->targets.size()) {
    if (targets.next % kPathsPerRow == 0) first_targets_.push_back(targets);
    targets.Next(call_, answer_);
  }
}

absl::StatusOr<AnswerRow> PathWork::Answer(uint64_t row, Checkpoint& checkpoint,
                                           ByteReservation memory) const {
  constexpr double kUnreached = std::numeric_limits<double>::infinity();
  const PathTracer& tracer = *answer_.derived->paths;
  AnswerRow result;
  result.memory = std::move(memory);
  TargetReader targets = first_targets_[row];
  const uint64_t end = std::min<uint64_t>(targets.next + kPathsPerRow,
                                          call_.query->targets.size());
  while (targets.next < end) {
    const TargetReader::Target target = targets.Next(call_, answer_);
    // The field may reach further than was asked.
    if (target.distance > call_.reach.radius) {
      result.paths.push_back({.distance = kUnreached, .length = kUnreached});
    } else {
      absl::StatusOr<GeodesicPath> path =
          target.is_own ? tracer.ToTarget(target.number, checkpoint)
                        : tracer.ToVertex(target.number, checkpoint);
      if (!path.ok()) return path.status();
      result.paths.push_back(*std::move(path));
    }
    absl::Status room = result.memory.GrowTo(BytesOf(result.paths));
    if (!room.ok()) return room;
  }
  return result;
}

}  // namespace geodesic::server
