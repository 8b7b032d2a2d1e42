// Waiting for another process to notice something.

#ifndef GEODESIC_TESTS_SECURITY_UNTIL_H_
#define GEODESIC_TESTS_SECURITY_UNTIL_H_

#include <chrono>
#include <thread>

namespace geodesic::client {

// Asks again until `holds()`; false if that takes a minute.
template <typename Condition>
bool Until(Condition holds) {
  const auto patience =
      std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > patience) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return true;
}

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_SECURITY_UNTIL_H_
