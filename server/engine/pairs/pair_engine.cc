#include "server/engine/pairs/pair_engine.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "absl/strings/str_cat.h"
#include "geodesic/field_path.h"

namespace geodesic::server {
namespace {

constexpr size_t kSearchesPerRow = 32;

// Few searches are spread over the threads, and the faster of these take more.
constexpr size_t kRowsPerThread = 4;

// Landmarks cost some 200 searches, and save more than half of each.
constexpr size_t kSearchesWorthLandmarks = 1000;

size_t SearchCount(const std::vector<PairRow>& rows) {
  size_t count = 0;
  for (const PairRow& row : rows) {
    if (!row.shared.has_value()) count += row.pairs.size();
  }
  return count;
}

// Checks the point and makes it canonical. `end` is its name in the pair.
absl::Status MakeCanonical(const Mesh& mesh, size_t pair, const char* end,
                           SurfacePoint& point) {
  // Paths are only made for what is wrong.
  if (!Validate(point, mesh, "").ok()) {
    return Validate(point, mesh, absl::StrCat("pairs[", pair, "].", end));
  }
  point = Canonicalize(point, mesh);
  return absl::OkStatus();
}

absl::Status MakeCanonical(const Mesh& mesh, std::vector<PointPair>& pairs) {
  if (pairs.empty()) {
    return InvalidField("pairs", "pairs is empty: name at least one");
  }
  for (size_t i = 0; i < pairs.size(); ++i) {
    absl::Status status = MakeCanonical(mesh, i, "source", pairs[i].source);
    if (!status.ok()) return status;
    status = MakeCanonical(mesh, i, "target", pairs[i].target);
    if (!status.ok()) return status;
  }
  return absl::OkStatus();
}

}  // namespace

PairEngine::PairEngine(const Limits& limits, const SolveOptions& options,
                       Scheduler& scheduler, SoloJobs& jobs,
                       const StartFunction& start, MeshLibrary& meshes,
                       SearchEngine& searches, FieldEngine& fields)
    : limits_(limits),
      options_(options),
      scheduler_(scheduler),
      jobs_(jobs),
      start_(start),
      meshes_(meshes),
      searches_(searches),
      fields_(fields) {}

absl::StatusOr<PairCall> PairEngine::Compute(PairRequest request,
                                             std::function<void()> on_row) {
  absl::StatusOr<MeshHandle> resident =
      meshes_.Get(request.mesh_digest, "mesh_digest");
  if (!resident.ok()) return resident.status();
  const MeshHandle& mesh = *resident;
  absl::Status status = MakeCanonical(*mesh->mesh, request.pairs);
  if (!status.ok()) return status;
  PairCall call{
      .mesh = mesh,
      .algorithm =
          DistanceQuery(request.pairs[0].source, {}, *mesh->mesh)->algorithm,
      .pair_count = request.pairs.size()};
  const std::shared_ptr<PairWork> work(
      new PairWork{.start = start_,
                   .options = options_,
                   .fields = fields_,
                   .searches = searches_,
                   .totals = totals_,
                   .mesh = mesh,
                   .algorithm = call.algorithm,
                   .pairs = std::move(request.pairs),
                   .paths = request.paths});
  const SearchMeans means = searches_.MeansFor(mesh, call.algorithm);
  work->rows = PlanPairs(
      work->pairs,
      {.least_for_field = request.paths ? std::numeric_limits<size_t>::max()
                                        : means.field_in_searches,
       .searches_per_row = std::clamp<size_t>(
           call.pair_count / (kRowsPerThread * limits_.max_concurrent_jobs), 1,
           kSearchesPerRow)});
  work->wants_landmarks = call.algorithm == kDefaultAlgorithm &&
                          SearchCount(work->rows) >= kSearchesWorthLandmarks;
  call.work = work;
  call.row_count = work->rows.size();
  const bool is_batch = request.requester.is_batch;
  RowJobs plan{.client = request.requester.client,
               // What takes one job is answered at once, like any question.
               .priority = call.row_count == 1 ? SolvePriority(is_batch)
                                               : RowPriority(is_batch),
               .deadline = request.deadline,
               .planned_bytes = work->PlannedBytes(),
               .row_bytes = work->RowBytes()};
  // One more than can run, so no thread waits for the reader to take a row.
  call.rows = std::make_shared<RowPipeline>(
      jobs_, std::move(plan), call.row_count, limits_.max_concurrent_jobs + 1,
      [work](uint64_t row, Checkpoint& checkpoint, ByteReservation memory) {
        return work->Answer(row, checkpoint, std::move(memory));
      },
      std::move(on_row));
  absl::StatusOr<Scheduler::Place> place =
      scheduler_.HoldPlace(request.requester.client);
  if (!place.ok()) return place.status();
  if (status = call.rows->Start(*std::move(place)); !status.ok()) return status;
  return call;
}

}  // namespace geodesic::server
