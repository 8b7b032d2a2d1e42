// What the questions and answers of a server have in common.

#ifndef GEODESIC_CLIENT_ANSWER_H_
#define GEODESIC_CLIENT_ANSWER_H_

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace geodesic::client {

// The exact algorithms this client can name: "fwp-list", "fwp-ch", "fwp-mmp",
// "ich", "mmp", "lc-ch", "lc-mmp", "ch". All give the same distances. A server
// may offer fewer; see Client::GetCapabilities.
std::vector<std::string> AlgorithmNames();

// The approximate ones: "fmm", "fmm-untidy", "heat", "svg", "gtu". No bound on
// their error is known. They give distances between vertices alone, and only
// fields, matrices, nearest members and pairs; docs/questions.md says which to
// choose.
std::vector<std::string> ApproximateAlgorithmNames();
// Whether it is one of ApproximateAlgorithmNames().
bool IsApproximate(std::string_view algorithm);

// Parameters of approximate algorithms. A query sets those that its algorithm
// takes; the server has defaults for the rest. An answer has all that were
// used.
struct Approximation {
  // svg: how many vertices around each one are looked at. DEFAULT: 50.
  std::optional<uint32_t> neighbours;
  // heat: it spreads for lambda times the square of the mean edge length.
  // DEFAULT: 1.
  std::optional<double> lambda;
  // gtu: how many vertices' exact fields are kept. DEFAULT: 200.
  std::optional<uint32_t> samples;

  friend bool operator==(const Approximation&, const Approximation&) = default;
};

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

// Called now and then while the server computes.
using SolveProgressCallback = std::function<void(const SolveProgress&)>;

// Called with how many of the `total` rows, sources, or bytes to send are
// finished.
using CountProgressCallback =
    std::function<void(uint64_t finished, uint64_t total)>;

// What every answer says about itself.
struct AnswerInfo {
  std::string mesh_digest;
  uint64_t vertex_count = 0;
  // What was joined, left out or guessed when the mesh was read, for people.
  std::vector<std::string> mesh_notes = {};
  std::string algorithm;
  // Set if distances are approximate.
  std::optional<Approximation> approximation = {};
  // The relative error of every distance is below this; +infinity if they are
  // approximate.
  double relative_tolerance = 0;
  // Set if the answer was computed within the query's tolerance and is not
  // exact: no distance is farther from the truth than this part of it. At most
  // the tolerance.
  std::optional<double> certified_error = {};
  std::string server_version;
  // Time that the computations took, summed over threads; 0 if nothing had to
  // be computed.
  double compute_seconds = 0;
  uint64_t windows_propagated = 0;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_ANSWER_H_
