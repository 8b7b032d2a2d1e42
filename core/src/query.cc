#include "geodesic/query.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "absl/strings/str_cat.h"

namespace geodesic {

absl::Status Validate(const Query& query, uint64_t vertex_count) {
  if (query.sources.empty()) {
    return absl::InvalidArgumentError("sources is empty: name at least one");
  }
  for (size_t i = 0; i < query.sources.size(); ++i) {
    const Source& source = query.sources[i];
    if (source.vertex >= vertex_count) {
      return absl::InvalidArgumentError(
          absl::StrCat("sources[", i, "].vertex ", source.vertex,
                       " is out of range: the mesh has ", vertex_count,
                       " vertices, numbered from 0"));
    }
    if (!std::isfinite(source.offset) || source.offset < 0) {
      return absl::InvalidArgumentError(
          absl::StrCat("sources[", i, "].offset ", source.offset,
                       " is not a finite number >= 0"));
    }
  }
  const bool known = std::any_of(kAlgorithms.begin(), kAlgorithms.end(),
                                 [&](const AlgorithmInfo& info) {
                                   return info.algorithm == query.algorithm;
                                 });
  if (!known) return absl::InvalidArgumentError("algorithm is unknown");
  return absl::OkStatus();
}

Query Canonicalize(Query query) {
  for (Source& source : query.sources) source.offset += 0.0;  // -0 -> +0
  std::sort(query.sources.begin(), query.sources.end());
  const auto same_vertex = [](const Source& a, const Source& b) {
    return a.vertex == b.vertex;
  };
  query.sources.erase(
      std::unique(query.sources.begin(), query.sources.end(), same_vertex),
      query.sources.end());
  return query;
}

}  // namespace geodesic
