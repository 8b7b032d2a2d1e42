#include "watch.h"

#include <utility>

namespace geodesic::python {
namespace {

namespace py = pybind11;

bool IsMainThread() {
  const py::object main =
      py::module_::import("threading").attr("main_thread")();
  return main.attr("ident").cast<unsigned long>() ==
         PyThread_get_thread_ident();
}

}  // namespace

Watch::Watch(py::object progress)
    : progress_(std::move(progress)),
      has_progress_(!progress_.is_none()),
      asks_(has_progress_ || IsMainThread()) {}

absl::Status Watch::Report(uint64_t done, uint64_t total) {
  if (error_ != nullptr) return absl::CancelledError("stopped by Python");
  if (!asks_) return absl::OkStatus();
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return absl::OkStatus();
  absl::Status status = Ask(done, total);
  next_ = std::chrono::steady_clock::now() + kInterval;
  return status;
}

void Watch::CheckSignals() {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

absl::Status Watch::Ask(uint64_t done, uint64_t total) {
  const py::gil_scoped_acquire locked;
  try {
    CheckSignals();
    // While a mesh is read or built there is nothing to count.
    if (has_progress_ && total > 0) progress_(done, total);
  } catch (...) {
    error_ = std::current_exception();
    return absl::CancelledError("stopped by Python");
  }
  return absl::OkStatus();
}

}  // namespace geodesic::python
