// What the questions and answers of a server have in common.

#ifndef GEODESIC_CLIENT_ANSWER_H_
#define GEODESIC_CLIENT_ANSWER_H_

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace geodesic::client {

// The algorithms this client can name: "fwp-ch", "fwp-mmp", "ich", "mmp",
// "ch", "lc-mmp", "lc-ch", "fwp-list". All give the same distances. A server
// may offer fewer; see Client::GetCapabilities.
std::vector<std::string> AlgorithmNames();

// How real numbers travel. The client gets doubles in either case.
enum class ValueType {
  kFloat64,
  kFloat32,  // Half the bytes; each value is the nearest float.
};

// How urgent an answer is.
enum class Priority {
  kInteractive,  // Somebody waits for it.
  kBatch,        // Others' questions may go first.
};

// How far a running computation has come.
struct SolveProgress {
  // Distances up to here are final. 0 while the job waits for a thread.
  double settled_radius = 0;
  uint64_t vertices_reached = 0;
  uint64_t vertex_count = 0;
  uint64_t live_windows = 0;
  uint64_t windows_propagated = 0;
};

using SolveProgressCallback = std::function<void(const SolveProgress&)>;

// Called with how many of the `total` rows, sources, or bytes to send are
// finished.
using CountProgressCallback =
    std::function<void(uint64_t finished, uint64_t total)>;

// What every answer says about itself. A Field has such members of its own.
struct AnswerInfo {
  std::string mesh_digest;
  uint64_t vertex_count = 0;
  std::string algorithm;
  // The relative error of every distance is below this.
  double relative_tolerance = 0;
  std::string server_version;
  // Time that the computations took, summed over threads; 0 if nothing had to
  // be computed.
  double compute_seconds = 0;
  uint64_t windows_propagated = 0;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_ANSWER_H_
