// Brings the distances of rows, which hold pairs from anywhere, into the order
// of the pairs.

#ifndef GEODESIC_SERVER_ENGINE_PAIRS_PAIR_ORDER_H_
#define GEODESIC_SERVER_ENGINE_PAIRS_PAIR_ORDER_H_

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "server/engine/jobs/row_pipeline.h"

namespace geodesic::server {

// Not thread-safe.
class PairOrder {
 public:
  explicit PairOrder(uint64_t pairs)
      : distances_(pairs, std::numeric_limits<double>::quiet_NaN()) {}

  // The row's columns are numbers of pairs.
  void Add(const MatrixRow& row) {
    for (size_t i = 0; i < row.values.size(); ++i) {
      distances_[row.columns[i]] = row.values[i];
    }
    while (known_ < distances_.size() && !std::isnan(distances_[known_])) {
      ++known_;
    }
  }

  // Pairs whose distances were taken, all before the others.
  uint64_t taken() const { return taken_; }
  // Whether the next distance to take is known.
  bool has_next() const { return taken_ < known_; }
  bool is_finished() const { return taken_ == distances_.size(); }

  // The next distances that are known without a gap, `most` of them or fewer.
  std::span<const double> Take(uint64_t most) {
    const uint64_t count = std::min(most, known_ - taken_);
    const uint64_t first = taken_;
    taken_ += count;
    return std::span(distances_).subspan(first, count);
  }

 private:
  std::vector<double> distances_;  // NaN until it is known
  uint64_t known_ = 0;             // all before it
  uint64_t taken_ = 0;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_PAIRS_PAIR_ORDER_H_
