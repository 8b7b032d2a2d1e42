// From a mesh's scaled unit (Mesh::scale_exponent) back to that of its file.

#ifndef GEODESIC_MESH_FILE_UNIT_H_
#define GEODESIC_MESH_FILE_UNIT_H_

#include <cmath>

#include "geodesic/mesh.h"

namespace geodesic {

// In two steps, since 2 to that exponent may be no normal number.
inline double ToFileUnit(const Mesh& mesh, double length) {
  const int half = mesh.scale_exponent() / 2;
  return length * std::ldexp(1, half) *
         std::ldexp(1, mesh.scale_exponent() - half);
}

}  // namespace geodesic

#endif  // GEODESIC_MESH_FILE_UNIT_H_
