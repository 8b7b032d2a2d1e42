#include "server/engine/pairs/pair_engine.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "absl/strings/str_cat.h"
#include "geodesic_types/field_path.h"

namespace geodesic::server {
namespace {

constexpr size_t kSearchesPerRow = 32;
// Each row makes its own search of a graph, which takes some of them in time.
constexpr size_t kGraphSearchesPerRow = 1024;

// Few searches are spread over the threads, and the faster of these take more.
constexpr size_t kRowsPerThread = 4;

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

// Errors: INVALID_ARGUMENT naming what no approximate method does.
absl::Status CheckApproximate(const PairRequest& request) {
  const ApproximateMethod method = request.method->choice.method;
  if (request.paths) {
    return InvalidField(
        "paths",
        absl::StrCat("paths: ", std::string(ApproximateMethodName(method)),
                     " is approximate and finds distances alone; ask "
                     "an exact algorithm for paths"));
  }
  for (size_t i = 0; i < request.pairs.size(); ++i) {
    for (const auto& [end, point] :
         {std::pair("source", request.pairs[i].source),
          std::pair("target", request.pairs[i].target)}) {
      if (std::holds_alternative<VertexPoint>(point)) continue;
      return NoVertex(method, absl::StrCat("pairs[", i, "].", end));
    }
  }
  return absl::OkStatus();
}

// How pairs are planned: what searches is cheap beside a field.
PairCosts CostsOf(const PairRequest& request, size_t field_in_searches) {
  if (request.paths) {
    return {.least_for_field = std::numeric_limits<size_t>::max()};
  }
  if (!request.method.has_value()) {
    return {.least_for_field = field_in_searches};
  }
  switch (request.method->choice.method) {
    case ApproximateMethod::kSvg:
    case ApproximateMethod::kGtu:
      return {.least_for_field = std::numeric_limits<size_t>::max()};
    default:
      return {.least_for_field = 1};
  }
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
  // A method knows the mesh that it was made of, not an equal one.
  const MeshHandle mesh =
      request.method.has_value() ? request.method->mesh : *resident;
  absl::Status status = MakeCanonical(*mesh->mesh, request.pairs);
  if (status.ok() && request.method.has_value()) {
    status = CheckApproximate(request);
  }
  if (!status.ok()) return status;
  const absl::StatusOr<ValidQuery> first = ValidQuery::Make(
      {.sources = {{request.pairs[0].source}}, .tolerance = request.tolerance},
      *mesh->mesh);
  if (!first.ok()) return first.status();
  status = CheckPrepared(request.method);
  if (!status.ok()) return status;
  const Algorithm algorithm = (*first)->algorithm;
  PairCall call{
      .mesh = mesh, .algorithm = algorithm, .pair_count = request.pairs.size()};
  if (request.method.has_value()) call.algorithm = request.method->choice;
  const std::shared_ptr<PairWork> work(
      new PairWork{.start = start_,
                   .options = options_,
                   .fields = fields_,
                   .searches = searches_,
                   .totals = totals_,
                   .mesh = mesh,
                   .algorithm = algorithm,
                   .method = request.method,
                   .pairs = std::move(request.pairs),
                   .paths = request.paths,
                   .tolerance = request.tolerance});
  const SearchMeans means = searches_.MeansFor(mesh, algorithm);
  PairCosts costs = CostsOf(request, means.field_in_searches);
  costs.searches_per_row = std::clamp<size_t>(
      call.pair_count / (kRowsPerThread * limits_.max_concurrent_jobs), 1,
      request.method.has_value() ? kGraphSearchesPerRow : kSearchesPerRow);
  work->rows = PlanPairs(work->pairs, costs);
  if (TargetSearch::IsDirected(algorithm) && !request.method.has_value()) {
    work->landmarks = LandmarksWorth(SearchCount(work->rows));
  }
  call.work = work;
  const bool is_batch = request.requester.is_batch;
  RowJobs plan{.client = request.requester.client,
               .account = std::move(request.requester.account),
               // What takes one job is answered at once, like any question.
               .priority = work->rows.size() == 1 ? SolvePriority(is_batch)
                                                  : RowPriority(is_batch),
               .deadline = request.deadline,
               .planned_bytes = work->PlannedBytes(),
               .row_bytes = work->RowBytes()};
  call.rows = std::make_shared<RowPipeline>(
      jobs_, scheduler_, std::move(plan), work->rows.size(),
      [work](uint64_t row, Checkpoint& checkpoint, ByteReservation memory) {
        return work->Answer(row, checkpoint, std::move(memory));
      },
      std::move(on_row));
  if (status = call.rows->Start(); !status.ok()) return status;
  return call;
}

}  // namespace geodesic::server
