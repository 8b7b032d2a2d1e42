#include "windows/window_lists.h"

#include <cstdint>
#include <random>
#include <vector>

#include "gtest/gtest.h"

namespace geodesic {
namespace {

// Against plain vectors, through many random replacements.
TEST(WindowListsTest, BehavesLikeVectors) {
  constexpr uint32_t kHalfEdges = 7;
  WindowLists lists(kHalfEdges);
  std::vector<std::vector<uint32_t>> expected(kHalfEdges);
  std::mt19937 random(3);
  for (uint32_t step = 0; step < 5000; ++step) {
    const HalfEdge h = random() % kHalfEdges;
    std::vector<uint32_t>& list = expected[h];
    if (step % 50 == 49) {
      lists.Drop(h);
      list.clear();
    }
    const auto size = static_cast<uint32_t>(list.size());
    const uint32_t first = random() % (size + 1);
    const uint32_t last = first + random() % (size - first + 1);
    std::vector<ListedWindow> entries(random() % (size > 40 ? 1 : 4));
    list.erase(list.begin() + first, list.begin() + last);
    for (uint32_t i = 0; i < entries.size(); ++i) {
      entries[i].id = 4 * step + i;
      list.insert(list.begin() + first + i, entries[i].id);
    }
    lists.Replace(h, first, last, entries);
    ASSERT_EQ(lists.Of(h).size(), list.size());
    for (size_t i = 0; i < list.size(); ++i) {
      ASSERT_EQ(lists.Of(h)[i].id, list[i]) << "step " << step;
    }
  }
  uint64_t size = 0;
  for (const std::vector<uint32_t>& list : expected) size += list.size();
  EXPECT_EQ(lists.size(), size);
  EXPECT_GE(lists.peak_size(), size);
  EXPECT_GT(lists.bytes(), size * sizeof(ListedWindow));
}

}  // namespace
}  // namespace geodesic
