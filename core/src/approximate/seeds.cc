#include "approximate/seeds.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <variant>

#include "absl/strings/str_cat.h"
#include "geodesic_types/field_path.h"
#include "solver/work_meter.h"
#include "surface/surface_location.h"

namespace geodesic {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

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
                                          ApproximateMethod method,
                                          Checkpoint& checkpoint) {
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
  // By vertex: very many sources may each have very many corners around them.
  std::vector<double> nearest(mesh.vertex_count(), kInfinity);
  std::vector<uint32_t> vertices;
  const auto offer = [&](uint32_t v, double distance) {
    if (std::isinf(nearest[v])) vertices.push_back(v);
    nearest[v] = std::min(nearest[v], distance);
  };
  const auto poll = [&] {
    return checkpoint.Poll(
        {.vertices = mesh.vertex_count(),
         .solver_bytes = nearest.size() * sizeof(double) +
                         vertices.capacity() * sizeof(uint32_t)});
  };
  WorkMeter meter(poll);
  for (const Source& source : query->sources) {
    const auto& point = std::get<SurfacePoint>(source.place);
    const double offset = std::ldexp(source.offset, -mesh.scale_exponent());
    if (const auto* at = std::get_if<VertexPoint>(&point)) {
      offer(at->vertex, offset);
      continue;
    }
    VisitFacesAround(mesh, point, [&](const FacePoint& place) {
      for (uint32_t corner = 0; corner < 3; ++corner) {
        offer(mesh.triangle(place.face)[corner],
              offset + DistanceToCorner(mesh, place, corner));
      }
      return !meter.Do();
    });
    if (!meter.status().ok()) return meter.status();
  }
  std::ranges::sort(vertices);
  std::vector<Seed> seeds;
  seeds.reserve(vertices.size());
  for (const uint32_t v : vertices) seeds.push_back({v, nearest[v]});
  return seeds;
}

}  // namespace geodesic
