// A child process that is killed at a chosen system call.

#ifndef GEODESIC_TESTS_STORE_TRACED_CHILD_H_
#define GEODESIC_TESTS_STORE_TRACED_CHILD_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace geodesic::server::test {

struct TracedRun {
  // Whether this platform lets a process trace its child.
  bool is_permitted = false;
  // The child came to its end; otherwise it was killed.
  bool has_ended = false;
  // The child had said that `work` succeeded.
  bool has_acknowledged = false;
  // The numbers of the system calls that `work` made, in order. That of the
  // acknowledgement is the last.
  std::vector<uint64_t> calls;
};

inline constexpr size_t kNeverKilled = std::numeric_limits<size_t>::max();

// Forks. The child does `prepare`, then `work`, and tells this process whether
// `work` returned true. It is killed (SIGKILL) just before `work` makes system
// call number `kill_before`, counted from 0.
TracedRun RunTraced(const std::function<void()>& prepare,
                    const std::function<bool()>& work,
                    size_t kill_before = kNeverKilled);

}  // namespace geodesic::server::test

#endif  // GEODESIC_TESTS_STORE_TRACED_CHILD_H_
