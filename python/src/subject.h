// What the functions of the extension are about: a mesh, a question on it, and
// what an approximate algorithm has prepared of it.

#ifndef GEODESIC_PYTHON_SUBJECT_H_
#define GEODESIC_PYTHON_SUBJECT_H_

#include <memory>
#include <optional>
#include <utility>

#include "geodesic/approximate/prepared_method.h"
#include "geodesic/mesh.h"
#include "geodesic/rows/kept_searches.h"
#include "geodesic/rows/rows.h"
#include "geodesic/valid_query.h"

namespace geodesic::python {

// Safe in any number of threads.
struct MeshHandle {
  explicit MeshHandle(std::shared_ptr<const Mesh> of)
      : mesh(std::move(of)), searches(std::make_shared<KeptSearches>(*mesh)) {}

  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<KeptSearches> searches;
};

struct QueryHandle {
  MeshHandle on;
  ValidQuery query;

  const Mesh& mesh() const { return *on.mesh; }
};

// Immutable.
struct MethodHandle {
  MeshHandle on;
  std::shared_ptr<const PreparedMethod> prepared;
};

// None where there is none.
inline std::optional<RowMethod> RowMethodOf(const MethodHandle* method) {
  if (method == nullptr) return std::nullopt;
  return RowMethod{method->prepared->method(), method->prepared};
}

}  // namespace geodesic::python

#endif  // GEODESIC_PYTHON_SUBJECT_H_
