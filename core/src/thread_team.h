// Threads that do the same work together, again and again.

#ifndef GEODESIC_THREAD_TEAM_H_
#define GEODESIC_THREAD_TEAM_H_

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

namespace geodesic {

// The calling thread is a member too. Between two pieces of work the others
// spin for some microseconds, then sleep. Used by one thread at a time.
class ThreadTeam {
 public:
  // REQUIRES: size >= 1.
  explicit ThreadTeam(uint32_t size);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  uint32_t size() const { return static_cast<uint32_t>(threads_.size()) + 1; }

  // Calls work(member) in every member, from 0 (the calling thread) to
  // size() - 1, and returns when all have returned. What happened before
  // happens before the work, and the work before what follows.
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

  Call call_ = nullptr;
  const void* work_ = nullptr;
  std::atomic<uint32_t> calls_ = 0;    // how often there has been work
  std::atomic<uint32_t> working_ = 0;  // other members that have not returned
  std::atomic<bool> is_over_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace geodesic

#endif  // GEODESIC_THREAD_TEAM_H_
