// Many threads at once; meant for ThreadSanitizer as much as for its results.

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <condition_variable>
#include <cstdint>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "server/engine/jobs/thread_pool.h"
#include "server/engine/query_engine.h"
#include "tests/engine/uploads.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/planar_meshes.h"

namespace geodesic::server {
namespace {

constexpr int kThreads = 8;

void OnThreads(const std::function<void(int)>& work) {
  std::vector<std::jthread> threads;
  for (int i = 0; i < kThreads; ++i) threads.emplace_back(work, i);
}

// A value that knows whether it has been destroyed.
struct Canary {
  explicit Canary(int v) : value(v), twin(std::make_unique<int>(v)) {}
  int value;
  std::unique_ptr<int> twin;
};

TEST(Concurrency, TheStoreStaysWithinItsBudget) {
  constexpr uint64_t kCapacity = 1000;
  LruStore<int, Canary> store("test store", kCapacity);
  std::atomic<uint64_t> refused = 0;
  std::atomic<bool> exceeded = false;
  OnThreads([&](int thread) {
    uint64_t state = thread + 1;
    std::shared_ptr<const Canary> held;
    for (int i = 0; i < 5000; ++i) {
      state = state * 6364136223846793005u + 1442695040888963407u;
      const int key = static_cast<int>(state >> 33) % 64;
      if (auto found = store.Find(key)) {
        ASSERT_EQ(found->value, key);
        ASSERT_EQ(*found->twin, key);
        held = std::move(found);
      } else if (auto room = store.Reserve(50 + key); room.ok()) {
        held = store.Insert(key, Canary(key), *std::move(room)).value;
        ASSERT_EQ(*held->twin, key);
      } else {
        ++refused;
        held.reset();
      }
      if (i % 97 == 0) store.Erase(key);
      if (store.used_bytes() > kCapacity) exceeded = true;
    }
  });
  EXPECT_FALSE(exceeded);
  // Nobody holds anything any more.
  EXPECT_TRUE(store.Reserve(kCapacity).ok());
  EXPECT_EQ(store.size(), 0);
}

// Waits for its field.
class WaitingObserver final : public FieldObserver {
 public:
  void OnProgress(const Progress&) override {}
  void OnField(const absl::StatusOr<FieldAnswer>& answer) override {
    answer_.set_value(answer);
  }
  absl::StatusOr<FieldAnswer> Wait() { return answer_.get_future().get(); }

 private:
  std::promise<absl::StatusOr<FieldAnswer>> answer_;
};

class EngineConcurrencyTest : public ::testing::Test {
 protected:
  std::string Upload(const TriangleSoup& soup) {
    auto upload = engine_.meshes().StartUpload(test::ArrayHeader(soup));
    EXPECT_TRUE(upload.ok()) << upload.status();
    EXPECT_TRUE((*upload)->Append(0, test::ArrayBytes(soup)).ok());
    const auto told =
        std::make_shared<std::promise<absl::StatusOr<UploadResult>>>();
    const auto job = engine_.meshes().FinishUpload(
        *std::move(upload),
        [told](const auto& result) { told->set_value(result); });
    EXPECT_TRUE(job.ok()) << job.status();
    const absl::StatusOr<UploadResult> result = told->get_future().get();
    EXPECT_TRUE(result.ok()) << result.status();
    return result.ok() ? result->mesh.digest : "failed";
  }

  SteadyClock clock_;
  ThreadPool pool_{4};
  QueryEngine engine_{{.max_concurrent_jobs = 4}, clock_, pool_};
};

TEST_F(EngineConcurrencyTest, EveryoneGetsTheSameField) {
  const std::string digest = Upload(geodesic::test::Icosphere(3));
  std::mutex mutex;
  std::vector<FieldHandle> fields[4];
  OnThreads([&](int thread) {
    for (int i = 0; i < 20; ++i) {
      const uint32_t vertex = (thread + i) % 4;
      const auto observer = std::make_shared<WaitingObserver>();
      const auto call = engine_.fields().Compute(
          {digest, {.sources = {{VertexPoint{vertex}, 0}}}}, observer);
      ASSERT_TRUE(call.ok()) << call.status();
      const auto answer = call->answer.has_value()
                              ? absl::StatusOr<FieldAnswer>(*call->answer)
                              : observer->Wait();
      ASSERT_TRUE(answer.ok()) << answer.status();
      std::lock_guard lock(mutex);
      fields[vertex].push_back(answer->field);
    }
  });
  for (const auto& same : fields) {
    EXPECT_FALSE(same.empty());
    for (const FieldHandle& field : same) EXPECT_EQ(field, same.front());
  }
  EXPECT_EQ(engine_.counters().solves_finished, 4);
}

TEST_F(EngineConcurrencyTest, CancelsAndDeletesLeaveNothingBehind) {
  const TriangleSoup soup = geodesic::test::Icosphere(3);
  const std::string digest = Upload(soup);
  OnThreads([&](int thread) {
    for (int i = 0; i < 30; ++i) {
      const uint32_t vertex = (thread * 7 + i) % 16;
      const auto observer = std::make_shared<WaitingObserver>();
      const auto call = engine_.fields().Compute(
          {digest, {.sources = {{VertexPoint{vertex}, 0}}}}, observer);
      if (!call.ok()) {
        EXPECT_TRUE(absl::IsNotFound(call.status())) << call.status();
        Upload(soup);
        continue;
      }
      if (i % 2 == 0) {
        engine_.fields().Cancel(*call);
      } else if (!call->answer.has_value()) {
        EXPECT_TRUE(observer->Wait().ok());
      }
      if (thread == 0 && i % 10 == 9)
        (void)engine_.meshes().Delete(digest, [](const absl::Status&) {});
    }
  });
  EXPECT_TRUE(engine_.scheduler().WaitIdle(std::chrono::seconds(60)));
  EXPECT_EQ(engine_.fields().jobs().size(), 0);
  const EngineCounters counters = engine_.counters();
  EXPECT_EQ(counters.solves_started,
            counters.solves_finished + counters.solves_stopped);
}

// Limited, progressive and traced fields of the same few sources,
// some of them cancelled: whatever is answered is right.
TEST_F(EngineConcurrencyTest, LimitedFieldsAreRight) {
  const TriangleSoup soup =
      geodesic::test::MakeGrid({.columns = 30, .rows = 30});
  const std::string digest = Upload(soup);
  OnThreads([&](int thread) {
    for (int i = 0; i < 40; ++i) {
      const uint32_t vertex = (thread + i) % 3;
      FieldRequest request{.mesh_digest = digest,
                           .query = {.sources = {{VertexPoint{vertex}, 0}}},
                           .reach = {.radius = 1.37 + (thread * 5 + i) % 40}};
      request.extras.settled_order = i % 3 == 1;
      request.extras.nearest_sources = i % 3 == 2;
      const auto observer = std::make_shared<WaitingObserver>();
      const auto call = engine_.fields().Compute(request, observer);
      ASSERT_TRUE(call.ok()) << call.status();
      if (i % 7 == 6) {
        engine_.fields().Cancel(*call);
        continue;
      }
      const auto answer = call->answer.has_value()
                              ? absl::StatusOr<FieldAnswer>(*call->answer)
                              : observer->Wait();
      ASSERT_TRUE(answer.ok()) << answer.status();
      const std::vector<double>& distances = answer->field->distances;
      uint64_t within = 0;
      for (size_t v = 0; v < distances.size(); ++v) {
        const double expected =
            std::hypot(soup.positions[v][0] - soup.positions[vertex][0],
                       soup.positions[v][1] - soup.positions[vertex][1]);
        if (expected > request.reach.radius) continue;
        ++within;
        ASSERT_NEAR(distances[v], expected, 1e-9);
      }
      if (request.extras.settled_order) {
        ASSERT_EQ(call->settled->size(), within);
      }
    }
  });
  EXPECT_TRUE(engine_.scheduler().WaitIdle(std::chrono::seconds(60)));
  EXPECT_EQ(engine_.fields().jobs().size(), 0);
}

// Takes all rows on the threads that compute them.
class TakingObserver {
 public:
  void OnRow() {
    std::lock_guard lock(mutex_);
    TakeAll();
  }
  void SetRows(std::shared_ptr<MatrixRows> rows) {
    std::lock_guard lock(mutex_);
    rows_ = std::move(rows);
    TakeAll();
  }
  std::vector<AnswerRow> Wait(size_t count) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return taken_.size() == count; });
    return std::move(taken_);
  }

 private:
  void TakeAll() {
    while (rows_ != nullptr) {
      auto row = rows_->Take();
      if (!row.has_value()) break;
      // A matrix that has been taken whole has no more rows.
      ASSERT_TRUE(row->ok()) << row->status();
      taken_.push_back(**std::move(row));
    }
    changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::shared_ptr<MatrixRows> rows_;
  std::vector<AnswerRow> taken_;
};

TEST_F(EngineConcurrencyTest, MatricesShareTheThreads) {
  const TriangleSoup soup =
      geodesic::test::MakeGrid({.columns = 12, .rows = 12});
  const std::string digest = Upload(soup);
  OnThreads([&](int thread) {
    MatrixRequest request{.mesh_digest = digest};
    for (uint32_t v = 0; v < 30; ++v) {
      request.query.sources.push_back({VertexPoint{v + thread}, 0});
    }
    if (thread % 4 == 3) {
      const auto call = engine_.rows().ComputeMatrix(request, [] {});
      ASSERT_TRUE(call.ok()) << call.status();
      call->rows->Cancel();
      return;
    }
    const auto observer = std::make_shared<TakingObserver>();
    const auto call = engine_.rows().ComputeMatrix(
        request, [observer] { observer->OnRow(); });
    ASSERT_TRUE(call.ok()) << call.status();
    observer->SetRows(call->rows);
    const std::vector<AnswerRow> rows = observer->Wait(30);
    for (uint32_t r = 0; r < rows.size(); ++r) {
      for (size_t v = 0; v < soup.positions.size(); ++v) {
        ASSERT_NEAR(
            rows[r].values[v],
            std::hypot(soup.positions[v][0] - soup.positions[r + thread][0],
                       soup.positions[v][1] - soup.positions[r + thread][1]),
            1e-9);
      }
    }
  });
  EXPECT_TRUE(engine_.scheduler().WaitIdle(std::chrono::seconds(60)));
}

TEST_F(EngineConcurrencyTest, TheSameMeshFromEveryoneIsKeptOnce) {
  const TriangleSoup soup = geodesic::test::Icosphere(2);
  OnThreads([&](int) {
    for (int i = 0; i < 5; ++i) Upload(soup);
  });
  const auto page = engine_.meshes().List(0, "");
  ASSERT_TRUE(page.ok());
  ASSERT_EQ(page->meshes.size(), 1);
  EXPECT_LT(engine_.meshes().store().used_bytes(),
            page->meshes[0].resident_bytes + 1024);
}

}  // namespace
}  // namespace geodesic::server
