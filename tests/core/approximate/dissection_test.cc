#include "approximate/dissection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "approximate/cholesky.h"
#include "tests/support/checkpoints.h"

namespace geodesic {
namespace {

using test::RecordingCheckpoint;

using Entries = std::set<std::pair<int32_t, int32_t>>;  // column, row

SymmetricPattern Pattern(int32_t columns, Entries entries) {
  for (int32_t c = 0; c < columns; ++c) entries.insert({c, c});
  SymmetricPattern pattern{.column_begin = {0}, .rows = {}};
  auto entry = entries.begin();
  for (int32_t c = 0; c < columns; ++c) {
    for (; entry != entries.end() && entry->first == c; ++entry) {
      pattern.rows.push_back(entry->second);
    }
    pattern.column_begin.push_back(static_cast<int32_t>(pattern.rows.size()));
  }
  return pattern;
}

// A grid whose columns are numbered from `begin` on.
void AddGrid(int32_t side, int32_t begin, Entries& entries) {
  const auto at = [&](int32_t x, int32_t y) { return begin + y * side + x; };
  for (int32_t y = 0; y < side; ++y) {
    for (int32_t x = 0; x < side; ++x) {
      if (x > 0) entries.insert({at(x, y), at(x - 1, y)});
      if (y > 0) entries.insert({at(x, y), at(x, y - 1)});
      if (x > 0 && y > 0) entries.insert({at(x, y), at(x - 1, y - 1)});
    }
  }
}
SymmetricPattern Grid(int32_t side) {
  Entries entries;
  AddGrid(side, 0, entries);
  return Pattern(side * side, entries);
}

Dissection DissectOrFail(const SymmetricPattern& pattern, size_t most) {
  NoCheckpoint checkpoint;
  return Dissect(pattern, most, checkpoint, {}).value();
}

// All columns, once; and what Dissection says of parts.
void ExpectSound(const SymmetricPattern& pattern, Dissection dissection) {
  std::vector<int32_t> place(pattern.size(), -1), part(pattern.size(), -1);
  for (size_t i = 0; i < dissection.order.size(); ++i) {
    place[dissection.order[i]] = static_cast<int32_t>(i);
  }
  ASSERT_EQ(std::ranges::count(place, -1), 0);
  for (size_t p = 0; p < dissection.parts.size(); ++p) {
    for (const int32_t v : dissection.ColumnsOf(dissection.parts[p])) {
      ASSERT_EQ(part[v], -1);
      part[v] = static_cast<int32_t>(p);
    }
  }
  for (size_t c = 0; c < pattern.size(); ++c) {
    for (int32_t i = pattern.column_begin[c]; i < pattern.column_begin[c + 1];
         ++i) {
      const int32_t r = pattern.rows[i];
      if (part[c] == -1 && part[r] != -1) {
        ASSERT_LT(place[r], place[c]);
      }
      if (part[r] == -1 && part[c] != -1) {
        ASSERT_LT(place[c], place[r]);
      }
      if (part[c] != -1 && part[r] != -1) {
        ASSERT_EQ(part[c], part[r]);
      }
    }
  }
}

TEST(Dissection, PartsTouchNowhere) {
  const SymmetricPattern pattern = Grid(60);
  for (const size_t most : {20u, 200u, 3599u}) {
    SCOPED_TRACE(most);
    const Dissection dissection = DissectOrFail(pattern, most);
    ExpectSound(pattern, dissection);
    size_t in_parts = 0;
    for (const auto& [begin, end] : dissection.parts) {
      EXPECT_LE(end - begin, most);
      in_parts += end - begin;
    }
    // What lies between takes a small share.
    EXPECT_GE(in_parts, pattern.size() / 2);
  }
}

TEST(Dissection, WhatIsSmallStaysAsItIs) {
  const SymmetricPattern pattern = Grid(20);
  Dissection dissection = DissectOrFail(pattern, 400);
  ASSERT_EQ(dissection.parts.size(), 1);
  std::vector<int32_t> numbers(pattern.size(), -1);
  const SymmetricPattern same =
      PatternOf(pattern, dissection.ColumnsOf(dissection.parts[0]), numbers);
  EXPECT_EQ(same.column_begin, pattern.column_begin);
  EXPECT_EQ(same.rows, pattern.rows);
  EXPECT_EQ(std::ranges::count(numbers, -1), 400);
}

// Each component by itself would take as many searches as there are.
TEST(Dissection, ComponentsArePartedInHalves) {
  constexpr int32_t kSingle = 20'000;
  Entries entries;
  AddGrid(50, kSingle / 2, entries);
  const SymmetricPattern pattern = Pattern(kSingle + 2500, entries);
  RecordingCheckpoint checkpoint;
  const Dissection dissection = Dissect(pattern, 100, checkpoint, {}).value();
  ExpectSound(pattern, dissection);
  for (const auto& [begin, end] : dissection.parts) {
    EXPECT_LE(end - begin, 100);
  }
  EXPECT_LE(checkpoint.polls().size(), 1000);
}

TEST(Dissection, WhatHasAHubStaysWhole) {
  Entries entries;
  for (int32_t v = 1; v < 1000; ++v) entries.insert({v, 0});
  const SymmetricPattern pattern = Pattern(1000, entries);
  const Dissection dissection = DissectOrFail(pattern, 100);
  ExpectSound(pattern, dissection);
  EXPECT_EQ(dissection.parts.size(), 1);
}

TEST(Dissection, StopsAtAnyPoll) {
  const SymmetricPattern pattern = Grid(100);
  RecordingCheckpoint whole;
  ASSERT_TRUE(Dissect(pattern, 100, whole, {}).ok());
  ASSERT_GE(whole.polls().size(), 10);
  for (size_t poll = 0; poll < whole.polls().size(); ++poll) {
    RecordingCheckpoint checkpoint(poll);
    EXPECT_EQ(Dissect(pattern, 100, checkpoint, {}).status(),
              RecordingCheckpoint::Stopped());
  }
}

// Ordered in parts or at once, a matrix has the same solution.
TEST(Dissection, SolutionsAreThoseOfAnyOrder) {
  const SymmetricPattern pattern = Grid(40);
  std::vector<double> values, right(pattern.size());
  std::iota(right.begin(), right.end(), 1);
  for (size_t c = 0; c < pattern.size(); ++c) {
    for (int32_t i = pattern.column_begin[c]; i < pattern.column_begin[c + 1];
         ++i) {
      values.push_back(pattern.rows[i] == static_cast<int32_t>(c) ? 7 : -1);
    }
  }
  NoCheckpoint checkpoint;
  const auto solve = [&](size_t most) {
    const auto order = Cholesky::Analyze(pattern, checkpoint, {}, most).value();
    return Cholesky::Factorize(pattern, *order, values, checkpoint, {})
        .value()
        .Solve(right, checkpoint, {})
        .value();
  };
  const std::vector<double> expected = solve(pattern.size());
  for (const size_t most : {30u, 300u}) {
    const std::vector<double> solved = solve(most);
    for (size_t i = 0; i < solved.size(); ++i) {
      ASSERT_NEAR(solved[i], expected[i], 1e-9 * std::abs(expected[i]));
    }
  }
}

}  // namespace
}  // namespace geodesic
