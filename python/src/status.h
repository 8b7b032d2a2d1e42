// Errors of the core, as the package's exceptions.

#ifndef GEODESIC_PYTHON_STATUS_H_
#define GEODESIC_PYTHON_STATUS_H_

#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace geodesic::python {

// Throws what geodesic/errors.py has for the status's code.
// REQUIRES: the status is not OK; the caller holds the interpreter's lock.
[[noreturn]] void Throw(const absl::Status& status);

inline void ValueOrThrow(const absl::Status& status) {
  if (!status.ok()) Throw(status);
}
template <typename T>
T ValueOrThrow(absl::StatusOr<T> value) {
  if (!value.ok()) Throw(value.status());
  return *std::move(value);
}

}  // namespace geodesic::python

#endif  // GEODESIC_PYTHON_STATUS_H_
