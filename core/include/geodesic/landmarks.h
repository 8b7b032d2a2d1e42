// Vertices whose exact distances to all others are known: they bound the
// distance between any two places from below.

#ifndef GEODESIC_LANDMARKS_H_
#define GEODESIC_LANDMARKS_H_

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/mesh.h"
#include "geodesic/solve_options.h"
#include "geodesic/surface_point.h"

namespace geodesic {

// By the triangle inequality |d(l, x) - d(l, y)| <= d(x, y) for each landmark
// l. Distances are kept as whole steps of a length, 128 bytes a vertex; the
// bounds allow for their rounding. Const functions are thread-safe.
class Landmarks {
 public:
  static constexpr uint32_t kMost = 64;

  // By landmark, in steps.
  using Steps = std::array<uint16_t, kMost>;

  // A vertex is as many steps away from the place, at the least, as its number
  // is below `before` or above `beyond`, whatever the landmark.
  struct Place {
    Steps before = {}, beyond = {};
    // Whether it is in another part of the mesh than the landmarks.
    bool is_apart = false;
  };

  // The distances from a vertex to every landmark, rounded down; kApart from
  // those in another part of the mesh, zeros where there is none yet.
  struct alignas(64) Row {
    Steps steps = {};
  };
  static constexpr uint16_t kApart = 0xffff;

  // None yet. O(V + F).
  explicit Landmarks(const Mesh& mesh);

  // Those whose step() and rows() were kept, of an equal mesh. More are not
  // chosen. REQUIRES: a row for each vertex; count <= kMost.
  Landmarks(const Mesh& mesh, uint32_t count, double step,
            std::vector<Row> rows);

  // The vertex that is to be the next landmark: as far from all those before as
  // can be, in the part of the mesh that has most vertices. Empty once there
  // are enough.
  std::optional<uint32_t> next() const { return next_; }

  // A landmark: the distances from one vertex to all, in the unit of the file.
  // Distances that differ along an edge by more than its length bound nothing;
  // they are left out, and no more are chosen.
  // REQUIRES: count() < kMost, the mesh is the same, and the distances are
  // certified everywhere. O(V + F).
  void Add(const Mesh& mesh, std::span<const double> distances);

  uint32_t count() const { return count_; }
  // Whether there are `count`, or as many as are chosen.
  bool HasEnough(uint32_t count) const {
    return count_ >= count || !next_.has_value();
  }
  // Its length in the scaled unit; 0 if there is no landmark.
  double step() const { return step_; }
  // By vertex.
  std::span<const Row> rows() const { return rows_; }

  uint64_t bytes() const { return rows_.capacity() * sizeof(Row); }
  // What bytes() will be for a mesh.
  static uint64_t PlannedBytes(const Mesh& mesh);
  // What making them takes beside that: a field, and what it is computed from.
  static uint64_t PlannedMakingBytes(const Mesh& mesh);

  // REQUIRES: the point is one of the mesh. O(landmarks).
  Place PlaceOf(const SurfacePoint& point, const Mesh& mesh) const;

  // No path from vertex v to the place is shorter, in the scaled unit.
  // +infinity if a landmark tells that there is no path. O(landmarks).
  double LowerBound(uint32_t v, const Place& place) const;

 private:
  // The vertex farthest from all landmarks, if one is apart from them.
  std::optional<uint32_t> FarthestVertex() const;
  // Rounds what is kept down to steps twice as long.
  void DoubleStep();

  double scale_;  // from the unit of the file
  uint32_t count_ = 0;
  double step_ = 0;
  std::optional<uint32_t> next_;
  std::vector<Row> rows_;
};

// Adds the fields of up to `count` vertices, each the next(), to none. At most
// Landmarks::kMost. Errors: as Solve.
absl::StatusOr<Landmarks> MakeLandmarks(const Mesh& mesh, uint32_t count,
                                        const SolveOptions& options,
                                        Checkpoint& checkpoint);

}  // namespace geodesic

#endif  // GEODESIC_LANDMARKS_H_
