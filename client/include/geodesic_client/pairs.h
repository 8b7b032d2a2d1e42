// Distances of pairs of points, as a client asks for them and receives them.

#ifndef GEODESIC_CLIENT_PAIRS_H_
#define GEODESIC_CLIENT_PAIRS_H_

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "geodesic_client/answer.h"
#include "geodesic_client/questions.h"
#include "geodesic_types/places.h"

namespace geodesic::client {

// How far it is from each source to its target.
struct PairQuery {
  std::string mesh_digest;
  // At least one; any number. Those whose points are all vertices travel in an
  // eighth of the bytes.
  std::vector<PointPair> pairs;
  ValueType value_type = ValueType::kFloat64;
  Priority priority = Priority::kInteractive;
  // Whether a shortest path from source to target comes with each distance. The
  // server then searches each pair by itself.
  bool paths = false;
  // One of ApproximateAlgorithmNames(), for pairs of vertices without paths.
  // DEFAULT: empty, exact distances.
  std::string algorithm = {};
  Approximation approximation = {};
  // The largest relative error that distances may have, 0 or from 1e-9 to 0.1.
  // Searches take a part of the time then. DEFAULT: 0, exact, as paths are in
  // any case.
  double tolerance = 0;
};

// Takes the distances of pairs. If `on_distances` returns an error, the call
// ends with it. A slow receiver slows the server down.
struct PairReceiver {
  // Called with the distances of the pairs from number `first` on, in order of
  // the pairs; +infinity where no path leads. The span is valid during the
  // call.
  std::function<absl::Status(uint64_t first, std::span<const double>)>
      on_distances;
  // Called with the path of each pair, in order of the pairs and after its
  // distance, if the query asks for paths; without points where none leads.
  // May be empty otherwise.
  std::function<absl::Status(uint64_t pair, Polyline path)> on_path;
  // Counts pairs. May be empty.
  CountProgressCallback on_progress;
};

// How the pairs were answered.
struct PairSummary {
  // Its figures are the sums, or largest errors, of all calls that it took.
  AnswerInfo info;
  // Answered by a search of their own, by a field that the server computed for
  // several pairs with a common end, and by a field that it had already.
  uint64_t searched = 0;
  uint64_t from_fields = 0;
  uint64_t from_cache = 0;

  // Makes this the summary of one more call, too.
  void Add(const PairSummary& call) {
    const AnswerInfo before = std::exchange(info, call.info);
    info.compute_seconds += before.compute_seconds;
    info.windows_propagated += before.windows_propagated;
    info.relative_tolerance =
        std::max(info.relative_tolerance, before.relative_tolerance);
    info.certified_error =
        std::max(info.certified_error, before.certified_error);
    searched += call.searched;
    from_fields += call.from_fields;
    from_cache += call.from_cache;
  }
};

// The distances of all pairs.
struct PairAnswer {
  PairSummary summary;
  std::vector<double> distances;  // one per pair
  std::vector<Polyline> paths;    // one per pair, if they were asked for
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PAIRS_H_
