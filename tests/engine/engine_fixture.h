// Engines on one thread with time standing still.

#ifndef GEODESIC_TESTS_ENGINE_ENGINE_FIXTURE_H_
#define GEODESIC_TESTS_ENGINE_ENGINE_FIXTURE_H_

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "server/engine/query_engine.h"
#include "tests/engine/fakes.h"
#include "tests/engine/uploads.h"

namespace geodesic::server::test {

// What tests do with an engine, whoever owns it.
class EngineActions : public ::testing::Test {
 protected:
  virtual QueryEngine& engine() = 0;

  absl::StatusOr<UploadResult> Upload(const UploadHeader& header,
                                      std::string_view bytes) {
    auto upload = engine().meshes().StartUpload(header);
    if (!upload.ok()) return upload.status();
    if (absl::Status s = (*upload)->Append(0, bytes); !s.ok()) return s;
    absl::StatusOr<UploadResult> result = absl::UnknownError("not told");
    auto job = engine().meshes().FinishUpload(
        *std::move(upload), [&](const auto& r) { result = r; });
    if (!job.ok()) return job.status();
    executor_.RunAll();
    return result;
  }
  absl::StatusOr<UploadResult> Upload(const TriangleSoup& soup) {
    return Upload(ArrayHeader(soup), ArrayBytes(soup));
  }

  absl::Status Delete(const std::string& digest) {
    absl::Status result = absl::UnknownError("not told");
    absl::Status status = engine().meshes().Delete(
        digest, [&](const absl::Status& told) { result = told; });
    if (!status.ok()) return status;
    executor_.RunAll();
    return result;
  }

  FakeClock clock_;
  ManualExecutor executor_;
};

class EngineTest : public EngineActions {
 protected:
  explicit EngineTest(Limits limits = SmallLimits())
      : engine_(limits, clock_, executor_,
                [this](const Mesh& mesh, const ValidQuery& query,
                       const SolveOptions& options) {
                  return start_(mesh, query, options);
                }) {}

  // The engine's end waits for its tasks.
  ~EngineTest() override {
    engine_.scheduler().StopAll();
    executor_.RunAll();
  }

  QueryEngine& engine() override { return engine_; }

  static Limits SmallLimits() {
    constexpr uint64_t kMiB = uint64_t{1} << 20;
    return {.max_upload_bytes = 16 * kMiB,
            .max_vertices = 100'000,
            .max_faces = 200'000,
            .max_sources = 10,
            .max_curve_points = 10,
            .max_targets = 100,
            .max_levels = 5,
            .max_samples = 20,
            .max_pairs = 1000,
            .max_matrix_rows = 50,
            .max_matrix_values = 10'000,
            .max_concurrent_jobs = 1,
            .max_queued_jobs = 2,
            .mesh_store_bytes = 64 * kMiB,
            .field_cache_bytes = 16 * kMiB,
            .upload_memory_bytes = 256 * kMiB,
            .solver_memory_bytes = 256 * kMiB};
  }

  StartFunction start_ = &StartComputation;
  QueryEngine engine_;
};

}  // namespace geodesic::server::test

#endif  // GEODESIC_TESTS_ENGINE_ENGINE_FIXTURE_H_
