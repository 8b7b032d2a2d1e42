// Matrices and nearest targets.

#include <pybind11/stl.h>

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "geodesic/rows/matrix.h"
#include "rows.h"
#include "status.h"
#include "subject.h"
#include "watch.h"

namespace geodesic::python {
namespace {

namespace py = pybind11;

// Transposed, if that costs less.
MatrixQuestion MakeQuestion(const QueryHandle& about, const RowFilter& filter,
                            const MethodHandle* method) {
  MatrixQuestion question = ValueOrThrow(
      MatrixQuestion::Make(about.mesh(), about.query, filter,
                           RowMethodOf(method), *about.on.searches));
  if (question.TransposingPays()) question.Transpose();
  return question;
}

using Put = std::function<void(uint64_t number, const DistanceRow& row)>;

// Calls `put` for each line, from any of the threads.
absl::Status AnswerLines(const MatrixQuestion& question, uint32_t threads,
                         Watch& watch, const Put& put) {
  return RunRows(question.lines(), threads, watch,
                 [&](uint64_t line, Checkpoint& checkpoint) {
                   const absl::StatusOr<DistanceRow> found =
                       question.Answer(line, checkpoint);
                   if (found.ok()) put(line, *found);
                   return found.status();
                 });
}

// The same for each row; columns are kept until all are there.
absl::Status AnswerRows(const MatrixQuestion& question, uint32_t threads,
                        Watch& watch, const Put& put) {
  if (!question.is_transposed()) {
    return AnswerLines(question, threads, watch, put);
  }
  MatrixTable table(question);
  std::mutex mutex;
  absl::Status status = AnswerLines(
      question, threads, watch, [&](uint64_t column, const DistanceRow& line) {
        const std::scoped_lock lock(mutex);
        table.Add(column, line);
      });
  if (!status.ok()) return status;
  for (uint64_t row = 0; row < table.rows(); ++row) put(row, table.Row(row));
  return absl::OkStatus();
}

// Fills `out`, an array of shape (sources, targets or vertices) in C order.
template <typename Value>
void FillMatrix(const QueryHandle& about, double radius,
                const MethodHandle* method, uint32_t threads,
                py::object progress,
                py::array_t<Value, py::array::c_style>& out) {
  const MatrixQuestion question =
      MakeQuestion(about, {.radius = radius}, method);
  Value* const values = out.mutable_data();
  const bool are_columns = question.is_transposed();
  const uint64_t first = are_columns ? 1 : question.columns();
  const uint64_t step = are_columns ? question.columns() : 1;
  Watch watch(std::move(progress));
  watch.Run([&] {
    return AnswerLines(question, threads, watch,
                       [&](uint64_t line, const DistanceRow& found) {
                         for (size_t i = 0; i < found.values.size(); ++i) {
                           values[line * first + i * step] =
                               static_cast<Value>(found.values[i]);
                         }
                       });
  });
}

// (counts of the rows, columns, values): what is within the radius, of which
// rows may have the nearest alone.
py::tuple SparseMatrix(const QueryHandle& about, double radius,
                       std::optional<uint64_t> nearest,
                       const MethodHandle* method, uint32_t threads,
                       py::object progress) {
  const MatrixQuestion question = MakeQuestion(
      about, {.radius = radius, .sparse = true, .nearest = nearest}, method);
  std::vector<DistanceRow> rows(question.rows());
  struct Csr {
    std::vector<int64_t> counts;
    std::vector<int32_t> columns;
    std::vector<double> values;
  };
  Watch watch(std::move(progress));
  Csr csr = watch.Run([&]() -> absl::StatusOr<Csr> {
    absl::Status status = AnswerRows(
        question, threads, watch,
        [&](uint64_t row, const DistanceRow& found) { rows[row] = found; });
    if (!status.ok()) return status;
    Csr all;
    for (DistanceRow& row : rows) {
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

}  // namespace

void BindRows(py::module_& module) {
  module.def("fill_matrix", &FillMatrix<double>, py::arg().noconvert(),
             py::arg().noconvert(), py::arg(), py::arg(), py::arg(),
             py::arg().noconvert());
  module.def("fill_matrix", &FillMatrix<float>, py::arg().noconvert(),
             py::arg().noconvert(), py::arg(), py::arg(), py::arg(),
             py::arg().noconvert());
  module.def("sparse_matrix", &SparseMatrix);
}

}  // namespace geodesic::python
