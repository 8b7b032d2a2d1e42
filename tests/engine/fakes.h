// Time, threads and solvers under a test's control.

#ifndef GEODESIC_TESTS_ENGINE_FAKES_H_
#define GEODESIC_TESTS_ENGINE_FAKES_H_

#include <array>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "server/engine/base/clock.h"
#include "server/engine/fields/field_engine.h"
#include "server/engine/jobs/thread_pool.h"

namespace geodesic::server::test {

// Stands still until it is told to move.
class FakeClock final : public Clock {
 public:
  TimePoint Now() const override {
    if (at_look) at_look();
    return now_;
  }
  void Advance(Duration by) { now_ += by; }

  // Called whenever somebody looks at the time, as jobs do at each poll.
  std::function<void()> at_look;

 private:
  TimePoint now_ = TimePoint() + std::chrono::hours(1);
};

// Runs tasks when, and on the thread where, the test says so; those that
// compute come first, those beside last.
class ManualExecutor final : public Executor {
 public:
  void Schedule(Task task, ThreadKind kind) override {
    lines_[static_cast<size_t>(kind)].push_back(std::move(task));
  }

  bool RunOne() {
    for (std::deque<Task>& tasks : lines_) {
      if (tasks.empty()) continue;
      Task task = std::move(tasks.front());
      tasks.pop_front();
      std::move(task)();
      return true;
    }
    return false;
  }

  size_t RunAll() {
    size_t count = 0;
    while (RunOne()) ++count;
    return count;
  }

  size_t size() const {
    size_t all = 0;
    for (const std::deque<Task>& tasks : lines_) all += tasks.size();
    return all;
  }

 private:
  std::array<std::deque<Task>, kThreadKinds> lines_;
};

// Remembers what it was told. For tests on one thread.
class RecordingObserver final : public FieldObserver {
 public:
  void OnProgress(const Progress& progress) override {
    seen.push_back(progress);
    seen.back().distances = {};  // valid during this call only
  }
  void OnField(const absl::StatusOr<FieldAnswer>& a) override {
    ++calls;
    answer = a;
    if (a.ok()) {
      field = a->field;
    } else {
      field = a.status();
    }
  }

  std::vector<Progress> seen;
  std::optional<absl::StatusOr<FieldAnswer>> answer;
  std::optional<absl::StatusOr<FieldHandle>> field;  // of *answer
  int calls = 0;
};

}  // namespace geodesic::server::test

#endif  // GEODESIC_TESTS_ENGINE_FAKES_H_
