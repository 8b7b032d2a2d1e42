// Proposition 1 of Xu et al. 2015: the order in which windows are propagated
// does not matter. A queue that pops at random must give the same field.

#include <cstdint>
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
#include "tests/support/field_check.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/planar_meshes.h"

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

// On curvature, ties, reflex corners, needles and a closed surface with
// saddles.
template <template <typename> typename Rule>
void ExpectOrderDoesNotMatter() {
  for (const test::NamedMesh& named : std::vector<test::NamedMesh>{
           {"terrain", test::Terrain(10, 10, 1.0, 3)},
           {"grid", test::MakeGrid({.columns = 9, .rows = 9})},
           {"hole", test::MakeGrid(test::WithHole({.columns = 9, .rows = 9}))},
           {"needles", test::MakeGrid({.columns = 12,
                       .rows = 4,
                       .cell_width = 1e-6,
                       .diagonals = test::Diagonals::kAlternating})},
           {"torus", test::Torus({.around = 10, .across = 6, .noise = 0.2})}}) {
    const auto mesh = test::BuildOrFail(named);
    const ValidQuery query = test::Valid(
        *mesh, {.sources = {{VertexPoint{3}}, {VertexPoint{40}, 0.5}}});
    NoCheckpoint checkpoint;
    const DistanceField expected = Solve(*mesh, query, {}, checkpoint).value();
    for (const uint32_t seed : {1u, 2u, 3u}) {
      const Tuning tuning{.bucket_width = 1, .max_batch = seed};
      Propagation<Rule, RandomQueue> propagation(*mesh, query, tuning, nullptr);
      ASSERT_TRUE(propagation.Advance({}, checkpoint).ok());
      const DistanceField field = propagation.Field();
      for (uint32_t v = 0; v < mesh->vertex_count(); ++v) {
        ASSERT_NEAR(field.distances[v], expected.distances[v],
                    1e-12 * expected.distances[v])
            << named.name << ", vertex " << v << ", seed " << seed;
      }
      EXPECT_LE(field.statistics.windows_propagated,
                field.statistics.windows_created);
    }
  }
}

TEST(PropagationOrder, DoesNotMatterToCh) {
  ExpectOrderDoesNotMatter<ChRule>();
}
TEST(PropagationOrder, DoesNotMatterToIch) {
  ExpectOrderDoesNotMatter<IchRule>();
}
TEST(PropagationOrder, DoesNotMatterToMmp) {
  ExpectOrderDoesNotMatter<MmpRule>();
}
TEST(PropagationOrder, DoesNotMatterToLists) {
  ExpectOrderDoesNotMatter<ListRule>();
}

}  // namespace
}  // namespace geodesic
