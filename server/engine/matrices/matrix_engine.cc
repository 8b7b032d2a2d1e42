#include "server/engine/matrices/matrix_engine.h"

#include <algorithm>
#include <utility>

#include "absl/strings/str_cat.h"
#include "geodesic/valid_query.h"

namespace geodesic::server {
namespace {

// A reader may leave a table of columns standing for as long as it likes.
constexpr uint64_t kTablesInSolverMemory = 16;

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

}  // namespace

MatrixEngine::MatrixEngine(const Limits& limits, Scheduler& scheduler,
                           SoloJobs& jobs,
                           std::shared_ptr<ByteBudget> solver_memory,
                           MeshLibrary& meshes, SearchEngine& searches)
    : limits_(limits),
      scheduler_(scheduler),
      jobs_(jobs),
      solver_memory_(std::move(solver_memory)),
      meshes_(meshes),
      searches_(searches) {}

std::optional<ColumnTable> MatrixEngine::Transpose(
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

absl::StatusOr<MatrixCall> MatrixEngine::Compute(MatrixRequest request,
                                                 std::function<void()> on_row) {
  absl::StatusOr<MeshHandle> resident =
      meshes_.Get(request.mesh_digest, "mesh_digest");
  if (!resident.ok()) return resident.status();
  // A method knows the mesh that it was made of, not an equal one.
  const MeshHandle mesh =
      request.method.has_value() ? request.method->mesh : *resident;
  absl::StatusOr<ValidQuery> query =
      ValidQuery::Make(std::move(request.query), *mesh->mesh);
  if (!query.ok()) return query.status();
  const auto means = std::make_shared<SearchMeans>(searches_, mesh);
  absl::StatusOr<MatrixQuestion> made =
      MatrixQuestion::Make(*mesh->mesh, *std::move(query), request.filter,
                           RowMethodOf(request.method), *means);
  if (!made.ok()) return made.status();
  absl::Status status = CheckSize(*made, limits_);
  if (status.ok()) status = CheckPrepared(request.method);
  if (!status.ok()) return status;
  std::optional<ColumnTable> table = Transpose(*made);
  const auto question =
      std::make_shared<const MatrixQuestion>(*std::move(made));
  MatrixCall call{.mesh = mesh,
                  .row_count = question->rows(),
                  .column_count = question->columns(),
                  .algorithm = question->algorithm()};
  if (request.method.has_value()) call.algorithm = request.method->choice;
  if (!table.has_value()) {
    call.first_row = std::min(request.received_values / call.column_count,
                              call.row_count - 1);
  }
  RowJobs plan{.client = request.requester.client,
               .account = std::move(request.requester.account),
               .priority = RowPriority(request.requester.is_batch),
               .deadline = request.deadline,
               .first_row = call.first_row,
               .planned_bytes = question->PlannedBytes(),
               .row_bytes = question->LineBytes()};
  const auto pipeline = std::make_shared<RowPipeline>(
      jobs_, scheduler_, std::move(plan), question->lines(),
      [means, question](uint64_t line, Checkpoint& checkpoint,
                        ByteReservation memory) {
        return Charge(question->Answer(line, checkpoint), std::move(memory));
      },
      std::move(on_row));
  call.rows = std::make_shared<MatrixRows>(pipeline, std::move(table));
  if (status = pipeline->Start(); !status.ok()) return status;
  return call;
}

}  // namespace geodesic::server
