// Decimated meshes are made once, kept within their budget, and go with their
// meshes.

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "server/engine/methods/decimation_engine.h"
#include "tests/engine/durable_fixture.h"
#include "tests/support/curved_meshes.h"

namespace geodesic::server {
namespace {

using test::DurableEngineTest;

constexpr uint64_t kFaces = 1280;

class DecimationsTest : public DurableEngineTest {
 protected:
  using Told = std::optional<absl::StatusOr<DecimationHandle>>;

  void SetUp() override {
    DurableEngineTest::SetUp();
    Upload();
  }

  void Upload() {
    const auto uploaded =
        DurableEngineTest::Upload(geodesic::test::Icosphere(3));
    ASSERT_TRUE(uploaded.ok()) << uploaded.status();
    mesh_ = *engine().meshes().Get(uploaded->mesh.digest);
    ASSERT_EQ(mesh_->mesh->face_count(), kFaces);
  }

  void RestartWithMesh() {
    const std::string digest = std::exchange(mesh_, nullptr)->digest;
    Restart();
    mesh_ = *Await(digest);
  }

  absl::StatusOr<DecimationJobs::Ticket> Ask(uint64_t max_faces,
                                             std::shared_ptr<Told> told) {
    return engine().decimations().Decimate(
        mesh_, max_faces,
        {.done =
             [told](const absl::StatusOr<DecimationHandle>& made) {
               *told = made;
             }},
        {});
  }

  absl::StatusOr<DecimationHandle> Decimate(uint64_t max_faces) {
    const auto told = std::make_shared<Told>();
    const auto ticket = Ask(max_faces, told);
    if (!ticket.ok()) return ticket.status();
    executor_.RunAll();
    return told->value_or(absl::UnknownError("not told"));
  }

  const DecimationStore& store() { return engine().meshes().decimations(); }

  MeshHandle mesh_;
};

TEST_F(DecimationsTest, EqualOnesAreOneAndAreKept) {
  const auto a = std::make_shared<Told>(), b = std::make_shared<Told>(),
             other = std::make_shared<Told>();
  ASSERT_TRUE(Ask(100, a).ok());
  ASSERT_TRUE(Ask(100, b).ok());
  ASSERT_TRUE(Ask(200, other).ok());
  executor_.RunAll();
  ASSERT_TRUE((*a)->ok() && (*b)->ok() && (*other)->ok());
  EXPECT_EQ(***a, ***b);
  EXPECT_LE((***a)->size(), 100);
  EXPECT_GT((***other)->size(), 100);
  EXPECT_EQ(engine().decimations().made(), 2);
  EXPECT_EQ(*Decimate(100), ***a) << "it was there";
  EXPECT_EQ(engine().decimations().made(), 2);
  EXPECT_EQ(store().size(), 2);
  EXPECT_EQ(engine().solver_memory().used(), 0);
}

TEST_F(DecimationsTest, LimitsThatChangeNothingAreOne) {
  EXPECT_EQ((*Decimate(kFaces))->size(), kFaces);
  EXPECT_EQ((*Decimate(UINT64_MAX))->size(), kFaces);
  EXPECT_EQ(engine().decimations().made(), 1);
}

TEST_F(DecimationsTest, IsCharged) {
  const DecimationHandle made = *Decimate(100);
  EXPECT_GE(store().used_bytes(), made->size() * sizeof(Triangle));
  limits_.decimated_memory_bytes = store().used_bytes() * 3 / 2;
  RestartWithMesh();
  ASSERT_TRUE(Decimate(100).ok());
  ASSERT_TRUE(Decimate(102).ok());
  EXPECT_EQ(store().size(), 1);
  EXPECT_EQ(store().evictions(), 1);

  limits_.decimated_memory_bytes = 1000;
  RestartWithMesh();
  const absl::Status refused = Decimate(100).status();
  EXPECT_TRUE(absl::IsResourceExhausted(refused)) << refused;
  EXPECT_NE(refused.message().find("--decimated-memory"), std::string::npos);
  EXPECT_EQ(engine().decimations().made(), 0) << "refused before the work";
}

TEST_F(DecimationsTest, TheWorkIsChargedToo) {
  limits_.solver_memory_bytes = 10'000;
  RestartWithMesh();
  EXPECT_TRUE(absl::IsResourceExhausted(Decimate(100).status()));
}

TEST_F(DecimationsTest, GoesWithItsMesh) {
  ASSERT_TRUE(Decimate(100).ok());
  EXPECT_GT(store().used_bytes(), 0);
  absl::Status deleted = absl::UnknownError("not told");
  ASSERT_TRUE(
      engine()
          .meshes()
          .Delete(mesh_->digest, [&](const absl::Status& s) { deleted = s; })
          .ok());
  executor_.RunAll();
  EXPECT_TRUE(deleted.ok()) << deleted;
  EXPECT_EQ(store().size(), 0);
  EXPECT_EQ(store().used_bytes(), 0);
  // This test still holds the mesh; nothing is kept of one that is gone.
  ASSERT_TRUE(Decimate(100).ok());
  EXPECT_EQ(store().size(), 0);
}

TEST_F(DecimationsTest, NobodyWaitingStopsTheWork) {
  const auto told = std::make_shared<Told>();
  const auto ticket = Ask(100, told);
  ASSERT_TRUE(ticket.ok());
  // At its first look at the clock the job is under way.
  clock_.at_look = [&] {
    clock_.at_look = nullptr;
    engine().decimations().Leave(*ticket);
  };
  executor_.RunAll();
  EXPECT_FALSE(told->has_value());
  EXPECT_EQ(engine().decimations().made(), 0);
  EXPECT_EQ(store().size(), 0);
  EXPECT_EQ(engine().solver_memory().used(), 0);
}

TEST_F(DecimationsTest, NoFacesIsNoLimit) {
  const absl::Status status = Decimate(0).status();
  EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
}

}  // namespace
}  // namespace geodesic::server
