// Places as people write them (client/output/place_text.h). Some have to be
// looked for on the mesh before a server can be asked about them.

#ifndef GEODESIC_CLIENT_PLACES_WRITTEN_PLACE_H_
#define GEODESIC_CLIENT_PLACES_WRITTEN_PLACE_H_

#include <cstddef>
#include <variant>
#include <vector>

#include "geodesic_client/mesh.h"
#include "geodesic_types/places.h"

namespace geodesic::client {

// The point of the surface that is nearest to a point in space.
struct NearestPoint {
  Point to = {};  // finite

  friend auto operator<=>(const NearestPoint&, const NearestPoint&) = default;
};

// The vertex with the least or the greatest coordinate.
struct ExtremeVertex {
  size_t axis = 0;  // x, y or z: 0, 1 or 2
  bool is_greatest = false;

  friend auto operator<=>(const ExtremeVertex&, const ExtremeVertex&) = default;
};

using WrittenPoint = std::variant<VertexPoint, EdgePoint, FacePoint,
                                  NearestPoint, ExtremeVertex>;

struct WrittenSource {
  std::vector<WrittenPoint> points;  // one, or those of a curve
  bool is_curve = false;
  double offset = 0;

  friend bool operator==(const WrittenSource&, const WrittenSource&) = default;
};

struct WrittenPair {
  WrittenPoint source;
  WrittenPoint target;

  friend bool operator==(const WrittenPair&, const WrittenPair&) = default;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PLACES_WRITTEN_PLACE_H_
