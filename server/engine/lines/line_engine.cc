#include "server/engine/lines/line_engine.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace geodesic::server {
namespace {

// Few, since a reader may let those of a few rows wait; and more than one,
// since each row waits for a thread.
constexpr uint64_t kLinesPerRow = 64;

uint64_t BytesOf(const std::vector<TracedLine>& lines) {
  uint64_t bytes = lines.capacity() * sizeof(TracedLine);
  for (const TracedLine& line : lines) {
    bytes += line.points.capacity() * sizeof(SurfacePoint) +
             line.positions.capacity() * sizeof(Point);
  }
  return bytes;
}

}  // namespace

absl::StatusOr<LineCall> LineEngine::Trace(LineRequest request,
                                           std::function<void()> on_row) {
  absl::StatusOr<MeshHandle> mesh =
      meshes_.Get(request.mesh_digest, "mesh_digest");
  if (!mesh.ok()) return mesh.status();
  const absl::StatusOr<uint64_t> count = CountLines(request.lines);
  if (!count.ok()) return count.status();
  LineCall call{.mesh = *std::move(mesh), .line_count = *count};
  const uint64_t rows = (call.line_count + kLinesPerRow - 1) / kLinesPerRow;
  const bool is_batch = request.requester.is_batch;
  call.rows = std::make_shared<RowPipeline>(
      jobs_, scheduler_,
      RowJobs{.client = request.requester.client,
              .account = std::move(request.requester.account),
              .priority =
                  rows == 1 ? SolvePriority(is_batch) : RowPriority(is_batch),
              .deadline = request.deadline},
      rows,
      [mesh = call.mesh, lines = std::move(request.lines), count = *count](
          uint64_t row, Checkpoint& checkpoint,
          ByteReservation memory) -> absl::StatusOr<MatrixRow> {
        MatrixRow result{.memory = std::move(memory)};
        const uint64_t begin = row * kLinesPerRow;
        const uint64_t end = std::min(begin + kLinesPerRow, count);
        absl::Status status = TraceLines(
            *mesh->mesh, lines, begin, end, checkpoint, [&](TracedLine line) {
              result.lines.push_back(std::move(line));
              return result.memory.GrowTo(BytesOf(result.lines));
            });
        if (!status.ok()) return status;
        return result;
      },
      std::move(on_row));
  if (absl::Status status = call.rows->Start(); !status.ok()) return status;
  return call;
}

}  // namespace geodesic::server
