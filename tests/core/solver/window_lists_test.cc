#include "solver/windows/window_lists.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "gtest/gtest.h"

namespace geodesic {
namespace {

// A window over [at, at + 1] of its edge, told from others by `number`.
ListedWindow Unit(uint32_t at, uint32_t number) {
  return {Window::Over({static_cast<double>(at), at + 1.0}, {.depth = 1}),
          number};
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
