// Keys of fields that nobody computes.

#ifndef GEODESIC_TESTS_ENGINE_FIELD_KEYS_H_
#define GEODESIC_TESTS_ENGINE_FIELD_KEYS_H_

#include <memory>
#include <string>

#include "server/engine/fields/field_cache.h"
#include "tests/support/planar_meshes.h"
#include "tests/support/queries.h"

namespace geodesic::server::test {

// The key of a query that is valid on a grid of ten by ten vertices, as if that
// had the digest.
inline FieldKey KeyOf(const Query& query, const std::string& digest = "mesh") {
  static const std::shared_ptr<const Mesh> grid =
      *Mesh::Build(geodesic::test::MakeGrid({.columns = 9, .rows = 9}));
  return {.mesh_digest = digest,
          .query = geodesic::test::Valid(*grid, query).Sorted().query};
}

}  // namespace geodesic::server::test

#endif  // GEODESIC_TESTS_ENGINE_FIELD_KEYS_H_
