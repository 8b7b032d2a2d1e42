// Exact distances to a few targets, by a search that is directed at them.
//
//   TargetSearch search(*mesh);
//   absl::StatusOr<TargetDistances> found =
//       search.Run(query, landmarks, checkpoint);
//
// Every window has a key: its label plus a lower bound on the rest of the way,
// by the straight line through space and by what landmarks tell. A path that is
// close to shortest is looked for first. If there is one, windows with larger
// keys are dropped and the others are propagated in the order of their labels;
// otherwise they go in the order of their keys. Any order is exact (Xu et al.
// 2015, Proposition 1). No bound decreases along a path by more than the path's
// length, so the least key still pending bounds every path that was not found
// yet; a target's distance is final once it is no larger.

#ifndef GEODESIC_TARGET_SEARCH_H_
#define GEODESIC_TARGET_SEARCH_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/distance_field.h"
#include "geodesic/landmarks.h"
#include "geodesic/mesh.h"
#include "geodesic/path.h"
#include "geodesic/valid_query.h"
#include "geodesic_types/algorithms.h"

namespace geodesic {

// A field costs about as much as so many searches directed at one target, on
// meshes of 10^4 to 10^6 faces and pairs drawn at random (docs/benchmarks.md,
// "Two places").
inline constexpr size_t kFieldInSearches = 12;

// With so many landmarks, at the least: 16 of them make it 40 to 60, 64 make it
// 70 to 90.
constexpr size_t FieldInSearches(uint32_t landmarks) {
  return kFieldInSearches + landmarks;
}

// A search that is not directed is a field itself.
inline constexpr size_t kFieldInUndirectedSearches = 2;

// How many landmarks are worth their fields if so many searches follow: the
// first few break even at about 400 searches, the last at some 4,000.
constexpr uint32_t LandmarksWorth(size_t searches) {
  constexpr size_t kLeastSearches = 1000;
  constexpr size_t kSearchesPerLandmark = 100;
  if (searches < kLeastSearches) return 0;
  return static_cast<uint32_t>(
      std::min<size_t>(searches / kSearchesPerLandmark, Landmarks::kMost));
}

// The answer of a search.
struct TargetDistances {
  // One per target of the query, in the unit of the file; +infinity where no
  // path leads. As exact as those of Solve (solve.h); with a tolerance, the
  // lengths of paths that are longer by this part of the shortest at the most.
  std::vector<double> distances;
  // 0 if all are exact.
  double certified_error = 0;
  // One per target, if the query asked for a trace. As those of PathTracer.
  std::vector<GeodesicPath> paths;
  SolveStatistics statistics;
};

// Keeps its memory from one search to the next, so that a search costs what it
// covers, not what the mesh has. Not thread-safe: one for each thread.
class TargetSearch {
 public:
  // O(V + F) time and memory. The mesh must outlive it.
  explicit TargetSearch(const Mesh& mesh);
  TargetSearch(TargetSearch&&) noexcept;
  TargetSearch& operator=(TargetSearch&&) noexcept;
  ~TargetSearch();

  // The distances of query->targets, each by a search of its own. `landmarks`
  // may be null, or of any number; they change the cost alone, and with a
  // tolerance which answer within it is found. Questions that
  // fwp-list does not answer (curves, faces without area: see ValidQuery) are
  // computed as a field that stops at the last target, at the cost of that. So
  // is a path that cannot be followed back through what a search has found, and
  // a target for which windows go round needles too often.
  // Errors: INVALID_ARGUMENT without targets; whatever `checkpoint` returns.
  absl::StatusOr<TargetDistances> Run(const ValidQuery& query,
                                      const Landmarks* landmarks,
                                      Checkpoint& checkpoint);

  // Whether searches with this algorithm, the one that runs, are directed.
  static bool IsDirected(Algorithm algorithm) {
    return algorithm == Algorithm::kFwpList;
  }

  // Bytes held beside the mesh between searches, and at the start of one.
  uint64_t bytes() const;
  // Bytes to reserve before a search for this query starts.
  static uint64_t PlannedBytes(const Mesh& mesh, const ValidQuery& query);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

// From so many searches on a field costs less, with the algorithm that runs and
// these landmarks, which may be null.
inline size_t FieldInSearches(Algorithm algorithm, const Landmarks* landmarks) {
  if (!TargetSearch::IsDirected(algorithm)) return kFieldInUndirectedSearches;
  return FieldInSearches(landmarks == nullptr ? 0 : landmarks->count());
}

}  // namespace geodesic

#endif  // GEODESIC_TARGET_SEARCH_H_
