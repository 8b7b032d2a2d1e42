#include "server/engine/searches/search_pool.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <utility>

#include "tests/engine/fakes.h"
#include "tests/support/meshes/curved_meshes.h"

namespace geodesic::server {
namespace {

MeshHandle Sphere(uint32_t levels) {
  auto mesh = Mesh::Build(geodesic::test::Icosphere(levels));
  EXPECT_TRUE(mesh.ok()) << mesh.status();
  return std::make_shared<const ResidentMesh>(
      ResidentMesh{.mesh = *std::move(mesh)});
}

class SearchPoolTest : public ::testing::Test {
 protected:
  void LendAndGiveBack(const MeshHandle& mesh) {
    SearchPool::Loan loan = pool_->Lend(mesh);
    loan.GiveBack();
  }

  test::FakeClock clock_;
  std::shared_ptr<ByteBudget> memory_ =
      std::make_shared<ByteBudget>("solver memory", 64 << 20);
  std::shared_ptr<SearchPool> pool_ =
      std::make_shared<SearchPool>(clock_, memory_, /*most=*/2);
  MeshHandle mesh_ = Sphere(2);
  MeshHandle other_ = Sphere(1);
};

TEST_F(SearchPoolTest, ChargesWhatIsIdle) {
  {
    SearchPool::Loan loan = pool_->Lend(mesh_);
    EXPECT_EQ(memory_->used(), 0);
    const uint64_t bytes = loan->bytes();
    loan.GiveBack();
    EXPECT_EQ(memory_->used(), bytes);
  }
  EXPECT_EQ(pool_->idle(), 1);
  const SearchPool::Loan again = pool_->Lend(mesh_);
  EXPECT_EQ(pool_->idle(), 0);
  EXPECT_EQ(memory_->used(), 0);
}

TEST_F(SearchPoolTest, WhatIsNotGivenBackIsGone) {
  for (int i = 0; i < 2; ++i) const SearchPool::Loan loan = pool_->Lend(mesh_);
  EXPECT_EQ(pool_->idle(), 0);
  EXPECT_EQ(memory_->used(), 0);
  // Nor does it stand in the way of others.
  LendAndGiveBack(mesh_);
  LendAndGiveBack(other_);
  EXPECT_EQ(pool_->idle(), 2);
}

TEST_F(SearchPoolTest, DropsTheLongestIdleForAnotherMesh) {
  LendAndGiveBack(mesh_);
  std::optional<SearchPool::Loan> first(pool_->Lend(other_));
  EXPECT_EQ(pool_->idle(), 1);
  std::optional<SearchPool::Loan> second(pool_->Lend(other_));
  EXPECT_EQ(pool_->idle(), 0);
  EXPECT_EQ(memory_->used(), 0);
  first->GiveBack();
  second->GiveBack();
  EXPECT_EQ(pool_->idle(), 2);
}

TEST_F(SearchPoolTest, GivesMemoryToWhoeverNeedsIt) {
  memory_->OnShortage([this] { pool_->DropIdle(); });
  LendAndGiveBack(mesh_);
  ASSERT_GT(memory_->used(), 0);
  EXPECT_TRUE(memory_->Take(memory_->capacity()).ok());
  EXPECT_EQ(pool_->idle(), 0);
  // Without memory a search is not kept.
  LendAndGiveBack(mesh_);
  EXPECT_EQ(pool_->idle(), 0);
  memory_->Return(memory_->capacity());
  EXPECT_EQ(memory_->used(), 0);
}

TEST_F(SearchPoolTest, DropsWhatWasIdleForLongOrHasNoMesh) {
  LendAndGiveBack(mesh_);
  pool_->DropOld();
  EXPECT_EQ(pool_->idle(), 1);
  LendAndGiveBack(other_);
  other_.reset();
  pool_->DropOld();
  EXPECT_EQ(pool_->idle(), 1);
  clock_.Advance(SearchPool::kPatience);
  pool_->DropOld();
  EXPECT_EQ(pool_->idle(), 0);
  EXPECT_EQ(memory_->used(), 0);
}

}  // namespace
}  // namespace geodesic::server
