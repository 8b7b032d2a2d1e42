#include "server/engine/pairs/pair_work.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "geodesic/approximate/saddle_vertex_graph.h"
#include "geodesic/approximate/triangle_unfolding.h"
#include "geodesic/computation.h"

namespace geodesic::server {
namespace {

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

// For each vertex.
constexpr uint64_t kMethodBytes = 8 * sizeof(double);

uint32_t VertexOf(const SurfacePoint& point) {
  return std::get<VertexPoint>(point).vertex;
}

const SurfacePoint& OtherEnd(const PointPair& pair, const SurfacePoint& end) {
  return pair.source == end ? pair.target : pair.source;
}

// The distance to `target` from a whole field around `source` in the cache.
std::optional<double> FromCache(FieldEngine& fields, const ResidentMesh& mesh,
                                const SurfacePoint& source,
                                const SurfacePoint& target) {
  const auto* vertex = std::get_if<VertexPoint>(&target);
  if (vertex == nullptr) return {};
  const FieldHandle field = fields.FindWhole(mesh, source);
  if (field == nullptr) return {};
  return field->distances[vertex->vertex];
}

std::optional<double> FromCache(FieldEngine& fields, const ResidentMesh& mesh,
                                const PointPair& pair) {
  std::optional<double> found =
      FromCache(fields, mesh, pair.source, pair.target);
  if (!found) found = FromCache(fields, mesh, pair.target, pair.source);
  return found;
}

}  // namespace

ValidQuery PairWork::QueryOf(const SurfacePoint& source,
                             std::vector<SurfacePoint> targets) const {
  return *ValidQuery::Make({.sources = {{source}},
                            .targets = std::move(targets),
                            .trace = paths,
                            .tolerance = tolerance},
                           *mesh->mesh);
}

uint64_t PairWork::PlannedBytes() const {
  // A search of a graph, or a field and what it is computed from.
  if (method.has_value()) return mesh->mesh->vertex_count() * kMethodBytes;
  const ValidQuery query = QueryOf(pairs[0].source, {pairs[0].target});
  const uint64_t of_search = SearchEngine::PlannedBytes(*mesh->mesh, query);
  const uint64_t of_landmarks =
      landmarks > 0 ? LandmarkMaker::PlannedBytes(*mesh->mesh) : 0;
  const bool has_field = std::ranges::any_of(
      rows, [](const PairRow& row) { return row.shared.has_value(); });
  const uint64_t of_field =
      has_field ? PlannedSolverBytes(*mesh->mesh, query) : 0;
  return std::max({of_search, of_field, of_landmarks});
}

uint64_t PairWork::RowBytes() const {
  size_t most = 0;
  for (const PairRow& row : rows) most = std::max(most, row.pairs.size());
  // The other ends are the targets of a field.
  return most * (sizeof(double) + sizeof(uint32_t) + sizeof(SurfacePoint));
}

absl::StatusOr<MatrixRow> PairWork::Answer(uint64_t row, Checkpoint& checkpoint,
                                           ByteReservation memory) const {
  const PairRow& plan = rows[row];
  MatrixRow result{.memory = std::move(memory), .columns = plan.pairs};
  result.values.reserve(plan.pairs.size());
  absl::Status status;
  if (method.has_value()) {
    status = Approximate(plan, checkpoint, result.values);
  } else if (plan.shared.has_value()) {
    status = Solve(plan, checkpoint, result);
  } else {
    status = Search(plan.pairs, checkpoint, result);
  }
  if (!status.ok()) return status;
  result.memory.ShrinkTo(plan.pairs.size() *
                         (sizeof(double) + sizeof(uint32_t)));
  status = result.memory.GrowTo(result.memory.bytes() + BytesOf(result.paths));
  if (!status.ok()) return status;
  return result;
}

absl::Status PairWork::Search(const std::vector<uint32_t>& numbers,
                              Checkpoint& checkpoint, MatrixRow& row) const {
  std::optional<SearchPool::Loan> search;
  SumOfSearches sum(checkpoint);
  absl::Status status;
  if (landmarks > 0 && !makes_landmarks.exchange(true)) {
    const absl::StatusOr<bool> are_made =
        searches.landmarks().MakeNow(mesh, landmarks, checkpoint);
    if (!are_made.ok()) return are_made.status();
    // A later row asks again.
    makes_landmarks = *are_made;
  }
  const SearchMeans means = searches.MeansFor(mesh, algorithm);
  for (const uint32_t number : numbers) {
    const PointPair& pair = pairs[number];
    const auto cached = paths ? std::nullopt : FromCache(fields, *mesh, pair);
    if (cached) {
      row.values.push_back(*cached);
      ++answered.from_cache;
      ++totals.from_cache;
      continue;
    }
    if (!search) search.emplace(searches.pool().Lend(mesh));
    sum.Next();
    absl::StatusOr<TargetDistances> found = (*search)->Run(
        QueryOf(pair.source, {pair.target}), means.landmarks.get(), sum);
    if (!found.ok()) {
      status = found.status();
      break;
    }
    row.values.push_back(found->distances[0]);
    row.certified_error = std::max(row.certified_error, found->certified_error);
    if (paths) row.paths.push_back(std::move(found->paths[0]));
    ++answered.searched;
    ++totals.searched;
  }
  if (status.ok() && TargetSearch::IsDirected(algorithm)) {
    searches.landmarks().Want(mesh);
  }
  if (search) search->GiveBack();
  return status;
}

absl::Status PairWork::Solve(const PairRow& row, Checkpoint& checkpoint,
                             MatrixRow& result) const {
  std::vector<double>& distances = result.values;
  for (const uint32_t number : row.pairs) {
    const SurfacePoint& other = OtherEnd(pairs[number], *row.shared);
    const auto cached = FromCache(fields, *mesh, *row.shared, other);
    if (!cached) break;
    distances.push_back(*cached);
  }
  const size_t count = row.pairs.size();
  if (distances.size() == count) {
    answered.from_cache += count;
    totals.from_cache += count;
    return absl::OkStatus();
  }
  std::vector<SurfacePoint> targets;
  targets.reserve(count);
  for (const uint32_t number : row.pairs) {
    targets.push_back(OtherEnd(pairs[number], *row.shared));
  }
  auto computation =
      start(*mesh->mesh, QueryOf(*row.shared, std::move(targets)), options);
  if (!computation.ok()) return computation.status();
  absl::Status status = (*computation)->Advance({.targets = count}, checkpoint);
  if (!status.ok()) return status;
  DistanceField field = (*computation)->Field();
  distances = std::move(field.target_distances);
  result.certified_error = field.certified_error;
  answered.from_fields += count;
  totals.from_fields += count;
  return absl::OkStatus();
}

absl::Status PairWork::Approximate(const PairRow& row, Checkpoint& checkpoint,
                                   std::vector<double>& distances) const {
  const size_t count = row.pairs.size();
  if (row.shared.has_value()) {
    const ValidQuery query = QueryOf(*row.shared, {});
    const absl::StatusOr<ApproximateField> field =
        method->method->Distances(query, checkpoint);
    if (!field.ok()) return field.status();
    for (const uint32_t number : row.pairs) {
      const SurfacePoint& other = OtherEnd(pairs[number], *row.shared);
      distances.push_back(field->distances[VertexOf(other)]);
    }
    answered.from_fields += count;
    totals.from_fields += count;
    return absl::OkStatus();
  }
  const auto* graph =
      dynamic_cast<const SaddleVertexGraph*>(method->method.get());
  const auto* unfolding =
      dynamic_cast<const TriangleUnfolding*>(method->method.get());
  const LandmarksHandle known =
      graph == nullptr ? nullptr : searches.landmarks().Present(*mesh);
  std::optional<SaddleGraphSearch> search;
  if (graph != nullptr) search.emplace(*graph);
  for (const uint32_t number : row.pairs) {
    const uint32_t from = VertexOf(pairs[number].source);
    const uint32_t to = VertexOf(pairs[number].target);
    distances.push_back(search ? search->Distance(from, to, known.get())
                               : unfolding->Distance(from, to));
    absl::Status status =
        checkpoint.Poll({.vertices = mesh->mesh->vertex_count(),
                         .solver_bytes = search ? search->bytes() : 0});
    if (!status.ok()) return status;
  }
  if (graph != nullptr) searches.landmarks().Want(mesh);
  answered.searched += count;
  totals.searched += count;
  return absl::OkStatus();
}

}  // namespace geodesic::server
