// Matrices, nearest targets and pairs: a computation a row.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "geodesic/target_search.h"
#include "rows.h"
#include "solve_within.h"
#include "status.h"
#include "subject.h"
#include "watch.h"

namespace geodesic::python {
namespace {

namespace py = pybind11;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// What the query's source number `row` alone answers: a value for each target,
// or for each vertex where there are no targets. Beyond `radius` it is
// +infinity.
absl::StatusOr<std::vector<double>> RowOf(const QueryHandle& question,
                                          uint64_t row, double radius,
                                          uint64_t stop_after_targets,
                                          Checkpoint& checkpoint) {
  const ValidQuery query =
      question.query.OfSource(static_cast<uint32_t>(row), question.mesh());
  absl::StatusOr<DistanceField> field = SolveWithin(
      question.mesh(), query, {.radius = radius, .targets = stop_after_targets},
      /*threads=*/1, checkpoint);
  if (!field.ok()) return field.status();
  return std::move(query->targets.empty() ? field->distances
                                          : field->target_distances);
}

// Fills `out`, an array of shape (sources, targets or vertices) in C order.
template <typename Value>
void FillMatrix(const QueryHandle& question, double radius, uint32_t threads,
                py::object progress,
                py::array_t<Value, py::array::c_style>& out) {
  Value* const values = out.mutable_data();
  const auto columns = static_cast<size_t>(out.shape(1));
  const uint64_t all_targets = question.query->targets.empty()
                                   ? std::numeric_limits<uint64_t>::max()
                                   : question.query->targets.size();
  Watch watch(std::move(progress));
  watch.Run([&]() -> absl::StatusOr<bool> {
    absl::Status status =
        RunRows(static_cast<uint64_t>(out.shape(0)), threads, watch,
                [&](uint64_t row, Checkpoint& checkpoint) -> absl::Status {
                  const absl::StatusOr<std::vector<double>> found =
                      RowOf(question, row, radius, all_targets, checkpoint);
                  if (!found.ok()) return found.status();
                  std::ranges::transform(
                      *found, values + row * columns,
                      [](double value) { return static_cast<Value>(value); });
                  return absl::OkStatus();
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
  const uint64_t all_targets = question.query->targets.empty()
                                   ? std::numeric_limits<uint64_t>::max()
                                   : question.query->targets.size();
  Watch watch(std::move(progress));
  struct Csr {
    std::vector<int64_t> counts;
    std::vector<int32_t> columns;
    std::vector<double> values;
  };
  Csr csr = watch.Run([&]() -> absl::StatusOr<Csr> {
    absl::Status status =
        RunRows(rows.size(), threads, watch,
                [&](uint64_t number, Checkpoint& checkpoint) -> absl::Status {
                  const absl::StatusOr<std::vector<double>> found =
                      RowOf(question, number, radius, all_targets, checkpoint);
                  if (!found.ok()) return found.status();
                  Row& row = rows[number];
                  for (size_t column = 0; column < found->size(); ++column) {
                    if (!std::isfinite((*found)[column])) continue;
                    row.columns.push_back(static_cast<int32_t>(column));
                    row.values.push_back((*found)[column]);
                  }
                  return absl::OkStatus();
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
  int64_t* const all_targets = targets.mutable_data();
  double* const all_distances = distances.mutable_data();
  Watch watch(std::move(progress));
  watch.Run([&]() -> absl::StatusOr<bool> {
    absl::Status status = RunRows(
        static_cast<uint64_t>(sources), threads, watch,
        [&](uint64_t row, Checkpoint& checkpoint) -> absl::Status {
          const absl::StatusOr<std::vector<double>> found =
              RowOf(question, row, radius, count, checkpoint);
          if (!found.ok()) return found.status();
          std::vector<uint32_t> order(found->size());
          std::iota(order.begin(), order.end(), 0u);
          const size_t kept = std::min<size_t>(count, order.size());
          std::ranges::partial_sort(
              order, order.begin() + static_cast<std::ptrdiff_t>(kept), {},
              [&](uint32_t t) { return std::pair((*found)[t], t); });
          for (size_t k = 0; k < count; ++k) {
            const double distance = k < kept ? (*found)[order[k]] : kInfinity;
            all_distances[row * count + k] = distance;
            all_targets[row * count + k] =
                std::isfinite(distance) ? int64_t{order[k]} : -1;
          }
          return absl::OkStatus();
        });
    if (!status.ok()) return status;
    return true;
  });
  return py::make_tuple(targets, distances);
}

using PairGroups = std::vector<std::vector<size_t>>;

// Group g is what `order` has between ends[g - 1] and ends[g].
PairGroups ToGroups(const py::array_t<int64_t>& order,
                    const py::array_t<int64_t>& ends) {
  const auto number = order.unchecked<1>();
  const auto end = ends.unchecked<1>();
  PairGroups groups(static_cast<size_t>(end.shape(0)));
  py::ssize_t k = 0;
  for (size_t g = 0; g < groups.size(); ++g) {
    for (; k < end(static_cast<py::ssize_t>(g)); ++k) {
      groups[g].push_back(static_cast<size_t>(number(k)));
    }
  }
  return groups;
}

// Says how far a computation is in rows while something is made for all.
class BeforeRows final : public Checkpoint {
 public:
  BeforeRows(Watch& watch, uint64_t rows) : watch_(watch), rows_(rows) {}
  absl::Status Poll(const Progress&) override {
    return watch_.Report(0, rows_);
  }

 private:
  Watch& watch_;
  const uint64_t rows_;
};

// The distances from source i to target i of the query, for the pairs i of a
// group, whose sources are equal.
absl::Status AnswerPairs(const QueryHandle& question,
                         const std::vector<size_t>& pairs, double tolerance,
                         Checkpoint& checkpoint,
                         std::vector<double>& distances) {
  Query query{.sources = {question.query->sources[pairs[0]]},
              .tolerance = tolerance};
  for (size_t i : pairs) query.targets.push_back(question.query->targets[i]);
  const absl::StatusOr<ValidQuery> valid =
      ValidQuery::Make(std::move(query), question.mesh());
  if (!valid.ok()) return valid.status();
  std::vector<double> found;
  if (pairs.size() >= kFieldInSearches) {
    absl::StatusOr<std::vector<double>> row =
        RowOf({question.on, *valid}, 0, kInfinity, pairs.size(), checkpoint);
    if (!row.ok()) return row.status();
    found = *std::move(row);
  } else {
    absl::StatusOr<TargetDistances> searched =
        question.on.searches->Run(*valid, checkpoint);
    if (!searched.ok()) return searched.status();
    found = std::move(searched->distances);
  }
  for (size_t k = 0; k < pairs.size(); ++k) distances[pairs[k]] = found[k];
  return absl::OkStatus();
}

// The distance from source i to target i of the query, for each i. `order` has
// every i, those of equal sources beside each other, each group up to one of
// `ends`. The tolerance holds for each source alone.
py::array_t<double> Pairs(const QueryHandle& question,
                          const py::array_t<int64_t>& order,
                          const py::array_t<int64_t>& ends, double tolerance,
                          uint32_t threads, py::object progress) {
  const PairGroups groups = ToGroups(order, ends);
  size_t searches = 0;
  for (const std::vector<size_t>& group : groups) {
    if (group.size() < kFieldInSearches) searches += group.size();
  }
  std::vector<double> distances(question.query->targets.size());
  Watch watch(std::move(progress));
  watch.Run([&]() -> absl::StatusOr<bool> {
    if (const uint32_t count = LandmarksWorth(searches); count > 0) {
      BeforeRows before(watch, groups.size());
      absl::Status made =
          question.on.searches->MakeLandmarks(count, threads, before);
      if (!made.ok()) return made;
    }
    absl::Status status =
        RunRows(groups.size(), threads, watch,
                [&](uint64_t row, Checkpoint& checkpoint) {
                  return AnswerPairs(question, groups[row], tolerance,
                                     checkpoint, distances);
                });
    if (!status.ok()) return status;
    return true;
  });
  return ToArray(std::move(distances));
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
  module.def("pairs", &Pairs);
}

}  // namespace geodesic::python
