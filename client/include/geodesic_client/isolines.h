// Lines of equal distance as a client asks for and receives them.

#ifndef GEODESIC_CLIENT_ISOLINES_H_
#define GEODESIC_CLIENT_ISOLINES_H_

#include <string>
#include <vector>

#include "geodesic_client/answer.h"
#include "geodesic_client/polyline.h"
#include "geodesic_client/surface_point.h"

namespace geodesic::client {

struct IsolineQuery {
  std::string mesh_digest;
  // At least one.
  std::vector<Source> sources;
  // Distances; at least one, each finite and above 0. In any order; equal ones
  // count once.
  std::vector<double> levels;
  // As in FieldQuery.
  std::string algorithm;
  Priority priority = Priority::kInteractive;
};

struct Isoline {
  double level = 0;
  // Whether the last point leads back to the first; open ones end at a
  // boundary.
  bool is_closed = false;
  // Its points are exact crossings of edges. Between them the isoline is made
  // of circular arcs, which the polyline cuts short.
  Polyline line;
};

struct IsolineAnswer {
  AnswerInfo info;
  // In order of level.
  std::vector<Isoline> isolines;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_ISOLINES_H_
