// What a running computation asks of Python now and then.

#ifndef GEODESIC_PYTHON_WATCH_H_
#define GEODESIC_PYTHON_WATCH_H_

#include <pybind11/pybind11.h>

#include <chrono>
#include <cstdint>
#include <exception>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "status.h"

namespace geodesic::python {

// Lets Ctrl-C stop a computation, and reports its progress. It takes the
// interpreter's lock for that, at most every kInterval and only if there is
// something to ask: threads other than Python's main thread receive no signals.
//
// For one computation. Run() is called with the interpreter's lock, everything
// else without it.
class Watch final : public Checkpoint {
 public:
  // Ctrl-C has to stop a computation within 100 ms; the solver polls every few
  // milliseconds, and another thread may keep the lock for 5 ms.
  static constexpr std::chrono::milliseconds kInterval{20};

  // `progress` is None or is called as progress(done, total).
  explicit Watch(pybind11::object progress);

  // Calls work() without the interpreter's lock and returns its value.
  // Throws: what Python raised meanwhile; the work's error.
  template <typename Work>
  auto Run(Work work) {
    auto result = [&] {
      const pybind11::gil_scoped_release unlocked;
      return work();
    }();
    if (error_ != nullptr) std::rethrow_exception(error_);
    return ValueOrThrow(std::move(result));
  }

  absl::Status Poll(const Progress& progress) override {
    return Report(progress.vertices_reached, progress.vertices);
  }

  // For work with the interpreter's lock, such as making many objects: throws
  // what Ctrl-C raises.
  static void CheckSignals();

  // CANCELLED once Python has raised an exception, which Run() rethrows.
  absl::Status Report(uint64_t done, uint64_t total);

 private:
  absl::Status Ask(uint64_t done, uint64_t total);

  const pybind11::object progress_;
  const bool has_progress_;
  const bool asks_;
  std::chrono::steady_clock::time_point next_;  // at first: at once
  std::exception_ptr error_;
};

}  // namespace geodesic::python

#endif  // GEODESIC_PYTHON_WATCH_H_
