#include "server/engine/computation_store.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

namespace geodesic::server {
namespace {

// Says what it weighs.
class WeightedComputation final : public Computation {
 public:
  explicit WeightedComputation(uint64_t bytes) : bytes_(bytes) {}
  absl::Status Advance(const Reach&, Checkpoint&) override {
    return absl::OkStatus();
  }
  DistanceField Field() const override { return {}; }
  absl::Status AddSource(const Source&) override { return absl::OkStatus(); }
  uint64_t bytes() const override { return bytes_; }

 private:
  const uint64_t bytes_;
};

FieldKey Key(uint32_t vertex, const std::string& mesh = "mesh") {
  return {.mesh_digest = mesh, .sources = {{VertexPoint{vertex}, 0}}};
}

class ComputationStoreTest : public ::testing::Test {
 protected:
  void Put(const FieldKey& key, uint64_t bytes) {
    store_.Put(key, {mesh_, std::make_unique<WeightedComputation>(bytes)});
  }

  std::shared_ptr<const ResidentMesh> mesh_ =
      std::make_shared<const ResidentMesh>();
  ComputationStore store_{100};
};

TEST_F(ComputationStoreTest, WhoTakesOneHasItAlone) {
  Put(Key(0), 40);
  EXPECT_TRUE(store_.Contains(Key(0)));
  EXPECT_EQ(store_.used_bytes(), 40);
  PausedComputation taken = store_.Take(Key(0));
  ASSERT_NE(taken.computation, nullptr);
  EXPECT_EQ(taken.mesh, mesh_);
  EXPECT_EQ(store_.Take(Key(0)).computation, nullptr);
  EXPECT_EQ(store_.used_bytes(), 0);
  store_.Put(Key(0), std::move(taken));
  EXPECT_TRUE(store_.Contains(Key(0)));
}

TEST_F(ComputationStoreTest, TheOldestGoesFirst) {
  Put(Key(0), 40);
  Put(Key(1), 40);
  Put(Key(2), 40);
  EXPECT_FALSE(store_.Contains(Key(0)));
  EXPECT_TRUE(store_.Contains(Key(1)));
  EXPECT_EQ(store_.used_bytes(), 80);
  Put(Key(3), 100);
  EXPECT_EQ(store_.size(), 1);
  EXPECT_EQ(store_.used_bytes(), 100);
}

TEST_F(ComputationStoreTest, WhatNeverFitsIsDropped) {
  Put(Key(0), 40);
  Put(Key(1), 101);
  EXPECT_FALSE(store_.Contains(Key(1)));
  EXPECT_TRUE(store_.Contains(Key(0)));
}

TEST_F(ComputationStoreTest, TheFirstOfEqualOnesStays) {
  Put(Key(0), 40);
  Put(Key(0), 50);
  EXPECT_EQ(store_.size(), 1);
  EXPECT_EQ(store_.used_bytes(), 40);
}

TEST_F(ComputationStoreTest, GoesWithItsMesh) {
  Put(Key(0), 20);
  Put(Key(0, "other"), 20);
  EXPECT_GT(mesh_.use_count(), 2);
  store_.EraseMesh("mesh");
  EXPECT_FALSE(store_.Contains(Key(0)));
  EXPECT_TRUE(store_.Contains(Key(0, "other")));
  store_.Clear();
  EXPECT_EQ(store_.size(), 0);
  EXPECT_EQ(store_.used_bytes(), 0);
  // The meshes are not pinned any more.
  EXPECT_EQ(mesh_.use_count(), 1);
}

}  // namespace
}  // namespace geodesic::server
