// Shortest paths, from a field that was solved with a trace.

#ifndef GEODESIC_PATH_H_
#define GEODESIC_PATH_H_

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"
#include "geodesic/valid_query.h"

namespace geodesic {

// A shortest path as points of the surface. It runs straight from each point to
// the next, through the inside of one face or along one edge. Its inner points
// lie at vertices and on edges, which it crosses straight.
struct GeodesicPath {
  // From the source to the target; one point if they coincide, none if the
  // target is not reached.
  std::vector<SurfacePoint> points;
  // The same points in space, in the unit of the mesh's file.
  std::vector<Point> positions;
  // The distance at the target: the field's own bits. +infinity if there is no
  // path.
  double distance = 0;
  // The distance without the source's offset. The lengths of the pieces sum to
  // it within 1e-10 relative and the rounding of coordinates.
  double length = 0;
  // The number of the source where the path starts.
  uint32_t source = 0;
};

// What paths take in memory. O(paths).
uint64_t BytesOf(std::span<const GeodesicPath> paths);

class TracedField;
struct PathEnd;

// Traces any number of paths of one field. Thread-safe.
//
//   absl::StatusOr<PathTracer> tracer = PathTracer::Create(mesh, query, field);
//   absl::StatusOr<GeodesicPath> path = tracer->ToVertex(42);
class PathTracer {
 public:
  // `query` is the one that `field` was solved for. Mesh and field must outlive
  // the tracer. O(V + sources).
  // Errors: INVALID_ARGUMENT for a field without trace, or of another size.
  static absl::StatusOr<PathTracer> Create(const Mesh& mesh,
                                           const ValidQuery& query,
                                           const DistanceField& field);
  PathTracer(PathTracer&&) noexcept;
  PathTracer& operator=(PathTracer&&) noexcept;
  ~PathTracer();

  // The path to a vertex, or to target number `target` of the query. O(edges
  // crossed + faces at those of several). Polls the checkpoint at least every
  // few thousand of these.
  // Errors: INVALID_ARGUMENT: vertex or target out of range; INTERNAL: the
  // trace does not lead back to a source (a defect); the checkpoint's.
  absl::StatusOr<GeodesicPath> ToVertex(uint32_t vertex,
                                        Checkpoint& checkpoint) const;
  absl::StatusOr<GeodesicPath> ToTarget(uint32_t target,
                                        Checkpoint& checkpoint) const;
  absl::StatusOr<GeodesicPath> ToVertex(uint32_t vertex) const;
  absl::StatusOr<GeodesicPath> ToTarget(uint32_t target) const;

 private:
  PathTracer(std::unique_ptr<const TracedField> field,
             const Progress& progress);
  absl::StatusOr<GeodesicPath> Trace(const PathEnd& end, double distance,
                                     Checkpoint& checkpoint) const;

  std::unique_ptr<const TracedField> field_;
  Progress progress_;  // of the field: all of it is there
};

}  // namespace geodesic

#endif  // GEODESIC_PATH_H_
