#include "geodesic/valid_query.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <variant>

#include "absl/strings/str_cat.h"
#include "geodesic_types/field_path.h"
#include "surface/surface_location.h"
#include "tolerances.h"

namespace geodesic {
namespace {

// Checks a number, a place or a list of them, and makes it canonical. `path`
// names it.

absl::Status MakeCanonical(Source& source, const Mesh& mesh,
                           const std::string& path);

absl::Status MakeCanonical(SurfacePoint& point, const Mesh& mesh,
                           const std::string& path) {
  absl::Status status = Validate(point, mesh, path);
  if (status.ok()) point = Canonicalize(point, mesh);
  return status;
}

// Of a million items most are right, and to name one takes longer than to check
// it: it is only named where it is wrong.
template <typename Item>
absl::Status MakeAllCanonical(std::vector<Item>& items, const Mesh& mesh,
                              const std::string& path) {
  for (size_t i = 0; i < items.size(); ++i) {
    if (MakeCanonical(items[i], mesh, "").ok()) continue;
    return MakeCanonical(items[i], mesh, absl::StrCat(path, "[", i, "]"));
  }
  return absl::OkStatus();
}

absl::Status MakeCanonical(double& offset, const Mesh& mesh,
                           const std::string& path) {
  if (!std::isfinite(offset) || offset < 0) {
    return InvalidField(
        path, absl::StrCat(path, " ", offset, " is not a finite number >= 0"));
  }
  if (std::ldexp(offset, -mesh.scale_exponent()) > kMostOffset) {
    return InvalidField(
        path,
        absl::StrCat(path, " ", offset, " is more than ", kMostOffset,
                     " times the size of the mesh, which would be lost in its "
                     "rounding"));
  }
  offset += 0.0;  // -0 -> +0
  return absl::OkStatus();
}

bool ShareAFace(const Mesh& mesh, const SurfacePoint& a,
                const SurfacePoint& b) {
  return VisitSharedFaces(
      mesh, a, b, [](const FacePoint&, const FacePoint&) { return true; });
}

absl::Status MakeCanonical(Curve& curve, const Mesh& mesh,
                           const std::string& path) {
  std::vector<SurfacePoint>& points = curve.points;
  const std::string list = absl::StrCat(path, ".curve.points");
  if (points.empty()) {
    return InvalidField(list,
                        absl::StrCat(list, " is empty: name at least one"));
  }
  absl::Status status = MakeAllCanonical(points, mesh, list);
  if (!status.ok()) return status;
  for (size_t i = 1; i < points.size(); ++i) {
    if (ShareAFace(mesh, points[i - 1], points[i])) continue;
    return InvalidField(
        absl::StrCat(list, "[", i, "]"),
        absl::StrCat(list, "[", i - 1, "] and [", i,
                     "] lie in no common face: add the points where the curve "
                     "crosses edges"));
  }
  return absl::OkStatus();
}

absl::Status MakeCanonical(Source& source, const Mesh& mesh,
                           const std::string& path) {
  absl::Status status =
      std::visit([&](auto& place) { return MakeCanonical(place, mesh, path); },
                 source.place);
  if (!status.ok()) return status;
  return MakeCanonical(source.offset, mesh, absl::StrCat(path, ".offset"));
}

bool AreAllVertices(const std::vector<Source>& sources) {
  return std::ranges::all_of(sources, [](const Source& source) {
    const auto* point = std::get_if<SurfacePoint>(&source.place);
    return point != nullptr && std::holds_alternative<VertexPoint>(*point);
  });
}

// REQUIRES: the points of `query` are canonical.
Algorithm AlgorithmFor(const Query& query, Algorithm asked, const Mesh& mesh) {
  const bool all_points = std::ranges::none_of(query.sources, IsCurve);
  if (!all_points || mesh.HasCollapsedFaces()) return WithTrimming(asked);
  // Lists are trimmed, too.
  if (asked == Algorithm::kFwpList) return asked;
  // What Chen and Han's rule splits must not be passed on both sides. The
  // filter helps it over a source added later (Computation::AddSource); without
  // it nothing would.
  const bool is_filtered_point =
      query.sources.size() == 1 && asked != Algorithm::kCh;
  const bool may_split = AreAllVertices(query.sources) || is_filtered_point;
  return may_split && !mesh.HasNonManifoldEdges() ? asked : WithTrimming(asked);
}

bool IsTolerance(double tolerance) {
  return tolerance == 0 ||
         (tolerance >= kLeastTolerance && tolerance <= kMostTolerance);
}

// So little is merged below this that an exact field takes less time, up to a
// million faces and more (docs/benchmarks.md).
constexpr double kLeastMerged = 1e-5;

// Only windows in the order of fwp-list are merged, and no trace leads back
// through a merged window; all else is exact. Nor are windows merged where two
// of them may change over twice (Front::MayChangeOverTwice): that it ends there
// has not been shown. REQUIRES: query.algorithm is the one that runs.
double ToleranceFor(const Query& query, const Mesh& mesh) {
  const bool merges =
      query.algorithm == Algorithm::kFwpList && !query.trace &&
      query.tolerance >= kLeastMerged && !mesh.HasNonManifoldEdges() &&
      (query.sources.size() == 1 || AreAllVertices(query.sources));
  return merges ? query.tolerance : 0;
}

}  // namespace

absl::StatusOr<ValidQuery> ValidQuery::Make(Query query, const Mesh& mesh) {
  if (query.sources.empty()) {
    return InvalidField("sources", "sources is empty: name at least one");
  }
  absl::Status status = MakeAllCanonical(query.sources, mesh, "sources");
  if (status.ok()) status = MakeAllCanonical(query.targets, mesh, "targets");
  if (!status.ok()) return status;
  const Asked asked{query.algorithm, query.tolerance};
  if (std::ranges::find(kAlgorithms, asked.algorithm,
                        &AlgorithmInfo::algorithm) == kAlgorithms.end()) {
    return InvalidField("algorithm", "algorithm is unknown");
  }
  if (!IsTolerance(query.tolerance)) {
    return InvalidField(
        "tolerance",
        absl::StrCat("tolerance ", query.tolerance, " is neither 0 nor in [",
                     kLeastTolerance, ", ", kMostTolerance, "]"));
  }
  query.algorithm = AlgorithmFor(query, asked.algorithm, mesh);
  query.tolerance = ToleranceFor(query, mesh);
  return ValidQuery(std::move(query), asked);
}

ValidQuery::ValidQuery(Query query, Asked asked)
    : query_(std::make_shared<const Query>(std::move(query))), asked_(asked) {}

SortedQuery ValidQuery::Sorted() const {
  const std::vector<Source>& sources = query_->sources;
  std::vector<uint32_t> numbers(sources.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  std::ranges::stable_sort(numbers, [&](uint32_t a, uint32_t b) {
    if (IsCurve(sources[a])) return false;
    return IsCurve(sources[b]) || sources[a] < sources[b];
  });
  // Not of std::ranges, whose views clang 14 cannot compile.
  const auto repeated =
      std::unique(numbers.begin(), numbers.end(), [&](auto a, auto b) {
        return !IsCurve(sources[a]) && sources[a].place == sources[b].place;
      });
  numbers.erase(repeated, numbers.end());
  Query sorted{.targets = query_->targets,
               .algorithm = query_->algorithm,
               .trace = query_->trace,
               .tolerance = query_->tolerance};
  for (const uint32_t number : numbers) {
    sorted.sources.push_back(sources[number]);
  }
  return {ValidQuery(std::move(sorted), asked_), std::move(numbers)};
}

ValidQuery ValidQuery::WithTrace(bool trace) const {
  Query query = *query_;
  query.trace = trace;
  if (trace) query.tolerance = 0;
  return {std::move(query), asked_};
}

ValidQuery ValidQuery::WithoutVertexTargets() const {
  Query query = *query_;
  std::erase_if(query.targets, [](const SurfacePoint& target) {
    return std::holds_alternative<VertexPoint>(target);
  });
  return {std::move(query), asked_};
}

ValidQuery ValidQuery::DistancesAlone() const {
  return {{.sources = query_->sources,
           .algorithm = query_->algorithm,
           .tolerance = query_->tolerance},
          asked_};
}

ValidQuery ValidQuery::WithoutTolerance() const {
  if (asked_.tolerance == 0) return *this;
  Query query = *query_;
  query.tolerance = 0;
  return {std::move(query), {asked_.algorithm, 0}};
}

ValidQuery ValidQuery::OfSource(uint32_t source, const Mesh& mesh) const {
  Query query{.sources = {query_->sources[source]},
              .targets = query_->targets,
              .trace = query_->trace,
              .tolerance = asked_.tolerance};
  query.algorithm = AlgorithmFor(query, asked_.algorithm, mesh);
  query.tolerance = ToleranceFor(query, mesh);
  return {std::move(query), asked_};
}

ValidQuery ValidQuery::OfTarget(uint32_t target) const {
  Query query{.sources = query_->sources,
              .targets = {query_->targets[target]},
              .algorithm = query_->algorithm,
              .trace = query_->trace,
              .tolerance = query_->tolerance};
  return {std::move(query), asked_};
}

ValidQuery ValidQuery::Transposed(const Mesh& mesh) const {
  Query query{.tolerance = asked_.tolerance};
  for (const SurfacePoint& target : query_->targets) {
    query.sources.push_back({target});
  }
  for (const Source& source : query_->sources) {
    query.targets.push_back(std::get<SurfacePoint>(source.place));
  }
  query.algorithm = AlgorithmFor(query, asked_.algorithm, mesh);
  query.tolerance = ToleranceFor(query, mesh);
  return {std::move(query), asked_};
}

}  // namespace geodesic
