// Directions around a point of the surface, by angle.
//
// Around the point lie sectors, each a corner, a half or the whole of a face; a
// sector begins at a half-edge that leaves the point or runs along it. Angles
// grow counterclockwise seen from outside. At a vertex inside the surface they
// are scaled so that a full turn measures 2 pi (Polthier and Schmies,
// "Straightest geodesics on polyhedral surfaces", 1998).

#ifndef GEODESIC_SURFACE_COMPASS_H_
#define GEODESIC_SURFACE_COMPASS_H_

#include <cstdint>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "absl/functional/function_ref.h"
#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"
#include "surface/plane_point.h"

namespace geodesic {

// A place in a face and a direction from there, a unit vector.
struct Heading {
  HalfEdge half_edge = kNoHalfEdge;  // in whose frame they are
  PlanePoint place;
  PlanePoint direction;
};

// The angle of the face's corner at the start of h.
double AngleAt(const Mesh& mesh, HalfEdge h);

// Refers to the mesh. Thread-safe.
class Compass {
 public:
  // Asked for each face, once or twice, whether to go on.
  using GoesOn = absl::FunctionRef<bool()>;

  // O(faces around the point). Errors: INVALID_ARGUMENT: the surface around it
  // is not one oriented disk or half-disk; CANCELLED: it does not go on.
  static absl::StatusOr<Compass> At(const Mesh& mesh, const SurfacePoint& point,
                                    GoesOn goes_on);

  // The unit vector in space of angle 0. At a vertex it runs along the first
  // half-edge of Mesh::Outgoing, at an edge point along the edge from the lower
  // vertex number to the higher, and in a face from corner 0 to corner 1.
  const Point& zero_direction() const { return zero_direction_; }

  // The angle of a direction in the frame of h; NaN if its face does not lie
  // around the point.
  double AngleOf(HalfEdge h, const PlanePoint& direction) const;
  // The angle of the edge to vertex v. REQUIRES: the point is a vertex.
  double AngleTowards(uint32_t v) const;

  // The way at an angle. O(log faces). Errors: INVALID_ARGUMENT: it leads out
  // of the surface, or is not finite.
  absl::StatusOr<Heading> At(double angle) const;
  // The way that makes the least angle with a vector in space. O(faces).
  // Errors: INVALID_ARGUMENT: none makes less than a right angle; CANCELLED.
  absl::StatusOr<Heading> Along(const Point& vector, GoesOn goes_on) const;

 private:
  struct Sector {
    HalfEdge half_edge;
    double begin;
    double width;
  };

  explicit Compass(const Mesh& mesh) : mesh_(mesh) {}

  void Add(const Sector& sector);
  absl::Status GoAround(uint32_t vertex, GoesOn goes_on);
  // `within`: from where the sector begins, unscaled.
  Heading In(const Sector& sector, double within) const;

  const Mesh& mesh_;
  std::vector<Sector> sectors_;                    // by angle
  absl::flat_hash_map<uint32_t, Sector> of_face_;  // by h / 3 of their faces
  // Of a vertex, where its edges begin, by their other ends.
  absl::flat_hash_map<uint32_t, double> spokes_;
  SurfacePoint point_;
  Point zero_direction_{};
  double scale_ = 1;
};

}  // namespace geodesic

#endif  // GEODESIC_SURFACE_COMPASS_H_
