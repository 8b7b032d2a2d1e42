// Meshes that come back from disk to memory.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "server/engine/base/status_details.h"
#include "tests/engine/durable_fixture.h"

namespace geodesic::server {
namespace {

using test::DurableEngineTest;
using test::Grid;
using ::testing::HasSubstr;
using ::testing::SizeIs;

TEST_F(DurableEngineTest, OneLoadForAllWhoAsk) {
  const std::string digest = Upload(Grid(5))->mesh.digest;
  Restart();
  std::vector<MeshHandle> meshes;
  std::vector<MeshLoads::Ticket> tickets;
  for (int i = 0; i < 5; ++i) {
    auto ticket = engine_->meshes().Await(digest, [&](const auto& mesh) {
      ASSERT_TRUE(mesh.ok());
      meshes.push_back(*mesh);
    });
    ASSERT_TRUE(ticket.ok());
    tickets.push_back(*ticket);
  }
  EXPECT_EQ(engine_->meshes().loads().size(), 1);
  engine_->meshes().Leave(tickets[0]);
  executor_.RunAll();
  EXPECT_THAT(meshes, SizeIs(4));
  EXPECT_EQ(engine_->counters().meshes_loaded, 1);
  EXPECT_EQ(engine_->meshes().loads().size(), 0);
}

// Room in memory for one mesh.
class EvictionTest : public DurableEngineTest {
 protected:
  EvictionTest() {
    limits_.mesh_store_bytes = Mesh::EstimateResidentBytes(182, 312) + 4096;
  }
};

TEST_F(EvictionTest, WhatMemoryForgotComesBackByItself) {
  const std::string first = Upload(Grid(12))->mesh.digest;
  const std::string second = Upload(Grid(13))->mesh.digest;
  EXPECT_TRUE(absl::IsNotFound(engine_->meshes().Get(first).status()));
  EXPECT_TRUE(engine_->meshes().Contains(first));
  for (int round = 0; round < 3; ++round) {
    for (const std::string& digest : {first, second}) {
      const auto mesh = Await(digest);
      ASSERT_TRUE(mesh.ok()) << mesh.status();
      EXPECT_EQ((*mesh)->digest, digest);
    }
  }
  EXPECT_EQ(engine_->counters().meshes_loaded, 6);
  EXPECT_THAT(Listed(), SizeIs(2));
}

TEST_F(EvictionTest, RoomIsTakenBeforeALoad) {
  const std::string first = Upload(Grid(12))->mesh.digest;
  ASSERT_TRUE(Upload(Grid(13)).ok());
  const auto pinned = engine_->meshes().Get(DigestOf(Grid(13)));
  ASSERT_TRUE(pinned.ok());
  const absl::Status status = Await(first).status();
  EXPECT_TRUE(absl::IsResourceExhausted(status)) << status;
  EXPECT_TRUE(RetryAfter(status).has_value());
  // The mesh is not held against its file.
  EXPECT_TRUE(engine_->meshes().Contains(first));
}

// The same with two threads, one of which computes a field on the second mesh
// while the first is asked for.
class LoadAdmissionTest : public EvictionTest {
 protected:
  LoadAdmissionTest() { limits_.max_concurrent_jobs = 2; }

  void SetUp() override {
    EvictionTest::SetUp();
    first_ = Upload(Grid(12))->mesh.digest;
    second_ = Upload(Grid(13))->mesh.digest;
  }

  // Asks for the first mesh from within the field's job and gives the load its
  // thread; then calls `act`.
  void LoadBeside(const std::function<void(const MeshLoads::Ticket&)>& act) {
    at_start_ = [&] {
      const auto ticket = engine_->meshes().Await(
          first_, [&](const auto& mesh) { loaded_ = mesh; });
      ASSERT_TRUE(ticket.ok());
      executor_.RunOne();
      EXPECT_FALSE(loaded_.has_value()) << loaded_->status();
      EXPECT_EQ(engine_->scheduler().queued(), 1);
      EXPECT_EQ(engine_->upload_memory().used(), 0) << "it only waits";
      act(*ticket);
    };
    const auto observer = std::make_shared<test::RecordingObserver>();
    FieldRequest request{.mesh_digest = second_};
    request.query.sources = {{VertexPoint{0}}};
    // The job alone pins the mesh.
    ASSERT_TRUE(engine_->fields().Compute(request, observer).ok());
    executor_.RunAll();
    EXPECT_EQ(engine_->meshes().loads().size(), 0);
    EXPECT_EQ(engine_->upload_memory().used(), 0);
    EXPECT_EQ(engine_->scheduler().queued(), 0);
  }

  std::string first_;
  std::string second_;
  std::optional<absl::StatusOr<MeshHandle>> loaded_;
};

TEST_F(LoadAdmissionTest, ALoadWaitsForTheMemoryThatAJobHolds) {
  LoadBeside([](const auto&) {});
  ASSERT_TRUE(loaded_.has_value());
  ASSERT_TRUE(loaded_->ok()) << loaded_->status();
  EXPECT_EQ((**loaded_)->digest, first_);
}

TEST_F(LoadAdmissionTest, WhoeverLeavesMeanwhileLeavesNothing) {
  LoadBeside([&](const MeshLoads::Ticket& ticket) {
    engine_->meshes().Leave(ticket);
  });
  EXPECT_FALSE(loaded_.has_value());
  EXPECT_EQ(engine_->counters().meshes_loaded, 0);
}

TEST_F(EvictionTest, WhatCanNeverBeLoadedIsRefusedAtOnceWithTheFigures) {
  const std::string digest = Upload(Grid(12))->mesh.digest;
  const auto refusal = [&] {
    Restart();
    return engine_->meshes()
        .Await(digest, [](const auto&) { FAIL(); })
        .status();
  };
  for (const auto& [budget, flag] :
       {std::pair(&limits_.upload_memory_bytes, "--limit upload-memory"),
        std::pair(&limits_.mesh_store_bytes, "--limit mesh-store")}) {
    const uint64_t enough = std::exchange(*budget, 1000);
    const absl::Status status = refusal();
    EXPECT_TRUE(absl::IsResourceExhausted(status)) << status;
    EXPECT_FALSE(RetryAfter(status).has_value());
    EXPECT_THAT(std::string(status.message()), HasSubstr("1000 bytes"));
    EXPECT_THAT(std::string(status.message()), HasSubstr(flag));
    *budget = enough;
  }
}

}  // namespace
}  // namespace geodesic::server
