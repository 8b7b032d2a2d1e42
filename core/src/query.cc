#include "geodesic/query.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include "absl/strings/str_cat.h"
#include "anchors.h"
#include "surface_location.h"
#include "tolerances.h"

namespace geodesic {
namespace {

absl::Status CheckOffset(double offset, const Mesh& mesh,
                         const std::string& name) {
  if (!std::isfinite(offset) || offset < 0) {
    return absl::InvalidArgumentError(
        absl::StrCat(name, ".offset ", offset, " is not a finite number >= 0"));
  }
  if (std::ldexp(offset, -mesh.scale_exponent()) > kMostOffset) {
    return absl::InvalidArgumentError(absl::StrCat(
        name, ".offset ", offset, " is more than ", kMostOffset,
        " times the size of the mesh, which would be lost in its rounding"));
  }
  return absl::OkStatus();
}

bool ShareAFace(const Mesh& mesh, const SurfacePoint& a,
                const SurfacePoint& b) {
  const std::vector<FacePoint> around_b = FacesAround(mesh, b);
  for (const FacePoint& in_a : FacesAround(mesh, a)) {
    if (std::ranges::find(around_b, in_a.face, &FacePoint::face) !=
        around_b.end()) {
      return true;
    }
  }
  return false;
}

absl::Status CheckCurve(const CurveSource& curve, const Mesh& mesh,
                        const std::string& name) {
  if (curve.points.empty()) {
    return absl::InvalidArgumentError(
        absl::StrCat(name, ".points is empty: name at least one"));
  }
  for (size_t i = 0; i < curve.points.size(); ++i) {
    if (absl::Status status = Validate(curve.points[i], mesh,
                                       absl::StrCat(name, ".points[", i, "]"));
        !status.ok()) {
      return status;
    }
    if (i > 0 && !ShareAFace(mesh, Canonicalize(curve.points[i - 1], mesh),
                             Canonicalize(curve.points[i], mesh))) {
      return absl::InvalidArgumentError(absl::StrCat(
          name, ".points[", i - 1, "] and [", i,
          "] lie in no common face: add the points where the curve crosses "
          "edges"));
    }
  }
  return CheckOffset(curve.offset, mesh, name);
}

}  // namespace

absl::Status Validate(const Query& query, const Mesh& mesh) {
  if (query.sources.empty() && query.curves.empty()) {
    return absl::InvalidArgumentError("sources is empty: name at least one");
  }
  for (size_t i = 0; i < query.sources.size(); ++i) {
    const std::string name = absl::StrCat("sources[", i, "]");
    if (absl::Status status = Validate(query.sources[i].point, mesh, name);
        !status.ok()) {
      return status;
    }
    if (absl::Status status = CheckOffset(query.sources[i].offset, mesh, name);
        !status.ok()) {
      return status;
    }
  }
  for (size_t i = 0; i < query.curves.size(); ++i) {
    if (absl::Status status =
            CheckCurve(query.curves[i], mesh, absl::StrCat("curves[", i, "]"));
        !status.ok()) {
      return status;
    }
  }
  for (size_t i = 0; i < query.targets.size(); ++i) {
    if (absl::Status status =
            Validate(query.targets[i], mesh, absl::StrCat("targets[", i, "]"));
        !status.ok()) {
      return status;
    }
  }
  const bool known = std::any_of(kAlgorithms.begin(), kAlgorithms.end(),
                                 [&](const AlgorithmInfo& info) {
                                   return info.algorithm == query.algorithm;
                                 });
  if (!known) return absl::InvalidArgumentError("algorithm is unknown");
  return absl::OkStatus();
}

Algorithm AlgorithmFor(const Query& query, const Mesh& mesh) {
  const bool all_vertices =
      query.curves.empty() &&
      std::ranges::all_of(query.sources, [&](const Source& source) {
        return std::holds_alternative<VertexPoint>(
            Canonicalize(source.point, mesh));
      });
  const bool is_one_point = query.curves.empty() && query.sources.size() == 1;
  // The filter helps Chen and Han's rule over a source added later
  // (Computation::AddSource); without it nothing would.
  const bool may_split =
      all_vertices || (is_one_point && query.algorithm != Algorithm::kCh);
  return may_split && !mesh.HasCrowdedEdges() && !mesh.HasCollapsedFaces()
             ? query.algorithm
             : WithTrimming(query.algorithm);
}

Query Canonicalize(Query query, const Mesh& mesh) {
  query.algorithm = AlgorithmFor(query, mesh);
  query = WithCanonicalPoints(std::move(query), mesh);
  for (Source& source : query.sources) source.offset += 0.0;  // -0 -> +0
  for (CurveSource& curve : query.curves) curve.offset += 0.0;
  std::ranges::sort(query.sources,
                    [](const Source& a, const Source& b) { return a < b; });
  const auto same_point = [](const Source& a, const Source& b) {
    return a.point == b.point;
  };
  query.sources.erase(
      std::unique(query.sources.begin(), query.sources.end(), same_point),
      query.sources.end());
  return query;
}

}  // namespace geodesic
