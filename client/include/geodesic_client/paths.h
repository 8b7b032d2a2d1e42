// Shortest paths as a client asks for and receives them.

#ifndef GEODESIC_CLIENT_PATHS_H_
#define GEODESIC_CLIENT_PATHS_H_

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "geodesic_client/answer.h"
#include "geodesic_client/polyline.h"
#include "geodesic_client/surface_point.h"

namespace geodesic::client {

struct PathQuery {
  std::string mesh_digest;
  // At least one of each; a path leads to each target from the source nearest
  // to it.
  std::vector<Source> sources;
  std::vector<SurfacePoint> targets;
  // As in FieldQuery.
  std::string algorithm;
  // Targets farther than this count as not reached. DEFAULT: no limit.
  std::optional<double> radius;
  Priority priority = Priority::kInteractive;
};

struct GeodesicPath {
  // Number of the source where the path starts; nothing if there is no path.
  std::optional<uint64_t> source;
  // The source's offset and `length` together.
  double distance = std::numeric_limits<double>::infinity();
  double length = std::numeric_limits<double>::infinity();
  // From the source to the target: it crosses edges straight, and bends only at
  // saddle and boundary vertices. One point if they coincide, none if there is
  // no path.
  Polyline line;
};

struct PathAnswer {
  AnswerInfo info;
  std::vector<GeodesicPath> paths;  // one per target
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PATHS_H_
