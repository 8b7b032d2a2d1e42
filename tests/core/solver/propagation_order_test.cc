// Proposition 1 of Xu et al. 2015: the order in which windows are propagated
// does not matter. A queue that pops at random must give the same field.

#include <algorithm>
#include <cstdint>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "geodesic/solve.h"
#include "gtest/gtest.h"
#include "solver/propagation.h"
#include "solver/queues/queue.h"
#include "solver/rules/ch_rule.h"
#include "solver/rules/list_rule.h"
#include "solver/rules/mmp_rule.h"
#include "tests/support/curved_meshes.h"
#include "tests/support/planar_meshes.h"
#include "tests/support/queries.h"

namespace geodesic {
namespace {

class RandomQueue {
 public:
  static constexpr bool kStrict = false;

  explicit RandomQueue(const Tuning& tuning) : random_(tuning.max_batch) {}

  void Push(uint32_t id, double) { ids_.push_back(id); }
  uint32_t Pop() {
    if (ids_.empty()) return kNothing;
    std::swap(ids_[random_() % ids_.size()], ids_.back());
    const uint32_t id = ids_.back();
    ids_.pop_back();
    ++iterations_;
    return id;
  }
  uint32_t Upcoming(uint32_t) const { return kNothing; }
  void Restart() {}
  double SettledRadius() const { return 0; }
  uint64_t size() const { return ids_.size(); }
  uint64_t iterations() const { return iterations_; }
  uint64_t bytes() const { return ids_.capacity() * sizeof(uint32_t); }

 private:
  std::mt19937 random_;
  std::vector<uint32_t> ids_;
  uint64_t iterations_ = 0;
};

template <template <typename> typename Rule>
void ExpectOrderDoesNotMatter(TriangleSoup soup) {
  const auto mesh = *Mesh::Build(std::move(soup));
  const ValidQuery query = test::Valid(
      *mesh, {.sources = {{VertexPoint{3}}, {VertexPoint{40}, 0.5}}});
  NoCheckpoint checkpoint;
  const auto expected = Solve(*mesh, query, {}, checkpoint);
  ASSERT_TRUE(expected.ok());
  for (uint32_t seed : {1u, 2u, 3u}) {
    const Tuning tuning{.bucket_width = 1, .max_batch = seed};
    Propagation<Rule, RandomQueue> propagation(*mesh, query, tuning, nullptr);
    ASSERT_TRUE(propagation.Advance({}, checkpoint).ok());
    const DistanceField field = propagation.Field();
    for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      ASSERT_NEAR(field.distances[v], expected->distances[v],
                  1e-12 * expected->distances[v])
          << "vertex " << v << ", seed " << seed;
    }
    EXPECT_LE(field.statistics.windows_propagated,
              field.statistics.windows_created);
  }
}

template <typename T>
class PropagationOrderTest : public ::testing::Test {};

struct Ch {
  template <typename Front>
  using Rule = ChRule<Front>;
};
struct Ich {
  template <typename Front>
  using Rule = IchRule<Front>;
};
struct Mmp {
  template <typename Front>
  using Rule = MmpRule<Front>;
};
struct List {
  template <typename Front>
  using Rule = ListRule<Front>;
};
using Rules = ::testing::Types<Ch, Ich, Mmp, List>;
TYPED_TEST_SUITE(PropagationOrderTest, Rules);

TYPED_TEST(PropagationOrderTest, OnTerrain) {
  ExpectOrderDoesNotMatter<TypeParam::template Rule>(
      test::Terrain(10, 10, 1.0, 3));
}

TYPED_TEST(PropagationOrderTest, OnTiesOfAGrid) {
  ExpectOrderDoesNotMatter<TypeParam::template Rule>(
      test::MakeGrid({.columns = 9, .rows = 9}));
}

TYPED_TEST(PropagationOrderTest, AroundAHole) {
  ExpectOrderDoesNotMatter<TypeParam::template Rule>(
      test::MakeGrid(test::WithHole({.columns = 9, .rows = 9})));
}

TYPED_TEST(PropagationOrderTest, OnNeedles) {
  ExpectOrderDoesNotMatter<TypeParam::template Rule>(
      test::MakeGrid({.columns = 12,
                      .rows = 4,
                      .cell_width = 1e-6,
                      .diagonals = test::Diagonals::kAlternating}));
}

TYPED_TEST(PropagationOrderTest, OnAClosedSurfaceWithSaddles) {
  ExpectOrderDoesNotMatter<TypeParam::template Rule>(
      test::Torus({.around = 10, .across = 6, .noise = 0.2}));
}

}  // namespace
}  // namespace geodesic
