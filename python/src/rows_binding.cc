// Matrices and nearest targets.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "geodesic/matrix_rows.h"
#include "matrix_lines.h"
#include "status.h"
#include "subject.h"
#include "watch.h"

namespace geodesic::python {
namespace {

namespace py = pybind11;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr uint64_t kAllTargets = std::numeric_limits<uint64_t>::max();

// Fills `out`, an array of shape (sources, targets or vertices) in C order.
template <typename Value>
void FillMatrix(const QueryHandle& question, double radius, uint32_t threads,
                py::object progress,
                py::array_t<Value, py::array::c_style>& out) {
  Value* const values = out.mutable_data();
  const auto columns = static_cast<size_t>(out.shape(1));
  const MatrixLines lines(question, radius, kAllTargets);
  Watch watch(std::move(progress));
  watch.Run([&]() -> absl::StatusOr<bool> {
    const size_t first = lines.are_columns() ? 1 : columns;
    const size_t step = lines.are_columns() ? columns : 1;
    absl::Status status = lines.Compute(
        threads, watch, [&](uint64_t number, std::span<const double> found) {
          for (size_t i = 0; i < found.size(); ++i) {
            values[number * first + i * step] = static_cast<Value>(found[i]);
          }
        });
    if (!status.ok()) return status;
    return true;
  });
}

// (counts of the rows, columns, values): what is within the radius.
py::tuple SparseMatrix(const QueryHandle& question, double radius,
                       uint32_t threads, py::object progress) {
  struct Row {
    std::vector<int32_t> columns;
    std::vector<double> values;
  };
  std::vector<Row> rows(question.query->sources.size());
  Watch watch(std::move(progress));
  struct Csr {
    std::vector<int64_t> counts;
    std::vector<int32_t> columns;
    std::vector<double> values;
  };
  Csr csr = watch.Run([&]() -> absl::StatusOr<Csr> {
    absl::Status status =
        MatrixLines(question, radius, kAllTargets)
            .ComputeRows(
                threads, watch,
                [&](uint64_t number, std::span<const double> found) {
                  Row& row = rows[number];
                  for (size_t column = 0; column < found.size(); ++column) {
                    if (!std::isfinite(found[column])) continue;
                    row.columns.push_back(static_cast<int32_t>(column));
                    row.values.push_back(found[column]);
                  }
                });
    if (!status.ok()) return status;
    Csr all;
    for (Row& row : rows) {
      all.counts.push_back(static_cast<int64_t>(row.values.size()));
      all.columns.insert(all.columns.end(), row.columns.begin(),
                         row.columns.end());
      all.values.insert(all.values.end(), row.values.begin(), row.values.end());
      row = {};
    }
    return all;
  });
  return py::make_tuple(ToArray(std::move(csr.counts)),
                        ToArray(std::move(csr.columns)),
                        ToArray(std::move(csr.values)));
}

// (targets, distances), each of shape (sources, count): of each source the
// nearest targets in order; -1 and +infinity where there are fewer.
py::tuple Nearest(const QueryHandle& question, uint32_t count, double radius,
                  uint32_t threads, py::object progress) {
  const auto sources = static_cast<py::ssize_t>(question.query->sources.size());
  py::array_t<int64_t> targets({sources, static_cast<py::ssize_t>(count)});
  py::array_t<double> distances({sources, static_cast<py::ssize_t>(count)});
  std::fill_n(targets.mutable_data(), targets.size(), -1);
  std::fill_n(distances.mutable_data(), distances.size(), kInfinity);
  int64_t* const all_targets = targets.mutable_data();
  double* const all_distances = distances.mutable_data();
  Watch watch(std::move(progress));
  watch.Run([&]() -> absl::StatusOr<bool> {
    absl::Status status =
        MatrixLines(question, radius, count)
            .ComputeRows(
                threads, watch,
                [&](uint64_t row, std::span<const double> found) {
                  uint64_t at = row * count;
                  for (const uint32_t target : NearestOf(found, count)) {
                    all_targets[at] = target;
                    all_distances[at++] = found[target];
                  }
                });
    if (!status.ok()) return status;
    return true;
  });
  return py::make_tuple(targets, distances);
}

}  // namespace

void BindRows(py::module_& module) {
  module.def("fill_matrix", &FillMatrix<double>, py::arg().noconvert(),
             py::arg().noconvert(), py::arg(), py::arg(),
             py::arg().noconvert());
  module.def("fill_matrix", &FillMatrix<float>, py::arg().noconvert(),
             py::arg().noconvert(), py::arg(), py::arg(),
             py::arg().noconvert());
  module.def("sparse_matrix", &SparseMatrix);
  module.def("nearest", &Nearest);
}

}  // namespace geodesic::python
