#include "rows/pair_plan.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace geodesic {
namespace {

struct End {
  SurfacePoint place;
  uint32_t pair = 0;

  friend auto operator<=>(const End&, const End&) = default;
};

// The ends of all pairs, sorted by place. A pair whose ends are the same place
// has one.
std::vector<End> SortedEnds(std::span<const PointPair> pairs) {
  std::vector<End> ends;
  ends.reserve(2 * pairs.size());
  for (uint32_t i = 0; i < pairs.size(); ++i) {
    ends.push_back({pairs[i].source, i});
    if (pairs[i].target != pairs[i].source)
      ends.push_back({pairs[i].target, i});
  }
  std::ranges::sort(ends);
  return ends;
}

// The ends at each place that has at least `least`, most first.
std::vector<std::span<const End>> CommonEnds(std::span<const End> ends,
                                             size_t least) {
  std::vector<std::span<const End>> groups;
  for (size_t begin = 0, end = 0; begin < ends.size(); begin = end) {
    while (end < ends.size() && ends[end].place == ends[begin].place) ++end;
    if (end - begin >= least)
      groups.push_back(ends.subspan(begin, end - begin));
  }
  std::ranges::stable_sort(
      groups, std::ranges::greater(),
      [](std::span<const End> group) { return group.size(); });
  return groups;
}

}  // namespace

std::vector<PairRow> PlanPairs(std::span<const PointPair> pairs,
                               const PairCosts& costs) {
  // No end is that of more pairs than there are.
  const std::vector<End> ends = costs.least_for_field <= pairs.size()
                                    ? SortedEnds(pairs)
                                    : std::vector<End>();
  std::vector<PairRow> rows;
  std::vector<bool> has_row(pairs.size());
  for (const auto& group : CommonEnds(ends, costs.least_for_field)) {
    PairRow row{.shared = group[0].place};
    for (const End& end : group) {
      if (!has_row[end.pair]) row.pairs.push_back(end.pair);
    }
    // Fields from their other ends may have left too few.
    if (row.pairs.size() < costs.least_for_field) continue;
    for (const uint32_t pair : row.pairs) has_row[pair] = true;
    rows.push_back(std::move(row));
  }
  PairRow searches;
  for (uint32_t i = 0; i < pairs.size(); ++i) {
    if (has_row[i]) continue;
    searches.pairs.push_back(i);
    if (searches.pairs.size() == costs.searches_per_row) {
      rows.push_back(std::exchange(searches, {}));
    }
  }
  if (!searches.pairs.empty()) rows.push_back(std::move(searches));
  std::ranges::sort(rows, {}, [](const PairRow& row) { return row.pairs[0]; });
  return rows;
}

}  // namespace geodesic
