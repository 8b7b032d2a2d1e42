// Distance fields as a client asks for and receives them.

#ifndef GEODESIC_CLIENT_FIELD_H_
#define GEODESIC_CLIENT_FIELD_H_

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geodesic_client/answer.h"
#include "geodesic_types/places.h"

namespace geodesic::client {

// Whoever asks a server need not name two namespaces.
using geodesic::Curve;
using geodesic::EdgePoint;
using geodesic::FacePoint;
using geodesic::Source;
using geodesic::SurfacePoint;
using geodesic::VertexPoint;

// A question for the distances of all vertices.
struct FieldQuery {
  // The mesh's digest, 64 hexadecimal digits.
  std::string mesh_digest;
  // At least one. d(x) = min over the sources of offset + distance to x.
  std::vector<Source> sources;
  // One of AlgorithmNames(), or of ApproximateAlgorithmNames(): then targets
  // are vertices, and neither curves, nearest sources, gradients nor a limit by
  // targets are to be had. DEFAULT: empty, the server's choice.
  std::string algorithm = {};
  Approximation approximation = {};
  // The largest relative error that distances may have: 0, or from 1e-9 to 0.1.
  // A field is then found faster, and certifies its error; an exact one that
  // the server has may answer, too. Takes no algorithm but "fwp-list", no
  // nearest sources, no gradients, and is not streamed. DEFAULT: 0, exact.
  double tolerance = 0;
  // Points beside the vertices whose distances are wanted.
  std::vector<SurfacePoint> targets = {};
  // The search ends here; distances beyond are +infinity. DEFAULT: no limit.
  std::optional<double> radius = {};
  // The search ends once this many targets are final; distances that are not
  // final by then are +infinity. DEFAULT: no limit.
  std::optional<uint64_t> stop_after_targets = {};
  // What to send beside the distances.
  bool nearest_sources = false;
  bool gradients = false;
  bool certified_errors = false;
  ValueType value_type = ValueType::kFloat64;
  Priority priority = Priority::kInteractive;
};

// Where a field came from.
enum class FieldOrigin {
  kComputed,  // Computed for this request.
  kJoined,    // Another request had started the computation.
  kCached,    // Taken from the server's cache.
};

// "computed", "joined" or "cached".
std::string_view FieldOriginName(FieldOrigin origin);

// Figures of merit of the computation (of the first one, for a cached field).
struct FieldStatistics {
  uint64_t iterations = 0;
  uint64_t windows_created = 0;
  uint64_t windows_propagated = 0;
  uint64_t peak_wavefront = 0;
  double mean_wavefront = 0;
  uint64_t peak_windows = 0;
  uint64_t peak_solver_bytes = 0;
  double solve_seconds = 0;
};

// Distances of all vertices, and what they are.
struct Field : AnswerInfo {
  // One value per vertex, in the mesh's vertex order; +infinity where no path
  // leads or the search did not get. Empty if the field was streamed.
  std::vector<double> distances;
  // One value per target of the query.
  std::vector<double> target_distances;
  // If asked for: the number of the source nearest to each vertex, or one of
  // them at a tie; kNoSource where the distance is infinite.
  std::vector<uint32_t> nearest_sources;
  // If asked for: the unit vector along which the shortest path arrives at each
  // vertex; zero at sources and where the distance is infinite.
  std::vector<std::array<double, 3>> gradients;
  // If asked for: the relative error that each vertex's distance is certified
  // not to exceed; 0 where it is exact or infinite.
  std::vector<float> certified_errors;
  // Every distance up to here is present, and exact or within the tolerance e
  // (then it is every true distance up to this / (1 + e)). Those beyond may be
  // +infinity. 0 if distances are approximate.
  double settled_radius = std::numeric_limits<double>::infinity();
  FieldOrigin origin = FieldOrigin::kComputed;
  FieldStatistics statistics;
};

// A vertex whose distance has become final.
struct SettledVertex {
  uint32_t vertex = 0;
  double distance = 0;
};

// Called with vertices ordered by distance and at a tie by number, each once.
using SettledCallback = std::function<void(std::span<const SettledVertex>)>;

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_FIELD_H_
