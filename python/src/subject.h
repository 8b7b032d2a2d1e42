// What the functions of the extension are about: a mesh, and a question on it.

#ifndef GEODESIC_PYTHON_SUBJECT_H_
#define GEODESIC_PYTHON_SUBJECT_H_

#include <memory>
#include <utility>

#include "geodesic/mesh.h"
#include "geodesic/valid_query.h"
#include "search_pool.h"

namespace geodesic::python {

// Safe in any number of threads.
struct MeshHandle {
  explicit MeshHandle(std::shared_ptr<const Mesh> of)
      : mesh(std::move(of)), searches(std::make_shared<SearchPool>(*mesh)) {}

  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<SearchPool> searches;
};

struct QueryHandle {
  MeshHandle on;
  ValidQuery query;

  const Mesh& mesh() const { return *on.mesh; }
};

}  // namespace geodesic::python

#endif  // GEODESIC_PYTHON_SUBJECT_H_
