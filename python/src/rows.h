// Many computations on one mesh, on several threads.

#ifndef GEODESIC_PYTHON_ROWS_H_
#define GEODESIC_PYTHON_ROWS_H_

#include <cstdint>
#include <functional>

#include "absl/status/status.h"
#include "geodesic/checkpoint.h"
#include "watch.h"

namespace geodesic::python {

// Calls row(i, checkpoint) for every i < count, in order of their beginning, on
// `threads` threads of its own. Meanwhile the calling thread reports to `watch`
// how many have ended; it holds no lock of Python. Errors: that of the first
// row that fails, or CANCELLED by `watch`. No row begins after that, and those
// that run are stopped.
absl::Status RunRows(
    uint64_t count, uint32_t threads, Watch& watch,
    const std::function<absl::Status(uint64_t row, Checkpoint& checkpoint)>&
        row);

// Tells `watch`, while a row is computed, how many of all have ended.
class RowsEnded final : public Checkpoint {
 public:
  RowsEnded(uint64_t ended, uint64_t all, Watch& watch)
      : ended_(ended), all_(all), watch_(watch) {}

  absl::Status Poll(const Progress&) override {
    return watch_.Report(ended_, all_);
  }

 private:
  const uint64_t ended_, all_;
  Watch& watch_;
};

}  // namespace geodesic::python

#endif  // GEODESIC_PYTHON_ROWS_H_
