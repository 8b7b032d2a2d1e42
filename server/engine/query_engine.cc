#include "server/engine/query_engine.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "geodesic/field_path.h"
#include "server/engine/base/argument_checks.h"

namespace geodesic::server {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Bounds the index: each field on disk takes some memory.
constexpr size_t kMaxFields = 100'000;

// Keeps what lies within the radius, with its columns.
void MakeSparse(double radius, MatrixRow& row) {
  size_t kept = 0;
  for (size_t column = 0; column < row.values.size(); ++column) {
    const double value = row.values[column];
    if (value > radius || value == kInfinity) continue;
    row.columns.push_back(static_cast<uint32_t>(column));
    row.values[kept++] = value;
  }
  row.values.resize(kept);
}

// Keeps the `count` least values of a sparse row, in order.
void KeepNearest(uint64_t count, MatrixRow& row) {
  std::vector<uint32_t> order(row.values.size());
  std::iota(order.begin(), order.end(), 0);
  const size_t kept = std::min<uint64_t>(count, order.size());
  std::ranges::partial_sort(
      order, order.begin() + static_cast<std::ptrdiff_t>(kept), {},
      [&](uint32_t i) { return std::pair(row.values[i], row.columns[i]); });
  order.resize(kept);
  std::vector<uint32_t> columns;
  std::vector<double> values;
  for (const uint32_t i : order) {
    columns.push_back(row.columns[i]);
    values.push_back(row.values[i]);
  }
  row.columns = std::move(columns);
  row.values = std::move(values);
}

// Checks everything but the query, which was checked as `query`, including the
// matrix's size. Errors: INVALID_ARGUMENT, RESOURCE_EXHAUSTED.
absl::Status CheckMatrix(const MatrixRequest& request, const ValidQuery& query,
                         const Mesh& mesh, const Limits& limits) {
  absl::Status status = CheckRadius("radius", request.radius);
  if (!status.ok()) return status;
  const uint64_t rows = query->sources.size();
  const bool has_targets = !query->targets.empty();
  if (request.method.has_value()) {
    status = CheckPlaces(request.method->choice.method, *query);
    if (!status.ok()) return status;
  }
  if (request.nearest.has_value()) {
    if (!has_targets) {
      return InvalidField("targets", "targets is empty: name at least one");
    }
    if (*request.nearest == 0) {
      return InvalidField("count", "count is 0; it must be at least 1");
    }
    return absl::OkStatus();
  }
  const uint64_t columns =
      has_targets ? query->targets.size() : mesh.vertex_count();
  if (columns > limits.max_matrix_values / rows) {
    return absl::ResourceExhaustedError(absl::StrCat(
        "the matrix has ", rows, " rows of ", columns,
        " values; max_matrix_values is ", limits.max_matrix_values));
  }
  return absl::OkStatus();
}

// The most memory that a row takes while it is computed.
uint64_t RowBytes(const Query& query, const Mesh& mesh) {
  return (mesh.vertex_count() + query.targets.size()) *
         (sizeof(double) + sizeof(uint32_t) +
          (query.tolerance > 0 ? sizeof(float) : 0));
}

// What searches for the targets have, if they cost less than a field that stops
// when the first `wanted` of them are final. The targets lie anywhere: such a
// field covers as large a part of a whole one as they are of all.
std::optional<SearchMeans> ForRow(const ValidQuery& query, uint64_t wanted,
                                  double radius, const MeshHandle& mesh,
                                  SearchEngine& searches) {
  const uint64_t targets = query->targets.size();
  if (!TargetSearch::IsDirected(query->algorithm) || wanted == 0 ||
      targets >= FieldInSearches(Landmarks::kMost) || !std::isinf(radius)) {
    return {};
  }
  SearchMeans means = searches.MeansFor(mesh, query->algorithm);
  if (targets * targets >= wanted * means.field_in_searches) return {};
  return means;
}

// The distances of the targets, which are vertices, or without targets of all
// vertices.
absl::StatusOr<std::vector<double>> ApproximateRow(const MethodHandle& method,
                                                   const ValidQuery& query,
                                                   Checkpoint& checkpoint) {
  absl::StatusOr<ApproximateField> field =
      method.method->Distances(query.DistancesAlone(), checkpoint);
  if (!field.ok()) return field.status();
  if (query->targets.empty()) return std::move(field->distances);
  std::vector<double> values;
  values.reserve(query->targets.size());
  for (const SurfacePoint& target : query->targets) {
    values.push_back(field->distances[std::get<VertexPoint>(target).vertex]);
  }
  return values;
}

// The function that computes the rows of a checked request. It shrinks a row's
// memory to what the row keeps. REQUIRES: it is given RowBytes.
RowFunction MakeRowFunction(MeshHandle mesh, ValidQuery query,
                            const MatrixRequest& request,
                            const SolveOptions& options, StartFunction start,
                            SearchEngine& searches) {
  return [mesh = std::move(mesh), query = std::move(query),
          method = request.method, radius = request.radius,
          sparse = request.sparse, nearest = request.nearest, options,
          start = std::move(start),
          &searches](uint64_t row, Checkpoint& checkpoint,
                     ByteReservation memory) -> absl::StatusOr<MatrixRow> {
    const uint64_t targets = query->targets.size();
    const uint64_t wanted = std::min(nearest.value_or(targets), targets);
    MatrixRow result{.memory = std::move(memory)};
    const ValidQuery of_row =
        query.OfSource(static_cast<uint32_t>(row), *mesh->mesh);
    if (method.has_value()) {
      absl::StatusOr<std::vector<double>> values =
          ApproximateRow(*method, of_row, checkpoint);
      if (!values.ok()) return values.status();
      result.values = *std::move(values);
    } else if (const auto means =
                   ForRow(of_row, wanted, radius, mesh, searches)) {
      absl::StatusOr<TargetDistances> found =
          searches.Run(mesh, of_row, *means, checkpoint);
      if (!found.ok()) return found.status();
      result.certified_error = found->certified_error;
      result.values = std::move(found->distances);
    } else {
      auto computation = start(*mesh->mesh, of_row, options);
      if (!computation.ok()) return computation.status();
      Reach reach{.radius = radius};
      if (targets > 0) reach.targets = wanted;
      absl::Status status = (*computation)->Advance(reach, checkpoint);
      if (!status.ok()) return status;
      DistanceField field = (*computation)->Field();
      result.certified_error = field.certified_error;
      result.values = targets > 0 ? std::move(field.target_distances)
                                  : std::move(field.distances);
    }
    if (sparse || nearest.has_value()) {
      MakeSparse(radius, result);
      if (nearest.has_value()) KeepNearest(*nearest, result);
    } else if (!std::isinf(radius)) {
      for (double& value : result.values) {
        if (value > radius) value = kInfinity;
      }
    }
    result.columns.shrink_to_fit();
    result.values.shrink_to_fit();
    result.memory.ShrinkTo(result.values.size() * sizeof(double) +
                           result.columns.size() * sizeof(uint32_t));
    return result;
  };
}

}  // namespace

absl::StatusOr<std::unique_ptr<DurableStore>> DurableStore::Open(
    const Options& options) {
  absl::StatusOr<DataFolder> folder = DataFolder::Open(options.path);
  if (!folder.ok()) return folder.status();
  std::unique_ptr<DurableStore> store(
      new DurableStore{.folder = *std::move(folder)});
  auto meshes =
      MeshFiles::Open(store->folder, options.mesh_bytes, options.warn);
  if (!meshes.ok()) return meshes.status();
  store->meshes = *std::move(meshes);
  auto fields = BlobStore::Open(store->folder, {.kind = "field",
                                                .capacity = options.field_bytes,
                                                .max_count = kMaxFields,
                                                .warn = options.warn});
  if (!fields.ok()) return fields.status();
  store->fields = *std::move(fields);
  return store;
}

QueryEngine::QueryEngine(const Limits& limits, const Clock& clock,
                         Executor& executor, StartFunction start)
    : limits_(limits),
      start_(std::move(start)),
      upload_memory_(std::make_shared<ByteBudget>("upload memory",
                                                  limits.upload_memory_bytes)),
      solver_memory_(std::make_shared<ByteBudget>("solver memory",
                                                  limits.solver_memory_bytes)),
      meshes_(limits_, clock, scheduler_, upload_memory_,
              [this](const std::string& digest) {
                fields_.EraseMesh(digest);
                searches_.landmarks().EraseMesh(digest);
                methods_.EraseMesh(digest);
              }),
      searches_(limits_, solve_options_, clock, scheduler_, solver_memory_,
                start_, meshes_),
      methods_(limits_, clock, scheduler_, solver_memory_, meshes_,
               searches_.landmarks()),
      decimations_(limits_, clock, scheduler_, solver_memory_, meshes_),
      fields_(limits_, solve_options_, clock, scheduler_, solver_memory_,
              start_, meshes_, searches_),
      solo_jobs_(clock, scheduler_, solver_memory_, limits.progress_interval),
      pairs_(limits_, solve_options_, scheduler_, solo_jobs_, start_, meshes_,
             searches_, fields_),
      scheduler_(executor, limits.max_concurrent_jobs, limits.max_queued_jobs,
                 limits.max_queued_jobs_per_client) {}

QueryEngine::~QueryEngine() { scheduler_.StopAll(); }

void QueryEngine::Attach(std::unique_ptr<DurableStore> durable,
                         const std::string& version, Blobs* shared) {
  durable_ = std::move(durable);
  if (durable_ != nullptr) meshes_.Attach(*durable_->meshes);
  kept_.emplace(durable_ != nullptr ? durable_->fields.get() : nullptr, shared,
                version);
  fields_.Attach(kept_->fields);
  searches_.landmarks().Attach(kept_->landmarks);
  methods_.Attach(kept_->graphs);
}

absl::StatusOr<QuestionCall> QueryEngine::StartQuestion(
    QuestionRequest request) {
  absl::StatusOr<MeshHandle> mesh =
      meshes_.Get(request.mesh_digest, "mesh_digest");
  if (!mesh.ok()) return mesh.status();
  absl::StatusOr<ValidQuery> query =
      ValidQuery::Make(std::move(request.query), *(*mesh)->mesh);
  if (!query.ok()) return query.status();
  absl::StatusOr<ByteReservation> memory =
      ByteReservation::Make(solver_memory_, 0);
  if (!memory.ok()) return memory.status();
  QuestionCall call{
      .mesh = *std::move(mesh),
      .algorithm = (*query)->algorithm,
      .tolerance = (*query)->tolerance,
      .answer_memory = std::make_shared<ByteReservation>(*std::move(memory))};
  SoloJob solo{.priority = SolvePriority(request.requester.is_batch),
               .client = request.requester.client,
               .deadline = request.deadline,
               .planned_bytes = PlannedSolverBytes(*call.mesh->mesh, *query),
               .done = std::move(request.done),
               .progress = std::move(request.progress)};
  // The size of the answer is only known when the work is done.
  solo.work = [this, mesh = call.mesh, memory = call.answer_memory,
               query = *std::move(query), work = std::move(request.work)](
                  Checkpoint& checkpoint, ByteReservation) mutable {
    return work(*mesh->mesh, query,
                WithIdleThreads(solve_options_, scheduler_,
                                limits_.max_threads_per_solve),
                checkpoint, *memory);
  };
  absl::StatusOr<SoloJobs::Call> job = solo_jobs_.Start(std::move(solo));
  if (!job.ok()) return job.status();
  call.job = *std::move(job);
  return call;
}

absl::StatusOr<MatrixCall> QueryEngine::ComputeMatrix(
    MatrixRequest request, std::function<void()> on_row) {
  absl::StatusOr<MeshHandle> mesh =
      meshes_.Get(request.mesh_digest, "mesh_digest");
  if (!mesh.ok()) return mesh.status();
  absl::StatusOr<ValidQuery> valid =
      ValidQuery::Make(std::move(request.query), *(*mesh)->mesh);
  if (!valid.ok()) return valid.status();
  // A method knows the mesh that it was made of, not an equal one.
  if (request.method.has_value()) *mesh = request.method->mesh;
  const ValidQuery& query = *valid;
  absl::Status status = CheckMatrix(request, query, *(*mesh)->mesh, limits_);
  if (!status.ok()) return status;
  status = CheckPrepared(request.method);
  if (!status.ok()) return status;
  const uint64_t rows = query->sources.size();
  MatrixCall call{.mesh = *std::move(mesh), .row_count = rows};
  if (request.method.has_value()) {
    call.algorithm = request.method->choice;
  } else {
    call.algorithm = query.OfSource(0, *call.mesh->mesh)->algorithm;
  }
  call.column_count = query->targets.empty() ? call.mesh->mesh->vertex_count()
                                             : query->targets.size();
  RowJobs plan{.client = request.requester.client,
               .priority = RowPriority(request.requester.is_batch),
               .deadline = request.deadline,
               .planned_bytes = std::max(
                   PlannedSolverBytes(*call.mesh->mesh, query),
                   SearchEngine::PlannedBytes(*call.mesh->mesh, query)),
               .row_bytes = RowBytes(*query, *call.mesh->mesh)};
  call.rows = std::make_shared<RowPipeline>(
      solo_jobs_, scheduler_, std::move(plan), rows,
      MakeRowFunction(call.mesh, query, request, solve_options_, start_,
                      searches_),
      std::move(on_row));
  if (status = call.rows->Start(); !status.ok()) return status;
  return call;
}

EngineCounters QueryEngine::counters() const {
  return {fields_.counters(), meshes_.meshes_built(), meshes_.meshes_loaded(),
          meshes_.meshes_fetched(), pairs_.counts()};
}

}  // namespace geodesic::server
