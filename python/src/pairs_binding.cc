// Distances of pairs: a search for each, or a field for several.

#include <cstdint>
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
  if (pairs.size() >= question.on.searches->FieldInSearches()) {
    absl::StatusOr<DistanceField> field =
        SolveWithin(question.mesh(), *valid, {.targets = pairs.size()},
                    /*threads=*/1, checkpoint);
    if (!field.ok()) return field.status();
    found = std::move(field->target_distances);
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

void BindPairs(py::module_& module) { module.def("pairs", &Pairs); }

}  // namespace geodesic::python
