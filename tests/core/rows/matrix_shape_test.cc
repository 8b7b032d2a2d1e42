#include "rows/matrix_shape.h"

#include <gtest/gtest.h>

namespace geodesic {
namespace {

TEST(MatrixShapeTest, SearchingPaysForFewTargets) {
  EXPECT_TRUE(
      SearchingPays({.targets = 3, .wanted = 3, .field_in_searches = 12}));
  EXPECT_FALSE(
      SearchingPays({.targets = 12, .wanted = 12, .field_in_searches = 12}));
  EXPECT_TRUE(
      SearchingPays({.targets = 12, .wanted = 12, .field_in_searches = 76}));
  // A field stops early for the nearest one.
  EXPECT_FALSE(
      SearchingPays({.targets = 4, .wanted = 1, .field_in_searches = 12}));
  EXPECT_FALSE(SearchingPays({.targets = 1, .wanted = 1}));
}

TEST(MatrixShapeTest, TransposingPaysForFewTargetsOfManySources) {
  EXPECT_TRUE(TransposingPays({.sources = 1000, .targets = 3, .wanted = 3}));
  EXPECT_TRUE(TransposingPays(
      {.sources = 1000, .targets = 3, .wanted = 3, .field_in_searches = 76}));
  EXPECT_FALSE(
      TransposingPays({.sources = 3, .targets = 1000, .wanted = 1000}));
  EXPECT_FALSE(TransposingPays({.sources = 20, .targets = 20, .wanted = 20}));
  // Searches cost the same from either end.
  EXPECT_FALSE(TransposingPays(
      {.sources = 10, .targets = 3, .wanted = 3, .field_in_searches = 12}));
  // The nearest of many is found by a small part of a field.
  EXPECT_TRUE(TransposingPays({.sources = 1000, .targets = 20, .wanted = 1}));
  EXPECT_FALSE(TransposingPays({.sources = 1000, .targets = 40, .wanted = 1}));
}

}  // namespace
}  // namespace geodesic
