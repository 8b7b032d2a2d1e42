// Meshes from files that you trust to open.
//
//   const auto mesh = ReadMeshFile("horse.ply");  // a StatusOr
//   const auto field = Solve(**mesh, {.sources = {{VertexPoint{0}}}});
//
// Bytes that arrive otherwise: read_mesh.h. Meshes in memory: mesh_arrays.h.

#ifndef GEODESIC_MESH_FILE_H_
#define GEODESIC_MESH_FILE_H_

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "geodesic/mesh.h"
#include "geodesic/read_mesh.h"

namespace geodesic {

// Reads the file, whose ending names its format (.ply, or .ply.gz if it is
// compressed), and builds the mesh. Holds the file's bytes in memory beside the
// mesh; those that are compressed may hold any number of bytes unless
// max_gzip_bytes says otherwise. Thread-safe.
// Errors, which name the path: what the system says (NOT_FOUND and others);
// those of MeshFormatFromPath, ReadMesh and Mesh::Build.
absl::StatusOr<std::shared_ptr<const Mesh>> ReadMeshFile(
    const std::string& path, const ReadLimits& limits = {});

}  // namespace geodesic

#endif  // GEODESIC_MESH_FILE_H_
