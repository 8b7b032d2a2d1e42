// Mesh files for the programs that measure.

#ifndef GEODESIC_BENCH_LOAD_MESH_H_
#define GEODESIC_BENCH_LOAD_MESH_H_

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "geodesic/mesh.h"

namespace geodesic {

// Errors: NOT_FOUND if the file cannot be opened; as MeshFormatFromPath,
// ReadMesh and Mesh::Build.
absl::StatusOr<std::shared_ptr<const Mesh>> LoadMesh(const std::string& path);

}  // namespace geodesic

#endif  // GEODESIC_BENCH_LOAD_MESH_H_
