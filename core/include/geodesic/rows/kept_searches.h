// Searches and landmarks of a mesh, kept from one question to the next: the
// means of rows (rows.h) for those who have nothing else.
//
//   KeptSearches searches(*mesh);
//   auto question = PairQuestion::Make(*mesh, pairs, {}, searches, 1);

#ifndef GEODESIC_ROWS_KEPT_SEARCHES_H_
#define GEODESIC_ROWS_KEPT_SEARCHES_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/landmarks.h"
#include "geodesic/mesh.h"
#include "geodesic/rows/rows.h"
#include "geodesic/solve_options.h"
#include "geodesic/target_search.h"

namespace geodesic {

// A search takes O(V + F) to set up, and then what it covers. There are as many
// as ran at once. Thread-safe. Has no threads of its own, but those that
// `options` ask for.
class KeptSearches : public RowMeans {
 public:
  // The options are those of the fields that rows start. The mesh must outlive
  // it.
  explicit KeptSearches(const Mesh& mesh, const SolveOptions& options = {})
      : mesh_(mesh), options_(options) {}

  std::shared_ptr<const Landmarks> landmarks() override;
  // Whoever comes while they are made does without.
  absl::StatusOr<bool> MakeLandmarks(uint32_t count,
                                     Checkpoint& checkpoint) override {
    return MakeLandmarks(count, options_, checkpoint);
  }
  absl::Status WithSearch(
      const std::function<absl::Status(TargetSearch&)>& work) override;
  absl::StatusOr<std::unique_ptr<Computation>> Start(
      const ValidQuery& query) override;

  // The same with other options, such as the threads that have nothing to do
  // before the first row.
  absl::StatusOr<bool> MakeLandmarks(uint32_t count,
                                     const SolveOptions& options,
                                     Checkpoint& checkpoint);

 private:
  const Mesh& mesh_;
  const SolveOptions options_;
  std::mutex mutex_;
  // Guarded by mutex_:
  std::vector<TargetSearch> idle_;
  std::shared_ptr<const Landmarks> landmarks_;
  bool are_being_made_ = false;
};

}  // namespace geodesic

#endif  // GEODESIC_ROWS_KEPT_SEARCHES_H_
