#include "solver/windows/window_blocks.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <thread>
#include <vector>

#include "solver/windows/window_columns.h"

namespace geodesic {
namespace {

// A list of windows that can be told apart from all others.
void Fill(uint32_t number, size_t count, WindowColumns& windows) {
  windows.Reserve(count);
  windows.size = count;
  for (size_t i = 0; i < count; ++i) {
    const double value = number + static_cast<double>(i) / 1024;
    windows.Set(i, {{value, value + 0.25}, {value + 1, value + 2, value + 3}},
                number);
  }
}

void ExpectFilled(uint32_t number, size_t count, const WindowColumns& windows) {
  ASSERT_EQ(windows.size, count);
  WindowColumns expected;
  Fill(number, count, expected);
  for (size_t i = 0; i < count; ++i) {
    EXPECT_EQ(windows.begin[i], expected.begin[i]);
    EXPECT_EQ(windows.end[i], expected.end[i]);
    EXPECT_EQ(windows.x[i], expected.x[i]);
    EXPECT_EQ(windows.depth[i], expected.depth[i]);
    EXPECT_EQ(windows.sigma[i], expected.sigma[i]);
    EXPECT_EQ(windows.pseudo_source[i], number);
  }
}

// One thread stores, another takes, for ever: what the one frees comes back to
// the other.
TEST(WindowBlocksTest, MemoryGoesRound) {
  BlockPool pool;
  WindowBlocks from(pool), to(pool);
  WindowColumns windows;
  const auto pass_on = [&](uint32_t lists) {
    for (uint32_t number = 0; number < lists; ++number) {
      Fill(number, 1 + number % 40, windows);
      WindowBlock* const block = from.Store(windows);
      windows.size = 0;
      to.Take(block, windows);
      ExpectFilled(number, 1 + number % 40, windows);
    }
  };
  pass_on(10000);
  const uint64_t bytes = pool.bytes();
  pass_on(40000);
  EXPECT_EQ(pool.bytes(), bytes);
}

// Says something under ThreadSanitizer alone.
TEST(WindowBlocksTest, OthersMayPrefetchWhatIsTakenAndStored) {
  BlockPool pool;
  WindowBlocks blocks(pool);
  WindowColumns windows;
  Fill(1, 20, windows);
  WindowBlock* block = blocks.Store(windows);
  const std::jthread other([block] {
    WindowBlocks::Prefetch(block);
    WindowBlocks::PrefetchRest(block);
  });
  windows.size = 0;
  blocks.Take(block, windows);
  EXPECT_EQ(blocks.Store(windows), block);
}

TEST(WindowColumnsTest, AMirrorImageOfAMirrorImageIsTheList) {
  WindowColumns windows;
  windows.Reserve(3);
  windows.size = 3;
  windows.Set(0, Window::Over({0, 1}, {4, 2, 1}), 5);
  windows.Set(1, Window::Over({1, 3}, {-1, 1, 0.5}), 6);
  windows.Set(2, Window::Over({3, 4}, {2, 3, 0}), 7);
  windows.Mirror(4);
  EXPECT_EQ(windows.pseudo_source[0], 7u);
  EXPECT_EQ(windows.begin[0], 0);
  EXPECT_EQ(windows.end[0], 1);
  EXPECT_EQ(windows.begin[1], 1);
  EXPECT_EQ(windows.x[1], 5);
  const Window middle = windows.At(1);
  EXPECT_DOUBLE_EQ(middle.begin_distance, middle.DistanceTo(1));
  EXPECT_DOUBLE_EQ(middle.end_distance, middle.DistanceTo(3));
  windows.Mirror(4);
  EXPECT_EQ(windows.pseudo_source[0], 5u);
  EXPECT_EQ(windows.x[0], 4);
  EXPECT_EQ(windows.end[2], 4);
}

}  // namespace
}  // namespace geodesic
