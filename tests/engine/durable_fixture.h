// An engine with a data folder, on one thread, with time standing still.

#ifndef GEODESIC_TESTS_ENGINE_DURABLE_FIXTURE_H_
#define GEODESIC_TESTS_ENGINE_DURABLE_FIXTURE_H_

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "server/engine/meshes/mesh_digest.h"
#include "server/engine/query_engine.h"
#include "tests/engine/engine_fixture.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/temporary_folder.h"

namespace geodesic::server::test {

inline constexpr uint64_t kMiB = uint64_t{1} << 20;

inline TriangleSoup Grid(uint32_t columns, uint32_t rows = 12) {
  return geodesic::test::MakeGrid({.columns = columns, .rows = rows});
}

class DurableEngineTest : public EngineActions {
 protected:
  QueryEngine& engine() override { return *engine_; }
  void SetUp() override { Restart(); }
  void TearDown() override { Stop(); }

  void Stop() {
    if (engine_ == nullptr) return;
    engine_->scheduler().StopAll();
    executor_.RunAll();
    engine_.reset();
  }

  // A new engine on the same folder.
  void Restart() {
    Stop();
    engine_ = std::make_unique<QueryEngine>(
        limits_, clock_, executor_,
        [this](const Mesh& mesh, const ValidQuery& query,
               const SolveOptions& options) {
          if (at_start_) at_start_();
          return StartComputation(mesh, query, options);
        });
    auto store = DurableStore::Open({.path = data_dir(),
                                     .mesh_bytes = limits_.mesh_disk_bytes,
                                     .field_bytes = limits_.field_disk_bytes,
                                     .warn = [this](const std::string& line) {
                                       warnings_.push_back(line);
                                     }});
    ASSERT_TRUE(store.ok()) << store.status();
    engine_->Attach(*std::move(store), version_);
  }

  // What a request for the mesh is told, when it is.
  std::shared_ptr<const absl::StatusOr<MeshHandle>> AskFor(
      const std::string& digest) {
    const auto told = std::make_shared<absl::StatusOr<MeshHandle>>(
        absl::UnknownError("not told"));
    auto ticket = engine_->meshes().Await(
        digest, [told](const auto& mesh) { *told = mesh; });
    if (!ticket.ok()) *told = ticket.status();
    return told;
  }

  // The same, once the jobs have run.
  absl::StatusOr<MeshHandle> Await(const std::string& digest) {
    const auto told = AskFor(digest);
    executor_.RunAll();
    return *told;
  }

  // The field from vertex 0; the mesh must be in memory.
  absl::StatusOr<FieldAnswer> Field(FieldRequest request) {
    request.query.sources = {{VertexPoint{0}}};
    auto observer = std::make_shared<RecordingObserver>();
    auto call = engine_->fields().Compute(request, observer);
    if (!call.ok()) return call.status();
    executor_.RunAll();
    if (call->answer) return *call->answer;
    return *observer->answer;
  }

  std::vector<std::string> Listed() {
    std::vector<std::string> digests;
    const absl::StatusOr<MeshPage> page = engine_->meshes().List(0, "");
    EXPECT_TRUE(page.ok()) << page.status();
    for (const MeshDescription& mesh : page->meshes) {
      digests.push_back(mesh.digest);
    }
    return digests;
  }

  std::string data_dir() const { return temporary_ / "data"; }
  std::string FileOf(const std::string& digest) const {
    return data_dir() + "/meshes/" + digest + ".mesh";
  }
  static std::string DigestOf(const TriangleSoup& soup) {
    return MeshDigest(soup);
  }

  Limits limits_ = {.max_concurrent_jobs = 1,
                    .max_queued_jobs = 10,
                    .mesh_store_bytes = 64 * kMiB,
                    .field_cache_bytes = 16 * kMiB,
                    .upload_memory_bytes = 1024 * kMiB,
                    .solver_memory_bytes = 256 * kMiB,
                    .mesh_disk_bytes = 64 * kMiB,
                    .field_disk_bytes = 16 * kMiB};
  std::string version_ = "1";  // of the program
  geodesic::test::TemporaryFolder temporary_;
  std::vector<std::string> warnings_;
  std::function<void()> at_start_;  // of a computation
  std::unique_ptr<QueryEngine> engine_;
};

// The same, and a mesh that is held.
class HeldMeshTest : public DurableEngineTest {
 protected:
  void Hold(const TriangleSoup& soup) {
    mesh_ = *engine_->meshes().Get(Upload(soup).value().mesh.digest);
  }

  // Forgets the mesh, and takes it from disk.
  void RestartWithMesh() {
    executor_.RunAll();  // writes fields
    const std::string digest = std::exchange(mesh_, nullptr)->digest;
    Restart();
    mesh_ = *Await(digest);
  }

  MeshHandle mesh_;
};

}  // namespace geodesic::server::test

#endif  // GEODESIC_TESTS_ENGINE_DURABLE_FIXTURE_H_
