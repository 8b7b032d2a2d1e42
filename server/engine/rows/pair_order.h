// Brings the distances of rows, which hold pairs from anywhere, into the order
// of the pairs.

#ifndef GEODESIC_SERVER_ENGINE_ROWS_PAIR_ORDER_H_
#define GEODESIC_SERVER_ENGINE_ROWS_PAIR_ORDER_H_

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
  void Add(const AnswerRow& row) {
    for (size_t i = 0; i < row.values.size(); ++i) {
      distances_[row.columns[i]] = row.values[i];
    }
    while (known_ < distances_.size() && !std::isnan(distances_[known_])) {
      ++known_;
    }
  }

  // The distances of the first pairs, up to one that is not known yet.
  std::span<const double> known() const {
    return std::span(distances_).first(known_);
  }
  bool is_whole() const { return known_ == distances_.size(); }

 private:
  std::vector<double> distances_;  // NaN until it is known
  uint64_t known_ = 0;             // all before it
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_ROWS_PAIR_ORDER_H_
