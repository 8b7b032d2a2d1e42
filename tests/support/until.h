#ifndef GEODESIC_TESTS_SUPPORT_UNTIL_H_
#define GEODESIC_TESTS_SUPPORT_UNTIL_H_

#include <chrono>
#include <thread>

namespace geodesic::test {

// Asks again until `holds()`; false if that takes two minutes.
template <typename Condition>
bool Until(Condition holds) {
  using std::chrono::steady_clock;
  const auto patience = steady_clock::now() + std::chrono::minutes(2);
  while (!holds()) {
    if (steady_clock::now() > patience) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_UNTIL_H_
