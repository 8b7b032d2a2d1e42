// Random numbers that are the same on every machine: the standard fixes the
// engine's sequence but not what its distributions make of it.

#ifndef GEODESIC_TESTS_SUPPORT_RANDOM_H_
#define GEODESIC_TESTS_SUPPORT_RANDOM_H_

#include <cmath>
#include <cstdint>
#include <random>

namespace geodesic::test {

class Random {
 public:
  explicit Random(uint64_t seed) : engine_(seed) {}

  // In [low, high).
  double Uniform(double low, double high) {
    const double unit = static_cast<double>(engine_() >> 11) * 0x1p-53;
    return low + (high - low) * unit;
  }

  // In [low, high), each order of magnitude as likely as another. REQUIRES: low
  // is above 0.
  double OfAnySize(double low, double high) {
    return low * std::pow(high / low, Uniform(0, 1));
  }

  // In [0, count). REQUIRES: count > 0.
  uint32_t Below(uint32_t count) {
    return static_cast<uint32_t>(engine_() % count);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_RANDOM_H_
