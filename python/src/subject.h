// What the functions of the extension are about: a mesh, and a question on it.

#ifndef GEODESIC_PYTHON_SUBJECT_H_
#define GEODESIC_PYTHON_SUBJECT_H_

#include <memory>

#include "geodesic/mesh.h"
#include "geodesic/valid_query.h"

namespace geodesic::python {

// Immutable, hence safe in any number of threads.
struct MeshHandle {
  std::shared_ptr<const Mesh> mesh;
};

struct QueryHandle {
  std::shared_ptr<const Mesh> mesh;
  ValidQuery query;
};

}  // namespace geodesic::python

#endif  // GEODESIC_PYTHON_SUBJECT_H_
