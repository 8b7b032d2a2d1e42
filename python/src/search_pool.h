// Searches for single targets, kept from one question to the next.

#ifndef GEODESIC_PYTHON_SEARCH_POOL_H_
#define GEODESIC_PYTHON_SEARCH_POOL_H_

#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/mesh.h"
#include "geodesic/target_search.h"
#include "geodesic/valid_query.h"

namespace geodesic::python {

// From so many targets of one source on, a field that stops at the last of them
// is cheaper than a search for each (docs/questions.md, pairs).
inline constexpr size_t kTargetsWorthAField = 12;

// A search takes O(V + F) to set up, and then what it covers. There are as many
// as ran at once. Thread-safe. The mesh must outlive it.
class SearchPool {
 public:
  explicit SearchPool(const Mesh& mesh) : mesh_(mesh) {}

  // As TargetSearch::Run, without landmarks.
  absl::StatusOr<TargetDistances> Run(const ValidQuery& query,
                                      Checkpoint& checkpoint) {
    std::unique_ptr<TargetSearch> search = Take();
    absl::StatusOr<TargetDistances> found =
        search->Run(query, nullptr, checkpoint);
    const std::scoped_lock lock(mutex_);
    idle_.push_back(std::move(search));
    return found;
  }

 private:
  std::unique_ptr<TargetSearch> Take() {
    {
      const std::scoped_lock lock(mutex_);
      if (!idle_.empty()) {
        std::unique_ptr<TargetSearch> search = std::move(idle_.back());
        idle_.pop_back();
        return search;
      }
    }
    return std::make_unique<TargetSearch>(mesh_);
  }

  const Mesh& mesh_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<TargetSearch>> idle_;  // guarded by mutex_
};

}  // namespace geodesic::python

#endif  // GEODESIC_PYTHON_SEARCH_POOL_H_
