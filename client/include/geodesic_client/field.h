// Distance fields as a client asks for and receives them.

#ifndef GEODESIC_CLIENT_FIELD_H_
#define GEODESIC_CLIENT_FIELD_H_

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace geodesic::client {

// A vertex from which distances are measured.
struct Source {
  // 0-based.
  uint64_t vertex = 0;
  // Distance the source starts with, in the unit of the mesh; >= 0.
  double offset = 0;
};

struct FieldQuery {
  // The mesh's digest, 64 hexadecimal digits.
  std::string mesh_digest;
  // At least one. d(x) = min over the sources of offset + distance to x.
  std::vector<Source> sources;
  // One of AlgorithmNames(). DEFAULT: empty, the server's choice.
  std::string algorithm;
};

// The algorithms this client can name: "fwp-ch", "fwp-mmp", "ich", "mmp",
// "ch", "lc-mmp", "lc-ch". A server may offer fewer; see
// Client::GetCapabilities.
std::vector<std::string> AlgorithmNames();

// Where a field came from.
enum class FieldOrigin {
  kSolved,  // Computed for this request.
  kJoined,  // Another request had started the computation.
  kCached,  // Taken from the server's cache.
};

// "solved", "joined" or "cached".
std::string_view FieldOriginName(FieldOrigin origin);

// How far a running computation has come.
struct FieldProgress {
  // Distances up to here are final. 0 while the job waits for a thread.
  double settled_radius = 0;
  uint64_t vertices_reached = 0;
  uint64_t vertex_count = 0;
  uint64_t live_windows = 0;
  uint64_t windows_propagated = 0;
};

using FieldProgressCallback = std::function<void(const FieldProgress&)>;

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

struct Field {
  std::string mesh_digest;
  // The algorithm that computed the field.
  std::string algorithm;
  // One value per vertex, in the mesh's vertex order; +infinity where no path
  // leads.
  std::vector<double> distances;
  FieldOrigin origin = FieldOrigin::kSolved;
  FieldStatistics statistics;
  // Relative error every distance stays below.
  double relative_tolerance = 0;
  // Version of the program that computed the field.
  std::string server_version;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_FIELD_H_
