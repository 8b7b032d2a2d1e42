// What must hold in a fuzz run, in every build.

#ifndef GEODESIC_TESTS_FUZZ_RPC_REQUIRE_H_
#define GEODESIC_TESTS_FUZZ_RPC_REQUIRE_H_

#include <cstdlib>

namespace geodesic::server::test {

// Aborts the program unless it holds: a fuzzer takes that for a crash.
inline void Require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace geodesic::server::test

#endif  // GEODESIC_TESTS_FUZZ_RPC_REQUIRE_H_
