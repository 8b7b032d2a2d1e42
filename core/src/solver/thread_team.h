// Threads that share one piece of work after the other.

#ifndef GEODESIC_SOLVER_THREAD_TEAM_H_
#define GEODESIC_SOLVER_THREAD_TEAM_H_

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

namespace geodesic {

// What one thread writes often is kept off the lines that others use.
inline constexpr size_t kCacheLine = 64;

// The thread that calls is a member too. It does not wait for members that have
// not begun: on a busy machine a member that gets no processor costs nothing.
// Between two calls the others spin for some microseconds, then sleep. For one
// calling thread at a time.
class ThreadTeam {
 public:
  // Has fewer members where the system has no more threads. REQUIRES: size
  // >= 1.
  explicit ThreadTeam(uint32_t size);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  uint32_t size() const { return static_cast<uint32_t>(threads_.size()) + 1; }

  // Calls work(0) here, and meanwhile work(member), 0 < member < size(), in the
  // other threads that begin before work(0) returns, each at most once. Returns
  // when all that have begun have returned; so each should go on until nothing
  // is left to do. What happened before the call happens before the work, and
  // the work before the return.
  template <typename Work>
  void Run(const Work& work) {
    Run(
        [](const void* of_type_work, uint32_t member) {
          (*static_cast<const Work*>(of_type_work))(member);
        },
        &work);
  }

 private:
  using Call = void (*)(const void* work, uint32_t member);

  void Run(Call call, const void* work);
  void Serve(uint32_t member);
  // Whether the work of this call may be begun; then Leave follows.
  bool Enter(uint32_t call);
  void Leave();

  Call call_ = nullptr;
  const void* work_ = nullptr;
  std::atomic<uint32_t> calls_ = 0;  // how many there have been
  // The number of the call, whether nobody may begin any more, and how many of
  // the others have begun and not returned.
  std::atomic<uint64_t> gate_ = 0;
  std::atomic<bool> is_over_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_THREAD_TEAM_H_
