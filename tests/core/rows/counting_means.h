// Means of rows that tell what they were asked for.

#ifndef GEODESIC_TESTS_CORE_ROWS_COUNTING_MEANS_H_
#define GEODESIC_TESTS_CORE_ROWS_COUNTING_MEANS_H_

#include <cstdint>
#include <functional>
#include <map>
#include <memory>

#include "geodesic/rows/kept_searches.h"

namespace geodesic::test {

class CountingMeans final : public KeptSearches {
 public:
  using KeptSearches::KeptSearches;

  absl::StatusOr<bool> MakeLandmarks(uint32_t count,
                                     Checkpoint& checkpoint) override {
    ++makings;
    if (!can_make_landmarks) return false;
    return KeptSearches::MakeLandmarks(count, checkpoint);
  }
  void WantLandmarks() override { ++wishes; }
  absl::Status WithSearch(
      const std::function<absl::Status(TargetSearch&)>& work) override {
    ++loans;
    return KeptSearches::WithSearch(work);
  }
  absl::StatusOr<std::unique_ptr<Computation>> Start(
      const ValidQuery& query) override {
    ++fields;
    return KeptSearches::Start(query);
  }
  std::shared_ptr<const DistanceField> FindWhole(
      const SurfacePoint& source) override {
    return source == kept_source ? kept_field : nullptr;
  }
  void Count(AnsweredBy how, uint64_t pairs) override { counts[how] += pairs; }

  // What there is:
  bool can_make_landmarks = true;
  SurfacePoint kept_source;
  std::shared_ptr<const DistanceField> kept_field;

  // How often it was asked for:
  uint64_t makings = 0;
  uint64_t wishes = 0;
  uint64_t loans = 0;
  uint64_t fields = 0;
  std::map<AnsweredBy, uint64_t> counts;  // of pairs
};

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_CORE_ROWS_COUNTING_MEANS_H_
