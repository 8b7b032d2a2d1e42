// What makes two queries the same question.

#ifndef GEODESIC_SERVER_ENGINE_FIELD_KEY_H_
#define GEODESIC_SERVER_ENGINE_FIELD_KEY_H_

#include <compare>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "geodesic/query.h"
#include "geodesic/solve.h"

namespace geodesic::server {

// Names a field: equal keys have equal bits. The tuning is part of it because
// it changes the statistics and the last bits.
struct FieldKey {
  std::string mesh_digest;
  std::vector<Source> sources;  // canonical
  Algorithm algorithm = kDefaultAlgorithm;
  double bucket_width = 0;
  uint32_t max_batch = 0;
  bool adaptive_batch = true;

  friend auto operator<=>(const FieldKey&, const FieldKey&) = default;
};

// REQUIRES: `query` is valid for the mesh.
inline FieldKey MakeFieldKey(std::string mesh_digest, const Mesh& mesh,
                             Query query, const SolveOptions& options) {
  Query canonical = Canonicalize(std::move(query), mesh);
  return {.mesh_digest = std::move(mesh_digest),
          .sources = std::move(canonical.sources),
          .algorithm = canonical.algorithm,
          .bucket_width = options.bucket_width,
          .max_batch = options.max_batch,
          .adaptive_batch = options.adaptive_batch};
}

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_FIELD_KEY_H_
