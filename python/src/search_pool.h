// Searches for single targets, kept from one question to the next.

#ifndef GEODESIC_PYTHON_SEARCH_POOL_H_
#define GEODESIC_PYTHON_SEARCH_POOL_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/landmarks.h"
#include "geodesic/mesh.h"
#include "geodesic/target_search.h"
#include "geodesic/valid_query.h"

namespace geodesic::python {

// A search takes O(V + F) to set up, and then what it covers. There are as many
// as ran at once. Thread-safe. The mesh must outlive it.
class SearchPool {
 public:
  explicit SearchPool(const Mesh& mesh) : mesh_(mesh) {}

  // As TargetSearch::Run, with landmarks once there are some.
  absl::StatusOr<TargetDistances> Run(const ValidQuery& query,
                                      Checkpoint& checkpoint);

  // How many searches cost as much as a field.
  size_t FieldInSearches();

  // Makes `count` landmarks if there are fewer. Whoever comes meanwhile
  // searches with what there is. Errors: as geodesic::MakeLandmarks.
  absl::Status MakeLandmarks(uint32_t count, uint32_t threads,
                             Checkpoint& checkpoint);

 private:
  const Mesh& mesh_;
  std::mutex mutex_;
  // Guarded by mutex_:
  std::vector<std::unique_ptr<TargetSearch>> idle_;
  std::shared_ptr<const Landmarks> landmarks_;
  bool are_being_made_ = false;
};

}  // namespace geodesic::python

#endif  // GEODESIC_PYTHON_SEARCH_POOL_H_
