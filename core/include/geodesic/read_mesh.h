// Bounded readers for mesh files (OBJ, PLY, OFF, STL, VTK, VTP, glTF) held
// in memory.
//
//   absl::StatusOr<MeshFormat> format = MeshFormatFromPath("horse.ply");
//   absl::StatusOr<TriangleSoup> soup = ReadMesh(bytes, *format);
//   absl::StatusOr<std::shared_ptr<const Mesh>> mesh = Mesh::Build(*soup);
//
// The bytes may be hostile. A reader
//   1. opens no file and follows no reference (an OBJ's mtllib is ignored);
//   2. allocates nothing because a header says so: memory grows with bytes that
//      have been read, and stays within a small factor of the input's size, or
//      of what it holds where it is compressed (1032 times as much at the
//      most);
//   3. keeps doubles as doubles (correctly rounded) and the file's vertex
//      order, unused and repeated vertices included. In STL, which numbers no
//      vertices, they are counted where they first appear: one for all corners
//      with equal coordinates whose faces hang together by their edges (with
//      Welding::kNone each corner is a vertex); those of parts that touch only
//      there come last;
//   4. turns a polygon with k corners into k - 2 triangles that cover it once,
//      and counts those that cross themselves (see triangle_soup.h);
//   5. returns only finite coordinates and indices within range;
//   6. joins boundary edges that lie on each other (join_seams.h) and says so
//      (TriangleSoup::reading).
//
// Error messages number the file's faces and vertices from 0, where a face is a
// polygon before triangulation. They quote an OBJ's references as written.

#ifndef GEODESIC_READ_MESH_H_
#define GEODESIC_READ_MESH_H_

#include <cstdint>
#include <string_view>

#include "absl/status/statusor.h"
#include "geodesic/join_seams.h"
#include "geodesic/triangle_soup.h"
#include "geodesic_types/mesh_format.h"

namespace geodesic {

class Checkpoint;

// What a file may hold, and how it is read.
struct ReadLimits {
  // DEFAULT: what 32-bit half-edge indices can address.
  uint64_t max_vertices = uint64_t{1} << 31;
  uint64_t max_triangles = (uint64_t{1} << 32) / 3 - 1;
  // What a file that is compressed with gzip may hold. DEFAULT: 0, such files
  // are refused; ReadMeshFile (mesh_file.h) reads them whatever they hold.
  uint64_t max_gzip_bytes = 0;
  // Polled now and then, and may stop the reader. DEFAULT: nothing stops it.
  Checkpoint* checkpoint = nullptr;
  // Which boundary edges are joined.
  Welding welding = {};
};

// Reads a whole file. Thread-safe; linear in the size of `bytes`, but
// O(n log n) for a polygon of n corners that is not convex, and O(n^2) for
// contrived ones.
// Errors: INVALID_ARGUMENT for a malformed file, naming the line (text) or the
// byte offset (binary) and the element; RESOURCE_EXHAUSTED when a limit is
// passed, naming it; those of Validate(welding); whatever the checkpoint
// returns. A file without faces is
// not an error here.
absl::StatusOr<TriangleSoup> ReadMesh(std::string_view bytes, MeshFormat format,
                                      const ReadLimits& limits = {});

}  // namespace geodesic

#endif  // GEODESIC_READ_MESH_H_
