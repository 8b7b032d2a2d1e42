// Farthest-point samples as a client asks for and receives them.

#ifndef GEODESIC_CLIENT_SAMPLES_H_
#define GEODESIC_CLIENT_SAMPLES_H_

#include <cstdint>
#include <string>
#include <vector>

#include "geodesic_client/answer.h"
#include "geodesic_client/surface_point.h"

namespace geodesic::client {

struct SampleQuery {
  std::string mesh_digest;
  // At least one: from where the first sample is farthest.
  std::vector<Source> sources;
  // At least 1.
  uint64_t count = 1;
  // As in FieldQuery.
  std::string algorithm;
  Priority priority = Priority::kInteractive;
};

struct FarthestSample {
  uint64_t vertex = 0;
  // From the sources and all earlier samples; +infinity for the first one on a
  // component without any.
  double distance = 0;
};

struct SampleAnswer {
  AnswerInfo info;
  // Vertices of faces. Fewer than asked for when every such vertex is at
  // distance 0 already.
  std::vector<FarthestSample> samples;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_SAMPLES_H_
