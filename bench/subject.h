// Meshes to measure on.

#ifndef GEODESIC_BENCH_SUBJECT_H_
#define GEODESIC_BENCH_SUBJECT_H_

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/mesh.h"
#include "geodesic/triangle_soup.h"

namespace geodesic {

struct Subject {
  std::string name;
  std::shared_ptr<const Mesh> mesh;

  // A vertex of the face in the middle of the file: not a pole, not a corner.
  uint32_t source() const { return mesh->triangle(mesh->face_count() / 2)[0]; }
};

// REQUIRES: the soup is a mesh.
Subject Generated(std::string name, TriangleSoup soup);

// The meshes of files, each named by its file's stem.
// Errors: as ReadMeshFile.
absl::StatusOr<std::vector<Subject>> LoadSubjects(
    std::span<const std::string> files);

}  // namespace geodesic

#endif  // GEODESIC_BENCH_SUBJECT_H_
