// Joins the edges at which a file keeps faces apart that belong together:
// programs repeat vertices where a texture, a normal or a colour changes.
//
//   absl::Status status = JoinSeams({}, soup);   // what lies on each other
//   status = JoinSeams({.kind = Welding::Kind::kWithin, .distance = 1e-3},
//   soup);
//
// Boundary edges alone are joined, by both their ends: parts that touch in a
// point or cross stay apart.

#ifndef GEODESIC_JOIN_SEAMS_H_
#define GEODESIC_JOIN_SEAMS_H_

#include <compare>
#include <cstdint>

#include "absl/status/status.h"
#include "geodesic/checkpoint.h"
#include "geodesic/triangle_soup.h"

namespace geodesic {

// Which boundary edges are joined.
struct Welding {
  enum class Kind : uint8_t {
    // Whose ends are equal within the rounding of the coordinates: a unit of
    // the last digit that they are written with, in binary or in decimal, and
    // what computing the same place twice may add.
    kSeams,
    kNone,
    // Those too whose ends lie within `distance`; 0: whose ends are equal.
    kWithin,
  };

  Kind kind = Kind::kSeams;
  // In the unit of the coordinates. kWithin only.
  double distance = 0;

  friend auto operator<=>(const Welding&, const Welding&) = default;
};

// Errors: INVALID_ARGUMENT for a distance that is negative or not finite.
absl::Status Validate(const Welding& welding);

// Joins edges of the soup: soup.reading says which vertices become the least of
// those at their place. Edges inside a sheet stay apart, though both ends be
// joined to those of another one. An edge is joined to others of other faces
// that are at least eight times as long as their ends are apart (twice, where a
// distance is given), so no face with a size collapses by itself; a side
// without length becomes the corner where it lies. Does nothing to a soup whose
// triangles name vertices that are not there.
// O(V + F), and O(B log B) with B boundary edges of which few are close to each
// other; reads each boundary edge's surroundings only. Tells the checkpoint of
// its bytes and the soup's (Progress::solver_bytes) before it takes them.
// Errors: those of Validate; whatever `checkpoint` returns.
absl::Status JoinSeams(const Welding& welding, TriangleSoup& soup,
                       Checkpoint& checkpoint);
absl::Status JoinSeams(const Welding& welding, TriangleSoup& soup);

}  // namespace geodesic

#endif  // GEODESIC_JOIN_SEAMS_H_
