#include "server/engine/rows/row_engine.h"

#include <algorithm>
#include <utility>

#include "absl/strings/str_cat.h"
#include "geodesic/rows/pairs.h"
#include "geodesic/valid_query.h"
#include "server/engine/rows/path_work.h"

namespace geodesic::server {
namespace {

// A reader may leave a table of columns standing for as long as it likes.
constexpr uint64_t kTablesInSolverMemory = 16;

// Few, since a reader may let those of a few rows wait; and more than one,
// since each row waits for a thread.
constexpr uint64_t kLinesPerRow = 64;

// Errors: RESOURCE_EXHAUSTED.
absl::Status CheckSize(const MatrixQuestion& question, const Limits& limits) {
  if (question.filter().nearest.has_value() ||
      question.columns() <= limits.max_matrix_values / question.rows()) {
    return absl::OkStatus();
  }
  return absl::ResourceExhaustedError(absl::StrCat(
      "the matrix has ", question.rows(), " rows of ", question.columns(),
      " values; max_matrix_values is ", limits.max_matrix_values));
}

uint64_t BytesOf(const std::vector<TracedLine>& lines) {
  uint64_t bytes = lines.capacity() * sizeof(TracedLine);
  for (const TracedLine& line : lines) {
    bytes += line.points.capacity() * sizeof(SurfacePoint) +
             line.positions.capacity() * sizeof(Point);
  }
  return bytes;
}

}  // namespace

RowEngine::RowEngine(const Limits& limits, Scheduler& scheduler, SoloJobs& jobs,
                     std::shared_ptr<ByteBudget> solver_memory,
                     MeshLibrary& meshes, SearchEngine& searches,
                     FieldEngine& fields)
    : limits_(limits),
      scheduler_(scheduler),
      jobs_(jobs),
      solver_memory_(std::move(solver_memory)),
      meshes_(meshes),
      searches_(searches),
      fields_(fields) {}

absl::StatusOr<MeshHandle> RowEngine::MeshOf(
    const std::string& digest, const std::optional<MethodHandle>& method) {
  absl::StatusOr<MeshHandle> mesh = meshes_.Get(digest, "mesh_digest");
  // A method knows the mesh that it was made of, not an equal one.
  if (mesh.ok() && method.has_value()) return method->mesh;
  return mesh;
}

std::shared_ptr<RowPipeline> RowEngine::MakeRows(const Requester& requester,
                                                 RowJobs plan, uint64_t rows,
                                                 RowFunction function,
                                                 std::function<void()> on_row) {
  plan.client = requester.client;
  plan.account = requester.account;
  // What takes one job is answered at once, like any question.
  plan.priority = rows == 1 ? SolvePriority(requester.is_batch)
                            : RowPriority(requester.is_batch);
  return std::make_shared<RowPipeline>(jobs_, scheduler_, std::move(plan), rows,
                                       std::move(function), std::move(on_row));
}

std::optional<ColumnTable> RowEngine::Transpose(
    MatrixQuestion& question) const {
  const uint64_t bytes =
      MatrixTable::PlannedBytes(question.rows(), question.columns());
  if (bytes > solver_memory_->capacity() / kTablesInSolverMemory ||
      !question.TransposingPays()) {
    return std::nullopt;
  }
  absl::StatusOr<ByteReservation> memory =
      ByteReservation::Make(solver_memory_, bytes);
  if (!memory.ok()) return std::nullopt;
  question.Transpose();
  return ColumnTable{*std::move(memory), MatrixTable(question)};
}

absl::StatusOr<MatrixCall> RowEngine::ComputeMatrix(
    MatrixRequest request, std::function<void()> on_row) {
  const absl::StatusOr<MeshHandle> mesh =
      MeshOf(request.mesh_digest, request.method);
  if (!mesh.ok()) return mesh.status();
  absl::StatusOr<ValidQuery> query =
      ValidQuery::Make(std::move(request.query), *(*mesh)->mesh);
  if (!query.ok()) return query.status();
  const auto means = std::make_shared<SearchMeans>(searches_, *mesh);
  absl::StatusOr<MatrixQuestion> made =
      MatrixQuestion::Make(*(*mesh)->mesh, *std::move(query), request.filter,
                           RowMethodOf(request.method), *means);
  if (!made.ok()) return made.status();
  absl::Status status = CheckSize(*made, limits_);
  if (status.ok()) status = CheckPrepared(request.method);
  if (!status.ok()) return status;
  std::optional<ColumnTable> table = Transpose(*made);
  const auto question =
      std::make_shared<const MatrixQuestion>(*std::move(made));
  MatrixCall call{.mesh = *mesh,
                  .row_count = question->rows(),
                  .column_count = question->columns(),
                  .algorithm = question->algorithm()};
  if (request.method.has_value()) call.algorithm = request.method->choice;
  if (!table.has_value()) {
    call.first_row = std::min(request.received_values / call.column_count,
                              call.row_count - 1);
  }
  const auto rows = MakeRows(
      request.requester,
      {.deadline = request.deadline,
       .first_row = call.first_row,
       .planned_bytes = question->PlannedBytes(),
       .row_bytes = question->LineBytes()},
      question->lines(),
      [means, question](uint64_t line, Checkpoint& checkpoint,
                        ByteReservation memory) {
        return Charge(question->Answer(line, checkpoint), std::move(memory));
      },
      std::move(on_row));
  call.rows = std::make_shared<MatrixRows>(rows, std::move(table));
  if (status = rows->Start(); !status.ok()) return status;
  return call;
}

absl::StatusOr<PairCall> RowEngine::ComputePairs(PairRequest request,
                                                 std::function<void()> on_row) {
  const absl::StatusOr<MeshHandle> mesh =
      MeshOf(request.mesh_digest, request.method);
  if (!mesh.ok()) return mesh.status();
  const auto work =
      std::make_shared<PairWork>(searches_, fields_, pair_totals_, *mesh);
  const absl::StatusOr<std::shared_ptr<const PairQuestion>> made =
      PairQuestion::Make(*(*mesh)->mesh, std::move(request.pairs),
                         {.paths = request.paths,
                          .tolerance = request.tolerance,
                          .method = RowMethodOf(request.method)},
                         *work, limits_.max_concurrent_jobs);
  if (!made.ok()) return made.status();
  absl::Status status = CheckPrepared(request.method);
  if (!status.ok()) return status;
  const PairQuestion& question = **made;
  PairCall call{.mesh = *mesh,
                .algorithm = question.algorithm(),
                .pair_count = question.pair_count(),
                .work = work};
  if (request.method.has_value()) call.algorithm = request.method->choice;
  call.rows = MakeRows(
      request.requester,
      {.deadline = request.deadline,
       .planned_bytes = question.PlannedBytes(),
       .row_bytes = question.RowBytes()},
      question.rows().size(),
      [work, question = *made](uint64_t row, Checkpoint& checkpoint,
                               ByteReservation memory) {
        return Charge(question->Answer(row, checkpoint), std::move(memory));
      },
      std::move(on_row));
  if (status = call.rows->Start(); !status.ok()) return status;
  return call;
}

absl::StatusOr<LineCall> RowEngine::TraceLines(LineRequest request,
                                               std::function<void()> on_row) {
  absl::StatusOr<MeshHandle> mesh = MeshOf(request.mesh_digest, std::nullopt);
  if (!mesh.ok()) return mesh.status();
  const absl::StatusOr<uint64_t> count = CountLines(request.lines);
  if (!count.ok()) return count.status();
  LineCall call{.mesh = *std::move(mesh), .line_count = *count};
  call.rows = MakeRows(
      request.requester, {.deadline = request.deadline},
      (call.line_count + kLinesPerRow - 1) / kLinesPerRow,
      [mesh = call.mesh, lines = std::move(request.lines), count = *count](
          uint64_t row, Checkpoint& checkpoint,
          ByteReservation memory) -> absl::StatusOr<AnswerRow> {
        AnswerRow result{.memory = std::move(memory)};
        const uint64_t begin = row * kLinesPerRow;
        const uint64_t end = std::min(begin + kLinesPerRow, count);
        absl::Status status = geodesic::TraceLines(
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

absl::StatusOr<std::shared_ptr<RowPipeline>> RowEngine::TracePaths(
    const FieldCall& call, const FieldAnswer& answer, TimePoint deadline,
    const Requester& requester, std::function<void()> on_row) {
  const auto work = std::make_shared<PathWork>(call, answer);
  auto rows = MakeRows(
      requester, {.is_continuation = true, .deadline = deadline}, work->rows(),
      [work](uint64_t row, Checkpoint& checkpoint, ByteReservation memory) {
        return work->Answer(row, checkpoint, std::move(memory));
      },
      std::move(on_row));
  if (absl::Status status = rows->Start(); !status.ok()) return status;
  return rows;
}

}  // namespace geodesic::server
