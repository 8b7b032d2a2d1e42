#include "solver/windows/window_lists.h"

#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "gtest/gtest.h"

namespace geodesic {
namespace {

// A window over [at, at + 1] of its edge, told from others by `number`.
ListedWindow Unit(uint32_t at, uint32_t number) {
  return {Window::Over({static_cast<double>(at), at + 1.0}, {.depth = 1}),
          number};
}

std::vector<uint32_t> NumbersOf(WindowLists<Origin>& lists, HalfEdge h) {
  std::vector<uint32_t> numbers;
  lists.Seek(h, -1);
  while (const ListedWindow* window = lists.Next(h)) {
    numbers.push_back(window->pseudo_source);
    lists.Pass(h);
  }
  return numbers;
}

// Against plain arrays of 100 places, through many random changes.
TEST(WindowListsTest, BehavesLikeSortedArrays) {
  constexpr uint32_t kHalfEdges = 7;
  constexpr uint32_t kPlaces = 100;
  WindowLists<Origin> lists(kHalfEdges);
  std::vector<std::vector<uint32_t>> expected(
      kHalfEdges, std::vector<uint32_t>(kPlaces, 0));
  std::mt19937 random(3);
  uint64_t size = 0;
  for (uint32_t number = 1; number < 20000; ++number) {
    const HalfEdge h = random() % kHalfEdges;
    if (random() % 500 == 0) {
      lists.Drop(h);
      for (uint32_t& place : expected[h]) size -= std::exchange(place, 0) != 0;
      EXPECT_FALSE(lists.has_room(h));
    }
    const uint32_t at = random() % kPlaces;
    lists.Seek(h, at);
    if (expected[h][at] != 0) {
      ASSERT_EQ(lists.Next(h)->pseudo_source, expected[h][at]);
      ASSERT_EQ(lists.NextLabel(h), expected[h][at]);
      lists.RemoveNext(h);
      expected[h][at] = 0;
      --size;
    } else {
      lists.Add(h, Unit(at, number), number);
      expected[h][at] = number;
      ++size;
      EXPECT_TRUE(lists.has_room(h));
    }
    ASSERT_EQ(lists.size(), size);
    if (number % 100 == 0) {
      std::vector<uint32_t> numbers = expected[h];
      std::erase(numbers, 0u);
      ASSERT_EQ(NumbersOf(lists, h), numbers);
    }
  }
  EXPECT_GE(lists.peak_size(), size);
  EXPECT_GT(lists.bytes(), size * sizeof(ListedWindow));
}

TEST(WindowListsTest, TakesWhatIsDueOnceAndInOrder) {
  WindowLists<Origin> lists(1);
  for (uint32_t at : {5, 1, 4, 2, 3}) {
    lists.Seek(0, at);
    lists.Add(0, Unit(at, at), 10 - at);  // the last in place is due first
  }
  const auto take = [&](double due, size_t most) {
    std::vector<uint32_t> numbers;
    lists.TakeDue(0, due, most, [&](const ListedWindow& window) {
      numbers.push_back(window.pseudo_source);
    });
    return numbers;
  };
  using Numbers = std::vector<uint32_t>;
  EXPECT_EQ(lists.Pending(0), 5u);
  EXPECT_EQ(take(7, 2), (Numbers{3, 4}));
  EXPECT_EQ(take(7, 2), (Numbers{5}));
  EXPECT_EQ(take(7, 2), (Numbers{}));
  EXPECT_EQ(lists.Pending(0), 2u);
  EXPECT_EQ(take(9, 5), (Numbers{1, 2}));
  EXPECT_EQ(lists.size(), 5u);  // they stay in the list
}

}  // namespace
}  // namespace geodesic
