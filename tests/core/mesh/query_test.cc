#include "geodesic/query.h"

#include <cmath>
#include <limits>
#include <string>

#include "gmock/gmock.h"
#include "gtest/gtest.h"

namespace geodesic {
namespace {

using ::testing::HasSubstr;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string RefusalOf(const Query& query) {
  const absl::Status status = Validate(query, 10);
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument) << status;
  return std::string(status.message());
}

TEST(QueryTest, RefusalsNameTheSource) {
  EXPECT_THAT(RefusalOf({}), HasSubstr("sources is empty"));
  EXPECT_THAT(RefusalOf({.sources = {{0}, {10}}}),
              HasSubstr("sources[1].vertex 10"));
  for (double offset :
       {-1.0, kInfinity, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THAT(RefusalOf({.sources = {{3, offset}}}),
                HasSubstr("sources[0].offset"));
  }
  EXPECT_THAT(RefusalOf({.sources = {{0}}, .algorithm = Algorithm(99)}),
              HasSubstr("algorithm"));
}

TEST(QueryTest, EveryListedAlgorithmIsValidAndKnownByName) {
  for (const AlgorithmInfo& info : kAlgorithms) {
    EXPECT_TRUE(
        Validate({.sources = {{9}}, .algorithm = info.algorithm}, 10).ok());
    EXPECT_EQ(*AlgorithmFromName(info.name), info.algorithm);
    EXPECT_EQ(AlgorithmName(info.algorithm), info.name);
  }
  EXPECT_THAT(std::string(AlgorithmFromName("dijkstra").status().message()),
              HasSubstr("fwp-ch"));
}

TEST(QueryTest, CanonicalFormSortsAndKeepsTheLeastOffset) {
  const Query canonical =
      Canonicalize({.sources = {{5, 2}, {1, -0.0}, {5, 1}, {1, 0}, {3, 0}}});
  EXPECT_THAT(canonical.sources,
              ::testing::ElementsAre(Source{1, 0}, Source{3, 0}, Source{5, 1}));
  EXPECT_FALSE(std::signbit(canonical.sources[0].offset));
}

}  // namespace
}  // namespace geodesic
