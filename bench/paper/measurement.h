// Meshes to measure on, and what solving on them costs.

#ifndef GEODESIC_BENCH_PAPER_MEASUREMENT_H_
#define GEODESIC_BENCH_PAPER_MEASUREMENT_H_

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/algorithm.h"
#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "geodesic/solve_options.h"
#include "geodesic/triangle_soup.h"

namespace geodesic::paper {

struct Subject {
  std::string name;
  std::shared_ptr<const Mesh> mesh;

  // A vertex of the face in the middle of the file: not a pole, not a corner.
  uint32_t source() const {
    return mesh->triangles()[mesh->face_count() / 2][0];
  }
};

// REQUIRES: the soup is a mesh.
Subject Generated(std::string name, TriangleSoup soup);

// The meshes of files, each named by its file's stem.
// Errors: as LoadMesh, with the file's name.
absl::StatusOr<std::vector<Subject>> LoadSubjects(
    std::span<const std::string> files);

// The paper's parameters: l = h / sqrt(n), K_max = 20000.
inline constexpr SolveOptions kPaperOptions = {.bucket_width = 1,
                                               .max_batch = 20000};

// Solves from subject.source() until `most_runs` are done or as many as make a
// third of a second, and returns the statistics of the fastest. Its
// solve_seconds are processor time: one thread solves, and others may share the
// machine.
SolveStatistics Measure(const Subject& subject, Algorithm algorithm,
                        const SolveOptions& options, int most_runs);

// Whether it is worth waiting for an algorithm on so many faces. CH without a
// filter makes ten to fifty times the windows of the others.
inline bool IsFeasible(Algorithm algorithm, uint64_t faces) {
  constexpr uint64_t kMostFacesForCh = 6000;
  return algorithm != Algorithm::kCh || faces <= kMostFacesForCh;
}

}  // namespace geodesic::paper

#endif  // GEODESIC_BENCH_PAPER_MEASUREMENT_H_
