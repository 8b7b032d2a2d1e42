// Meshes as a client holds and names them.

#ifndef GEODESIC_CLIENT_MESH_H_
#define GEODESIC_CLIENT_MESH_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic_client/answer.h"
#include "geodesic_types/mesh_summary.h"
#include "geodesic_types/places.h"

namespace geodesic::client {

// Three vertex indices, 0-based.
using Triangle = std::array<uint32_t, 3>;

// A mesh's canonical arrays.
struct MeshArrays {
  std::vector<Point> positions;
  std::vector<Triangle> triangles;
  // Vertices that repeat others, each with the one whose place it takes, by
  // rising numbers. Of meshes that a server has read; uploads take none.
  std::vector<std::array<uint32_t, 2>> joined = {};
};

// The name that every server gives this mesh: 64 lower-case hexadecimal digits
// of SHA-256, as geodesic/v1/mesh.proto defines it. Thread-safe. Linear.
std::string MeshDigest(const MeshArrays& mesh);

// Whether `text` has the form of a mesh's name.
bool IsMeshDigest(std::string_view text);

// Which edges of a mesh file are joined at which it keeps faces apart: programs
// repeat vertices where a texture, a normal or a colour changes.
struct Welding {
  // Nothing is joined.
  bool keep_seams = false;
  // Boundary edges whose ends lie within this distance of each other, in the
  // unit of the file. DEFAULT: within the rounding of the file's numbers.
  std::optional<double> distance = {};
};

// What an approximate algorithm has made of a mesh, to answer faster.
struct PreparedMethod {
  std::string algorithm;
  Approximation approximation;
  // Memory that it takes on the server.
  uint64_t bytes = 0;
  // How long it took to make, or to load from disk.
  double prepare_seconds = 0;
};

// A mesh that is resident on the server, and the facts about it.
struct MeshInfo : MeshSummary {
  std::string digest;
  // What was joined, left out or guessed when the mesh was read, and what looks
  // as if it should have been joined: a sentence each, for people.
  std::vector<std::string> notes = {};
  // Memory that the mesh takes on the server; 0 if it is on disk only.
  uint64_t resident_bytes = 0;
  // Bytes that the mesh takes on the server's disk; 0 if the server keeps
  // nothing there.
  uint64_t stored_bytes = 0;
  // Vertices whose distances to all others the server keeps, to answer faster.
  uint64_t landmark_count = 0;
  // What the server keeps in memory for approximate algorithms.
  std::vector<PreparedMethod> prepared_methods = {};
};

// What became of an upload.
struct UploadOutcome {
  MeshInfo mesh;
  // The server had the mesh already.
  bool already_resident = false;
  // Bytes of mesh data that went over the wire; 0 if the server knew the file.
  uint64_t bytes_sent = 0;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_MESH_H_
