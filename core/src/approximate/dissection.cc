#include "approximate/dissection.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "absl/functional/function_ref.h"
#include "solver/work_meter.h"

namespace geodesic {
namespace {

// A cut through a mesh of n vertices takes about sqrt(n) of them, or a few
// times as many. One that takes far more makes more fill than it spares.
constexpr double kWidest = 16;

class Dissector {
 public:
  Dissector(const SymmetricPattern& pattern, size_t most,
            absl::FunctionRef<absl::Status()> poll)
      : most_(most),
        meter_(poll),
        begin_(pattern.size() + 1, 0),
        part_(pattern.size(), 0),
        level_(pattern.size(), -1) {
    ForEachEntry(pattern, [this](int32_t row, int32_t column) {
      ++begin_[row + 1];
      ++begin_[column + 1];
    });
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    neighbours_.resize(begin_.back());
    std::vector<int32_t> next(begin_.begin(), begin_.end() - 1);
    ForEachEntry(pattern, [&](int32_t row, int32_t column) {
      neighbours_[next[row]++] = column;
      neighbours_[next[column]++] = row;
    });
    dissection_.order.resize(pattern.size());
    std::iota(dissection_.order.begin(), dissection_.order.end(), 0);
    waiting_.push_back({0, pattern.size()});
  }

  absl::StatusOr<Dissection> Run() {
    while (!waiting_.empty()) {
      const Dissection::Part part = waiting_.back();
      waiting_.pop_back();
      if (part.end - part.begin <= most_ || !Cut(part)) {
        dissection_.parts.push_back(part);
      }
      if (!meter_.status().ok()) return meter_.status();
    }
    return std::move(dissection_);
  }

 private:
  template <typename Visit>
  static void ForEachEntry(const SymmetricPattern& pattern, Visit visit) {
    for (size_t column = 0; column < pattern.size(); ++column) {
      // The diagonal is the last.
      for (int32_t i = pattern.column_begin[column];
           i + 1 < pattern.column_begin[column + 1]; ++i) {
        visit(pattern.rows[i], static_cast<int32_t>(column));
      }
    }
  }

  void Forget() {
    for (const int32_t v : found_) level_[v] = -1;
    found_.clear();
  }

  // Finds the columns of start's part that a way leads to, by their distance
  // from it, which is then in level_. Not all if it was told to stop.
  void Search(int32_t start) {
    size_t i = found_.size();
    found_.push_back(start);
    level_[start] = 0;
    for (; i < found_.size(); ++i) {
      const int32_t v = found_[i];
      if (!meter_.Do(1 + (begin_[v + 1] - begin_[v]) / 8)) return;
      for (int32_t k = begin_[v]; k < begin_[v + 1]; ++k) {
        const int32_t w = neighbours_[k];
        if (part_[w] != part_[start] || level_[w] >= 0) continue;
        level_[w] = level_[v] + 1;
        found_.push_back(w);
      }
    }
  }

  // Two sides that touch nowhere, and what lies between them.
  struct Sides {
    std::vector<int32_t> first, second, between;
  };

  // Whether the part is cut into two that wait; what divides them is in its
  // place.
  bool Cut(const Dissection::Part& part) {
    const std::span<int32_t> columns = dissection_.ColumnsOf(part);
    Forget();
    Search(columns.front());
    const Sides sides =
        found_.size() < columns.size() ? PartComponents(columns) : CutAcross();
    const double widest =
        kWidest * std::sqrt(static_cast<double>(columns.size()));
    if (!meter_.status().ok() || sides.first.empty() || sides.second.empty() ||
        static_cast<double>(sides.between.size()) > widest) {
      return false;
    }
    size_t begin = part.begin;
    for (const std::vector<int32_t>* side : {&sides.first, &sides.second}) {
      std::ranges::copy(*side, dissection_.order.begin() + begin);
      ++parts_;
      for (const int32_t v : *side) part_[v] = parts_;
      waiting_.push_back({begin, begin + side->size()});
      begin += side->size();
    }
    std::ranges::copy(sides.between, dissection_.order.begin() + begin);
    for (const int32_t v : sides.between) part_[v] = kNoPart;
    return true;
  }

  // Of several components, one of which was found: half of the columns or more
  // in one side, unless one component has more than half of them.
  Sides PartComponents(std::span<const int32_t> columns) {
    size_t last = 0;
    for (const int32_t v : columns) {
      if (2 * found_.size() >= columns.size()) break;
      if (level_[v] >= 0) continue;
      last = found_.size();
      Search(v);
    }
    if (found_.size() == columns.size()) {
      for (size_t i = last; i < found_.size(); ++i) level_[found_[i]] = -1;
      found_.resize(last);
    }
    Sides sides;
    for (const int32_t v : columns) {
      (level_[v] >= 0 ? sides.first : sides.second).push_back(v);
    }
    return sides;
  }

  // Of one component, which was found: half way from end to end.
  Sides CutAcross() {
    const int32_t farthest = found_.back();
    Forget();
    Search(farthest);
    const int32_t middle = level_[found_[found_.size() / 2]];
    Sides sides;
    for (const int32_t v : found_) {
      if (level_[v] > middle) {
        sides.second.push_back(v);
      } else if (level_[v] == middle && TouchesLevel(v, middle + 1)) {
        sides.between.push_back(v);
      } else {
        sides.first.push_back(v);
      }
    }
    return sides;
  }

  bool TouchesLevel(int32_t v, int32_t level) const {
    return std::any_of(
        neighbours_.begin() + begin_[v], neighbours_.begin() + begin_[v + 1],
        [&](int32_t w) { return part_[w] == part_[v] && level_[w] == level; });
  }

  static constexpr int32_t kNoPart = -1;

  const size_t most_;
  WorkMeter meter_;
  // Neighbours of column v are those from begin_[v] to begin_[v + 1].
  std::vector<int32_t> begin_;
  std::vector<int32_t> neighbours_;
  std::vector<int32_t> part_;   // of each column
  std::vector<int32_t> level_;  // in the last search; -1 of those not in found_
  std::vector<int32_t> found_;
  int32_t parts_ = 0;
  std::vector<Dissection::Part> waiting_;
  Dissection dissection_;
};

}  // namespace

absl::StatusOr<Dissection> Dissect(const SymmetricPattern& pattern, size_t most,
                                   Checkpoint& checkpoint, Progress progress) {
  progress.solver_bytes +=
      (7 * pattern.size() + 2 * pattern.rows.size()) * sizeof(int32_t);
  const auto poll = [&] { return checkpoint.Poll(progress); };
  if (absl::Status status = poll(); !status.ok()) return status;
  return Dissector(pattern, most, poll).Run();
}

SymmetricPattern PatternOf(const SymmetricPattern& pattern,
                           std::span<const int32_t> columns,
                           std::vector<int32_t>& numbers) {
  for (size_t i = 0; i < columns.size(); ++i) {
    numbers[columns[i]] = static_cast<int32_t>(i);
  }
  const auto for_each_entry = [&](auto visit) {
    for (const int32_t column : columns) {
      for (int32_t i = pattern.column_begin[column];
           i < pattern.column_begin[column + 1]; ++i) {
        const int32_t row = numbers[pattern.rows[i]];
        if (row < 0) continue;
        visit(std::min(row, numbers[column]), std::max(row, numbers[column]));
      }
    }
  };
  SymmetricPattern part;
  part.column_begin.assign(columns.size() + 1, 0);
  for_each_entry(
      [&](int32_t, int32_t column) { ++part.column_begin[column + 1]; });
  std::partial_sum(part.column_begin.begin(), part.column_begin.end(),
                   part.column_begin.begin());
  part.rows.resize(part.column_begin.back());
  std::vector<int32_t> next(part.column_begin.begin(),
                            part.column_begin.end() - 1);
  for_each_entry(
      [&](int32_t row, int32_t column) { part.rows[next[column]++] = row; });
  for (size_t i = 0; i < columns.size(); ++i) {
    std::sort(part.rows.begin() + part.column_begin[i],
              part.rows.begin() + part.column_begin[i + 1]);
    numbers[columns[i]] = -1;
  }
  return part;
}

}  // namespace geodesic
