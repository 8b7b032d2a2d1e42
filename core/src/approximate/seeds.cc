#include "approximate/seeds.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include "absl/strings/str_cat.h"
#include "geodesic_types/field_path.h"
#include "surface/surface_location.h"

namespace geodesic {
namespace {

absl::Status Refuse(const std::string& path, ApproximateMethod method,
                    std::string_view what) {
  return InvalidField(
      path, absl::StrCat(path, ": ", std::string(ApproximateMethodName(method)),
                         " ", std::string(what)));
}

}  // namespace

absl::Status CheckSources(ApproximateMethod method,
                          std::span<const Source> sources) {
  for (size_t s = 0; s < sources.size(); ++s) {
    const std::string path = absl::StrCat("sources[", s, "]");
    if (IsCurve(sources[s])) {
      return Refuse(path + ".curve", method,
                    "starts from points; ask an exact algorithm");
    }
    if (method == ApproximateMethod::kHeat && sources[s].offset != 0) {
      return Refuse(path + ".offset", method,
                    "starts from all sources at once; ask fmm or an exact "
                    "algorithm");
    }
  }
  return absl::OkStatus();
}

absl::Status NoVertex(ApproximateMethod method, const std::string& path) {
  return InvalidField(
      path, absl::StrCat(path, " is no vertex: ",
                         std::string(ApproximateMethodName(method)),
                         " is approximate and gives the distances of vertices "
                         "alone; name a vertex, or ask an exact algorithm"));
}

absl::Status CheckPlaces(ApproximateMethod method, const Query& query) {
  absl::Status status = CheckSources(method, query.sources);
  if (!status.ok()) return status;
  const std::vector<SurfacePoint>& targets = query.targets;
  for (size_t t = 0; t < targets.size(); ++t) {
    if (std::holds_alternative<VertexPoint>(targets[t])) continue;
    return NoVertex(method, absl::StrCat("targets[", t, "]"));
  }
  return absl::OkStatus();
}

absl::StatusOr<std::vector<Seed>> SeedsOf(const ValidQuery& query,
                                          const Mesh& mesh,
                                          ApproximateMethod method) {
  if (!query->targets.empty()) {
    return Refuse("targets[0]", method,
                  "gives the distances of vertices alone; leave targets out");
  }
  if (query->trace) {
    return Refuse("trace", method,
                  "keeps no paths; ask an exact algorithm for them");
  }
  if (query->tolerance > 0) {
    return Refuse("tolerance", method,
                  "has no bound on its error; ask an exact algorithm");
  }
  absl::Status status = CheckSources(method, query->sources);
  if (!status.ok()) return status;
  std::vector<Seed> seeds;
  for (const Source& source : query->sources) {
    const auto& point = std::get<SurfacePoint>(source.place);
    const double offset = std::ldexp(source.offset, -mesh.scale_exponent());
    if (const auto* at = std::get_if<VertexPoint>(&point)) {
      seeds.push_back({at->vertex, offset});
      continue;
    }
    for (const FacePoint& place : FacesAround(mesh, point)) {
      for (uint32_t corner = 0; corner < 3; ++corner) {
        seeds.push_back({mesh.triangle(place.face)[corner],
                         offset + DistanceToCorner(mesh, place, corner)});
      }
    }
  }
  std::ranges::sort(seeds, [](const Seed& a, const Seed& b) {
    return a.vertex != b.vertex ? a.vertex < b.vertex : a.distance < b.distance;
  });
  const auto repeated = std::unique(
      seeds.begin(), seeds.end(),
      [](const Seed& a, const Seed& b) { return a.vertex == b.vertex; });
  seeds.erase(repeated, seeds.end());
  return seeds;
}

}  // namespace geodesic
