// A line on the surface, as answers hold it.

#ifndef GEODESIC_CLIENT_POLYLINE_H_
#define GEODESIC_CLIENT_POLYLINE_H_

#include <vector>

#include "geodesic_client/mesh.h"
#include "geodesic_client/surface_point.h"

namespace geodesic::client {

// Straight from each point to the next, through the inside of one face or along
// one edge.
struct Polyline {
  std::vector<SurfacePoint> points;
  // The same points in space, in the unit of the mesh's file.
  std::vector<Point> positions;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_POLYLINE_H_
