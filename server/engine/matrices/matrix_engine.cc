#include "server/engine/matrices/matrix_engine.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "geodesic/valid_query.h"
#include "geodesic_types/field_path.h"
#include "server/engine/base/argument_checks.h"

namespace geodesic::server {
namespace {

// A reader may leave a table of columns standing for as long as it likes.
constexpr uint64_t kTablesInSolverMemory = 16;

// Checks everything but the query, which was checked before, including the
// matrix's size. Errors: INVALID_ARGUMENT, RESOURCE_EXHAUSTED.
absl::Status Check(const MatrixWork& work, const Limits& limits) {
  absl::Status status = CheckRadius("radius", work.filter.radius);
  if (!status.ok()) return status;
  if (work.method.has_value()) {
    status = CheckPlaces(work.method->choice.method, *work.query);
    if (!status.ok()) return status;
  }
  if (work.filter.nearest.has_value()) {
    if (work.query->targets.empty()) {
      return InvalidField("targets", "targets is empty: name at least one");
    }
    if (*work.filter.nearest == 0) {
      return InvalidField("count", "count is 0; it must be at least 1");
    }
  } else if (work.columns() > limits.max_matrix_values / work.rows()) {
    return absl::ResourceExhaustedError(absl::StrCat(
        "the matrix has ", work.rows(), " rows of ", work.columns(),
        " values; max_matrix_values is ", limits.max_matrix_values));
  }
  return CheckPrepared(work.method);
}

}  // namespace

MatrixEngine::MatrixEngine(const Limits& limits, const SolveOptions& options,
                           Scheduler& scheduler, SoloJobs& jobs,
                           const StartFunction& start,
                           std::shared_ptr<ByteBudget> solver_memory,
                           MeshLibrary& meshes, SearchEngine& searches)
    : limits_(limits),
      options_(options),
      scheduler_(scheduler),
      jobs_(jobs),
      start_(start),
      solver_memory_(std::move(solver_memory)),
      meshes_(meshes),
      searches_(searches) {}

std::optional<ColumnTable> MatrixEngine::Transpose(MatrixWork& work) const {
  const uint64_t rows = work.rows();
  const uint64_t columns = work.columns();
  const uint64_t bytes = ColumnTable::PlannedBytes(rows, columns);
  if (!work.TransposingPays() ||
      bytes > solver_memory_->capacity() / kTablesInSolverMemory) {
    return std::nullopt;
  }
  absl::StatusOr<ByteReservation> memory =
      ByteReservation::Make(solver_memory_, bytes);
  if (!memory.ok()) return std::nullopt;
  std::vector<double> offsets;
  offsets.reserve(rows);
  for (const Source& source : work.query->sources) {
    offsets.push_back(source.offset);
  }
  work.query = work.query.Transposed(*work.mesh->mesh);
  RowFilter of_rows =
      std::exchange(work.filter, {.radius = work.filter.radius});
  return ColumnTable(std::move(offsets), columns, of_rows, *std::move(memory));
}

absl::StatusOr<MatrixCall> MatrixEngine::Compute(MatrixRequest request,
                                                 std::function<void()> on_row) {
  absl::StatusOr<MeshHandle> mesh =
      meshes_.Get(request.mesh_digest, "mesh_digest");
  if (!mesh.ok()) return mesh.status();
  absl::StatusOr<ValidQuery> query =
      ValidQuery::Make(std::move(request.query), *(*mesh)->mesh);
  if (!query.ok()) return query.status();
  // A method knows the mesh that it was made of, not an equal one.
  if (request.method.has_value()) *mesh = request.method->mesh;
  const auto work = std::make_shared<MatrixWork>(
      MatrixWork{.start = start_,
                 .options = options_,
                 .searches = searches_,
                 .mesh = *std::move(mesh),
                 .query = *std::move(query),
                 .method = std::move(request.method),
                 .filter = request.filter});
  absl::Status status = Check(*work, limits_);
  if (!status.ok()) return status;
  MatrixCall call{.mesh = work->mesh,
                  .row_count = work->rows(),
                  .column_count = work->columns()};
  std::optional<ColumnTable> table = Transpose(*work);
  if (work->method.has_value()) {
    call.algorithm = work->method->choice;
  } else {
    call.algorithm = work->query.OfSource(0, *work->mesh->mesh)->algorithm;
  }
  if (!table.has_value()) {
    call.first_row = std::min(request.received_values / call.column_count,
                              call.row_count - 1);
  }
  RowJobs plan{.client = request.requester.client,
               .account = std::move(request.requester.account),
               .priority = RowPriority(request.requester.is_batch),
               .deadline = request.deadline,
               .first_row = call.first_row,
               .planned_bytes = work->PlannedBytes(),
               .row_bytes = work->RowBytes()};
  const auto pipeline = std::make_shared<RowPipeline>(
      jobs_, scheduler_, std::move(plan), work->rows(),
      [work](uint64_t row, Checkpoint& checkpoint, ByteReservation memory) {
        return work->Answer(row, checkpoint, std::move(memory));
      },
      std::move(on_row));
  call.rows = std::make_shared<MatrixRows>(pipeline, std::move(table));
  if (status = pipeline->Start(); !status.ok()) return status;
  return call;
}

}  // namespace geodesic::server
