#include "solver/trimming/envelope.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "solver/windows/window_columns.h"
#include "tolerances.h"

namespace geodesic {
namespace {

constexpr double kLength = 2;

// Windows of sources at about one distance beyond the edge, none of which can
// be passed by: their rays end at the vertices 0 and kLength.
class Windows {
 public:
  explicit Windows(uint32_t seed) : random_(seed) {}

  Window Next() {
    double a = Uniform(0, kLength), b = Uniform(0, kLength);
    if (a > b) std::swap(a, b);
    return Window::Over({a, b},
                        {.x = Uniform(-1, 3), .depth = Uniform(1, 1.5)});
  }

 private:
  double Uniform(double low, double high) {
    return std::uniform_real_distribution(low, high)(random_);
  }
  std::mt19937 random_;
};

void Append(const Window& window, WindowColumns& windows) {
  windows.Reserve(windows.size + 1);
  windows.Set(windows.size, window, static_cast<uint32_t>(windows.size));
  ++windows.size;
}

double Nearest(const std::vector<Window>& windows, double at) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Window& window : windows) {
    if (at < window.interval.begin || at > window.interval.end) continue;
    nearest = std::min(nearest, window.DistanceTo(at));
  }
  return nearest;
}

// At every point the list holds what is nearest of `windows`, once.
void ExpectEnvelope(const std::vector<Window>& windows,
                    const WindowColumns& list) {
  for (size_t i = 0; i < list.size; ++i) {
    EXPECT_LT(list.begin[i], list.end[i]);
    EXPECT_LE(i == 0 ? 0 : list.end[i - 1], list.begin[i]);
  }
  for (double at = 0.0005; at < kLength; at += 0.001) {
    double held = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < list.size; ++i) {
      if (list.begin[i] <= at && at <= list.end[i]) {
        held = list.At(i).DistanceTo(at);
      }
    }
    const double nearest = Nearest(windows, at);
    if (nearest == held) continue;
    EXPECT_NEAR(held, nearest, 1e-12) << "at " << at;
  }
}

TEST(EnvelopeTest, TrimsAnyListToWhatIsNearest) {
  Envelope envelope;
  for (uint32_t seed = 1; seed <= 200; ++seed) {
    Windows some(seed);
    std::vector<Window> windows;
    WindowColumns list;
    for (uint32_t i = 0; i < 2 + seed % 12; ++i) {
      windows.push_back(some.Next());
      Append(windows.back(), list);
    }
    envelope.Trim(kLength, list);
    SCOPED_TRACE(seed);
    ExpectEnvelope(windows, list);
    for (size_t i = 0; i < list.size; ++i) {
      const Window window = list.At(i);
      EXPECT_NEAR(window.begin_distance,
                  window.DistanceTo(window.interval.begin), 1e-13);
      EXPECT_NEAR(window.end_distance, window.DistanceTo(window.interval.end),
                  1e-13);
    }
  }
}

// As children of one list are: in order, and overlapping their neighbours.
TEST(EnvelopeTest, TrimsNeighboursInPlace) {
  Envelope envelope;
  WindowColumns list;
  std::vector<Window> windows;
  for (int i = 0; i < 20; ++i) {
    const double x = 0.1 * i;
    windows.push_back(Window::Over(
        {std::max(0.0, x - 0.07), std::min(kLength, x + 0.07)}, {x, 1, 0}));
    Append(windows.back(), list);
  }
  envelope.Trim(kLength, list);
  ASSERT_EQ(list.size, windows.size());
  for (size_t i = 0; i + 1 < list.size; ++i) {
    EXPECT_NEAR(list.end[i], 0.1 * static_cast<double>(i) + 0.05, 1e-14);
    EXPECT_EQ(list.end[i], list.begin[i + 1]);
  }
}

}  // namespace
}  // namespace geodesic
