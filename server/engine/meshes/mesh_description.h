// What is told of a mesh without having it at hand.

#ifndef GEODESIC_SERVER_ENGINE_MESHES_MESH_DESCRIPTION_H_
#define GEODESIC_SERVER_ENGINE_MESHES_MESH_DESCRIPTION_H_

#include <cstdint>
#include <string>

#include "geodesic/mesh_summary.h"

namespace geodesic::server {

struct MeshDescription {
  std::string digest;
  MeshSummary summary;
  uint64_t resident_bytes = 0;  // 0: not in memory
  uint64_t stored_bytes = 0;    // 0: not on disk
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESHES_MESH_DESCRIPTION_H_
