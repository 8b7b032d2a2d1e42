#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <variant>

#include "absl/strings/str_cat.h"
#include "geodesic/approximate/saddle_vertex_graph.h"
#include "geodesic/approximate/triangle_unfolding.h"
#include "geodesic/computation.h"
#include "geodesic/rows/pairs.h"
#include "geodesic/target_search.h"
#include "geodesic_types/field_path.h"
#include "rows/pair_plan.h"

namespace geodesic {
namespace {

constexpr size_t kSearchesPerRow = 32;
// Each row makes its own search of a graph, which takes some of them in time.
constexpr size_t kGraphSearchesPerRow = 1024;

// Few searches are spread over the threads, and the faster of these take more.
constexpr size_t kRowsPerThread = 4;

// For each vertex.
constexpr uint64_t kMethodBytes = 8 * sizeof(double);

// Adds the windows of several searches up.
class SumOfSearches final : public Checkpoint {
 public:
  explicit SumOfSearches(Checkpoint& checkpoint) : checkpoint_(checkpoint) {}

  absl::Status Poll(const Progress& progress) override {
    latest_ = progress.windows_propagated;
    Progress sum = progress;
    sum.windows_propagated += before_;
    return checkpoint_.Poll(sum);
  }

  // The next search begins.
  void Next() { before_ += std::exchange(latest_, 0); }

 private:
  Checkpoint& checkpoint_;
  uint64_t before_ = 0;
  uint64_t latest_ = 0;
};

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

// Errors: INVALID_ARGUMENT naming what the method does not do.
absl::Status CheckMethod(ApproximateMethod method,
                         const std::vector<PointPair>& pairs, bool paths) {
  if (paths) {
    return InvalidField(
        "paths",
        absl::StrCat("paths: ", std::string(ApproximateMethodName(method)),
                     " is approximate and finds distances alone; ask "
                     "an exact algorithm for paths"));
  }
  for (size_t i = 0; i < pairs.size(); ++i) {
    for (const auto& [end, point] : {std::pair("source", pairs[i].source),
                                     std::pair("target", pairs[i].target)}) {
      if (std::holds_alternative<VertexPoint>(point)) continue;
      return NoVertex(method, absl::StrCat("pairs[", i, "].", end));
    }
  }
  return absl::OkStatus();
}

// From so many pairs on a field costs less than searches, which take
// `field_in_searches` where they are exact.
size_t LeastForField(const PairOptions& options, size_t field_in_searches) {
  constexpr size_t kNever = std::numeric_limits<size_t>::max();
  if (options.paths) return kNever;
  if (!options.method.has_value()) return field_in_searches;
  switch (options.method->method) {
    case ApproximateMethod::kSvg:
    case ApproximateMethod::kGtu:
      return kNever;
    default:
      return 1;
  }
}

size_t SearchCount(const std::vector<PairRow>& rows) {
  size_t count = 0;
  for (const PairRow& row : rows) {
    if (!row.shared.has_value()) count += row.pairs.size();
  }
  return count;
}

uint32_t VertexOf(const SurfacePoint& point) {
  return std::get<VertexPoint>(point).vertex;
}

// If the field is there and the target is a vertex.
std::optional<double> DistanceIn(const DistanceField* field,
                                 const SurfacePoint& target) {
  const auto* vertex = std::get_if<VertexPoint>(&target);
  if (field == nullptr || vertex == nullptr) return std::nullopt;
  return field->distances[vertex->vertex];
}

// From a whole field around either end that is there.
std::optional<double> KeptDistance(RowMeans& means, const PointPair& pair) {
  std::optional<double> kept =
      DistanceIn(means.FindWhole(pair.source).get(), pair.target);
  if (!kept) kept = DistanceIn(means.FindWhole(pair.target).get(), pair.source);
  return kept;
}

}  // namespace

absl::StatusOr<std::shared_ptr<const PairQuestion>> PairQuestion::Make(
    const Mesh& mesh, std::vector<PointPair> pairs, PairOptions options,
    RowMeans& means, size_t threads) {
  absl::Status status = MakeCanonical(mesh, pairs);
  if (status.ok() && options.method.has_value()) {
    status = CheckMethod(options.method->method, pairs, options.paths);
  }
  if (!status.ok()) return status;
  const absl::StatusOr<ValidQuery> first = ValidQuery::Make(
      {.sources = {{pairs[0].source}}, .tolerance = options.tolerance}, mesh);
  if (!first.ok()) return first.status();
  std::shared_ptr<PairQuestion> question(new PairQuestion(
      mesh, std::move(pairs), std::move(options), (*first)->algorithm, means));
  question->Plan(threads);
  return question;
}

PairQuestion::PairQuestion(const Mesh& mesh, std::vector<PointPair> pairs,
                           PairOptions options, Algorithm algorithm,
                           RowMeans& means)
    : mesh_(mesh),
      pairs_(std::move(pairs)),
      options_(std::move(options)),
      algorithm_(algorithm),
      means_(means) {}

void PairQuestion::Plan(size_t threads) {
  const bool is_exact = !options_.method.has_value();
  const size_t most_per_row = is_exact ? kSearchesPerRow : kGraphSearchesPerRow;
  rows_ = PlanPairs(
      pairs_,
      {.least_for_field = LeastForField(
           options_, FieldInSearches(algorithm_, means_.landmarks().get())),
       .searches_per_row = std::clamp<size_t>(
           pairs_.size() / (kRowsPerThread * threads), 1, most_per_row)});
  if (is_exact && TargetSearch::IsDirected(algorithm_)) {
    landmarks_ = LandmarksWorth(SearchCount(rows_));
  }
}

ValidQuery PairQuestion::QueryOf(const SurfacePoint& source,
                                 std::vector<SurfacePoint> targets) const {
  return *ValidQuery::Make({.sources = {{source}},
                            .targets = std::move(targets),
                            .trace = options_.paths,
                            .tolerance = options_.tolerance},
                           mesh_);
}

std::vector<SurfacePoint> PairQuestion::OtherEnds(const PairRow& row) const {
  std::vector<SurfacePoint> ends;
  ends.reserve(row.pairs.size());
  for (const uint32_t number : row.pairs) {
    const PointPair& pair = pairs_[number];
    ends.push_back(pair.source == *row.shared ? pair.target : pair.source);
  }
  return ends;
}

uint64_t PairQuestion::PlannedBytes() const {
  // A search of a graph, or a field and what it is computed from.
  if (options_.method.has_value()) return mesh_.vertex_count() * kMethodBytes;
  const ValidQuery query = QueryOf(pairs_[0].source, {pairs_[0].target});
  const bool has_field = std::ranges::any_of(
      rows_, [](const PairRow& row) { return row.shared.has_value(); });
  return std::max({TargetSearch::PlannedBytes(mesh_, query),
                   has_field ? PlannedSolverBytes(mesh_, query) : 0,
                   landmarks_ > 0 ? Landmarks::PlannedMakingBytes(mesh_) : 0});
}

uint64_t PairQuestion::RowBytes() const {
  size_t most = 0;
  for (const PairRow& row : rows_) most = std::max(most, row.pairs.size());
  // The other ends are the targets of a field.
  return most * (sizeof(double) + sizeof(uint32_t) + sizeof(SurfacePoint));
}

absl::StatusOr<DistanceRow> PairQuestion::Answer(uint64_t row,
                                                 Checkpoint& checkpoint) const {
  const PairRow& plan = rows_[row];
  DistanceRow result{.columns = plan.pairs};
  absl::Status status;
  if (options_.method.has_value()) {
    status = Approximate(plan, checkpoint, result.values);
  } else if (plan.shared.has_value()) {
    status = Solve(plan, checkpoint, result);
  } else {
    status = Search(plan, checkpoint, result);
  }
  if (!status.ok()) return status;
  return result;
}

absl::Status PairQuestion::PrepareSearches(Checkpoint& checkpoint) const {
  if (landmarks_ == 0 || makes_landmarks_.exchange(true)) {
    return absl::OkStatus();
  }
  const absl::StatusOr<bool> are_made =
      means_.MakeLandmarks(landmarks_, checkpoint);
  if (!are_made.ok()) return are_made.status();
  // A later row asks again.
  makes_landmarks_ = *are_made;
  return absl::OkStatus();
}

absl::Status PairQuestion::Search(const PairRow& row, Checkpoint& checkpoint,
                                  DistanceRow& result) const {
  absl::Status status = PrepareSearches(checkpoint);
  if (!status.ok()) return status;
  const bool is_directed = TargetSearch::IsDirected(algorithm_);
  const std::shared_ptr<const Landmarks> landmarks =
      is_directed ? means_.landmarks() : nullptr;
  result.values.resize(row.pairs.size());
  std::vector<size_t> open;  // of the row: what is not kept
  for (size_t i = 0; i < row.pairs.size(); ++i) {
    const auto kept = options_.paths
                          ? std::nullopt
                          : KeptDistance(means_, pairs_[row.pairs[i]]);
    if (kept) {
      result.values[i] = *kept;
      means_.Count(AnsweredBy::kKept, 1);
    } else {
      open.push_back(i);
    }
  }
  const auto search_all = [&](TargetSearch& search) -> absl::Status {
    SumOfSearches sum(checkpoint);
    for (const size_t i : open) {
      const PointPair& pair = pairs_[row.pairs[i]];
      sum.Next();
      absl::StatusOr<TargetDistances> found =
          search.Run(QueryOf(pair.source, {pair.target}), landmarks.get(), sum);
      if (!found.ok()) return found.status();
      result.values[i] = found->distances[0];
      result.certified_error =
          std::max(result.certified_error, found->certified_error);
      if (options_.paths) result.paths.push_back(std::move(found->paths[0]));
      means_.Count(AnsweredBy::kSearch, 1);
    }
    return absl::OkStatus();
  };
  if (!open.empty()) status = means_.WithSearch(search_all);
  if (status.ok() && is_directed) means_.WantLandmarks();
  return status;
}

absl::Status PairQuestion::Solve(const PairRow& row, Checkpoint& checkpoint,
                                 DistanceRow& result) const {
  std::vector<SurfacePoint> ends = OtherEnds(row);
  const size_t count = ends.size();
  const std::shared_ptr<const DistanceField> whole =
      means_.FindWhole(*row.shared);
  for (const SurfacePoint& end : ends) {
    const auto kept = DistanceIn(whole.get(), end);
    if (!kept) break;
    result.values.push_back(*kept);
  }
  if (result.values.size() == count) {
    means_.Count(AnsweredBy::kKept, count);
    return absl::OkStatus();
  }
  auto computation = means_.Start(QueryOf(*row.shared, std::move(ends)));
  if (!computation.ok()) return computation.status();
  absl::Status status = (*computation)->Advance({.targets = count}, checkpoint);
  if (!status.ok()) return status;
  DistanceField field = (*computation)->Field();
  result.values = std::move(field.target_distances);
  result.certified_error = field.certified_error;
  means_.Count(AnsweredBy::kField, count);
  return absl::OkStatus();
}

absl::Status PairQuestion::Approximate(const PairRow& row,
                                       Checkpoint& checkpoint,
                                       std::vector<double>& distances) const {
  const PreparedMethod& method = *options_.method->prepared;
  const size_t count = row.pairs.size();
  distances.reserve(count);
  if (row.shared.has_value()) {
    const absl::StatusOr<ApproximateField> field =
        method.Distances(QueryOf(*row.shared, {}), checkpoint);
    if (!field.ok()) return field.status();
    for (const SurfacePoint& end : OtherEnds(row)) {
      distances.push_back(field->distances[VertexOf(end)]);
    }
    means_.Count(AnsweredBy::kField, count);
    return absl::OkStatus();
  }
  const auto* graph = dynamic_cast<const SaddleVertexGraph*>(&method);
  const auto* unfolding = dynamic_cast<const TriangleUnfolding*>(&method);
  const std::shared_ptr<const Landmarks> landmarks =
      graph == nullptr ? nullptr : means_.landmarks();
  std::optional<SaddleGraphSearch> search;
  if (graph != nullptr) search.emplace(*graph);
  for (const uint32_t number : row.pairs) {
    const uint32_t from = VertexOf(pairs_[number].source);
    const uint32_t to = VertexOf(pairs_[number].target);
    const absl::StatusOr<double> distance =
        search ? search->Distance(from, to, landmarks.get(), checkpoint)
               : unfolding->Distance(from, to);
    if (!distance.ok()) return distance.status();
    distances.push_back(*distance);
    absl::Status status =
        checkpoint.Poll({.vertices = mesh_.vertex_count(),
                         .solver_bytes = search ? search->bytes() : 0});
    if (!status.ok()) return status;
  }
  if (graph != nullptr) means_.WantLandmarks();
  means_.Count(AnsweredBy::kSearch, count);
  return absl::OkStatus();
}

}  // namespace geodesic
