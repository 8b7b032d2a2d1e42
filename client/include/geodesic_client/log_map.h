// The log map: the surface around a point laid into the plane by direction and
// distance.

#ifndef GEODESIC_CLIENT_LOG_MAP_H_
#define GEODESIC_CLIENT_LOG_MAP_H_

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geodesic_client/answer.h"
#include "geodesic_client/mesh.h"
#include "geodesic_client/surface_point.h"

namespace geodesic::client {

struct LogMapQuery {
  std::string mesh_digest;
  SurfacePoint source;
  // As in FieldQuery.
  std::string algorithm;
  ValueType value_type = ValueType::kFloat64;
  // The map ends here. DEFAULT: no limit.
  std::optional<double> radius;
  Priority priority = Priority::kInteractive;
};

struct LogMap {
  AnswerInfo info;
  // Per vertex: distance times (cos, sin) of the angle at which the shortest
  // path leaves the source. NaN where no path leads or the map ended before.
  std::vector<std::array<double, 2>> coordinates;
  // Unit vector in space of angle 0. Angles grow counterclockwise seen from
  // outside; at a vertex they are scaled so that a full turn measures 2 pi.
  Point zero_direction{};
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_LOG_MAP_H_
