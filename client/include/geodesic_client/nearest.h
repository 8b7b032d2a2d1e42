// The nearest members of a set, as a client asks for and receives them.

#ifndef GEODESIC_CLIENT_NEAREST_H_
#define GEODESIC_CLIENT_NEAREST_H_

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geodesic_client/answer.h"
#include "geodesic_client/surface_point.h"

namespace geodesic::client {

struct NearestQuery {
  std::string mesh_digest;
  // At least one; each is asked on its own.
  std::vector<Source> sources;
  // The set; at least one.
  std::vector<SurfacePoint> targets;
  // How many to find for each source; at least 1.
  uint64_t count = 1;
  // As in FieldQuery.
  std::string algorithm;
  // Targets farther than this are not found. DEFAULT: no limit.
  std::optional<double> radius;
  Priority priority = Priority::kInteractive;
};

struct NearestTarget {
  // Its number in the query.
  uint64_t target = 0;
  double distance = 0;

  friend bool operator==(const NearestTarget&, const NearestTarget&) = default;
};

struct NearestAnswer {
  AnswerInfo info;
  // For each source, in order of distance (of number at a tie); fewer than
  // asked for where no more can be reached.
  std::vector<std::vector<NearestTarget>> found;
};

// Called with the sources done so far and those there are.
using NearestProgressCallback =
    std::function<void(uint64_t finished, uint64_t sources)>;

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_NEAREST_H_
