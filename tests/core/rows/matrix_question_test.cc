// Matrices and nearest targets, as those who link the core alone ask for them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "geodesic/approximate/prepare.h"
#include "geodesic/computation.h"
#include "geodesic/rows/matrix.h"
#include "geodesic/target_search.h"
#include "geodesic_types/field_path.h"
#include "tests/core/rows/counting_means.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/queries.h"

namespace geodesic {
namespace {

using test::CountingMeans;
using test::MakeGrid;
using test::Valid;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

const std::vector<SurfacePoint> kTargets{
    VertexPoint{120}, FacePoint{7, {0.2, 0.3, 0.5}}, EdgePoint{3, 4, 0.25}};

// From places of every kind, most of them with an offset.
Query From(uint32_t sources, std::vector<SurfacePoint> targets) {
  Query query;
  for (uint32_t s = 0; s < sources; ++s) {
    const double offset = 0.25 * (s % 4);
    if (s % 3 == 0) {
      query.sources.push_back({FacePoint{s, {0.5, 0.25, 0.25}}, offset});
    } else {
      query.sources.push_back({VertexPoint{s}, offset});
    }
  }
  query.targets = std::move(targets);
  return query;
}

// On the grid geodesics are straight, so every distance is Euclid's.
class MatrixQuestionTest : public ::testing::Test {
 protected:
  absl::StatusOr<MatrixQuestion> Make(const Query& query,
                                      const RowFilter& filter = {},
                                      std::optional<RowMethod> method = {}) {
    return MatrixQuestion::Make(*mesh_, Valid(*mesh_, query), filter,
                                std::move(method), means_);
  }

  // Its rows, from columns where these cost less.
  std::vector<DistanceRow> Ask(MatrixQuestion question) {
    means_.fields = means_.loans = 0;
    const uint64_t count = question.rows();
    const uint64_t columns = question.columns();
    const bool pays = question.TransposingPays();
    if (pays) question.Transpose();
    EXPECT_EQ(question.is_transposed(), pays);
    EXPECT_EQ(question.rows(), count);
    EXPECT_EQ(question.columns(), columns);
    EXPECT_EQ(question.lines(), pays ? columns : count);
    std::vector<DistanceRow> lines(question.lines());
    for (uint64_t line = lines.size(); line-- > 0;) {
      absl::StatusOr<DistanceRow> answer = question.Answer(line, checkpoint_);
      EXPECT_TRUE(answer.ok()) << answer.status();
      EXPECT_LE(answer->bytes(), question.LineBytes());
      lines[line] = *std::move(answer);
    }
    if (!pays) return lines;
    MatrixTable table(question);
    for (uint64_t line = lines.size(); line-- > 0;) {
      table.Add(line, lines[line]);
    }
    const double error =
        std::ranges::max(lines, {}, &DistanceRow::certified_error)
            .certified_error;
    std::vector<DistanceRow> rows;
    for (uint64_t row = 0; row < count; ++row) {
      rows.push_back(table.Row(row));
      EXPECT_EQ(rows.back().certified_error, error);
    }
    return rows;
  }
  std::vector<DistanceRow> Ask(const Query& query,
                               const RowFilter& filter = {}) {
    return Ask(Make(query, filter).value());
  }

  double Expected(const Query& query, size_t row, size_t column) const {
    const Source& source = query.sources[row];
    const Point a = PositionOf(test::PointOf(source), *mesh_);
    const Point b = PositionOf(query.targets[column], *mesh_);
    return source.offset + std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }

  void ExpectEuclid(const Query& query, const std::vector<DistanceRow>& rows) {
    ASSERT_EQ(rows.size(), query.sources.size());
    for (size_t row = 0; row < rows.size(); ++row) {
      ASSERT_EQ(rows[row].values.size(), query.targets.size());
      EXPECT_TRUE(rows[row].columns.empty());
      for (size_t column = 0; column < query.targets.size(); ++column) {
        EXPECT_NEAR(rows[row].values[column], Expected(query, row, column),
                    1e-12)
            << row << ", " << column;
      }
    }
  }

  void MakeAllLandmarks() {
    ASSERT_TRUE(
        *means_.KeptSearches::MakeLandmarks(Landmarks::kMost, {}, checkpoint_));
  }

  const std::shared_ptr<const Mesh> mesh_ =
      Mesh::Build(MakeGrid({.columns = 10, .rows = 10})).value();
  CountingMeans means_{*mesh_};
  NoCheckpoint checkpoint_;
};

TEST_F(MatrixQuestionTest, WithoutTargetsEveryVertexIsAColumn) {
  const Query query = From(4, {});
  const std::vector<DistanceRow> rows = Ask(query);
  EXPECT_EQ(means_.fields, 4);
  for (const DistanceRow& row : rows) {
    EXPECT_EQ(row.values.size(), mesh_->vertex_count());
  }
  EXPECT_EQ(rows[1].values[1], query.sources[1].offset);
}

TEST_F(MatrixQuestionTest, FewTargetsAreSearchedFor) {
  const Query query = From(3, kTargets);
  ExpectEuclid(query, Ask(query));
  EXPECT_EQ(means_.fields, 0);
  EXPECT_EQ(means_.loans, 3);
}

TEST_F(MatrixQuestionTest, TheNearestOfTwoIsSearchedFor) {
  Query query{.sources = {{VertexPoint{0}}},
              .targets = {VertexPoint{120}, VertexPoint{13}}};
  EXPECT_EQ(Ask(query, {.nearest = 1})[0].columns, std::vector<uint32_t>{1});
  EXPECT_EQ(means_.fields, 0);
  // Of more the nearest is found by a small part of a field, and so is what is
  // within a radius.
  EXPECT_TRUE(std::isinf(Ask(query, {.radius = 4})[0].values[0]));
  EXPECT_EQ(means_.fields, 1);
  for (uint32_t v = 14; v < 18; ++v) query.targets.push_back(VertexPoint{v});
  Ask(query, {.nearest = 1});
  EXPECT_EQ(means_.fields, 1);
  EXPECT_EQ(means_.loans, 0);
}

TEST_F(MatrixQuestionTest, LandmarksMakeSearchesPayForMore) {
  std::vector<SurfacePoint> targets;
  for (uint32_t v = 0; v < 20; ++v) targets.push_back(VertexPoint{100 + v});
  const Query query = From(20, targets);
  ExpectEuclid(query, Ask(query));
  EXPECT_EQ(means_.fields, 20);
  MakeAllLandmarks();
  ExpectEuclid(query, Ask(query));
  EXPECT_EQ(means_.fields, 0);
  EXPECT_EQ(means_.loans, 20);
}

TEST_F(MatrixQuestionTest, ManySourcesTakeAFieldForEachTarget) {
  const Query query = From(40, kTargets);
  ExpectEuclid(query, Ask(query));
  EXPECT_EQ(means_.fields, kTargets.size());
}

TEST_F(MatrixQuestionTest, FindsTheNearestOfEachSource) {
  Query query = From(45, kTargets);
  // One of the two that are equally near is named: the first.
  query.targets.push_back(VertexPoint{120});
  const std::vector<DistanceRow> rows = Ask(query, {.nearest = 2});
  EXPECT_EQ(means_.fields, query.targets.size());
  for (size_t row = 0; row < rows.size(); ++row) {
    std::vector<uint32_t> order(query.targets.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](uint32_t column) {
      return Expected(query, row, column);
    });
    order.resize(2);
    EXPECT_EQ(rows[row].columns, order) << row;
    EXPECT_NEAR(rows[row].values[0], Expected(query, row, order[0]), 1e-12);
  }
}

TEST_F(MatrixQuestionTest, KeepsTheRadius) {
  const Query query = From(45, kTargets);
  const auto sparse = Ask(query, {.radius = 3, .sparse = true});
  EXPECT_EQ(means_.fields, kTargets.size());
  const auto dense = Ask(query, {.radius = 3});
  for (size_t row = 0; row < sparse.size(); ++row) {
    std::vector<uint32_t> within;
    for (uint32_t column = 0; column < kTargets.size(); ++column) {
      const double expected = Expected(query, row, column);
      if (expected <= 3) {
        within.push_back(column);
        EXPECT_NEAR(dense[row].values[column], expected, 1e-12);
      } else {
        EXPECT_EQ(dense[row].values[column], kInfinity);
      }
    }
    EXPECT_EQ(sparse[row].columns, within) << row;
  }
}

TEST_F(MatrixQuestionTest, CertifiesATolerance) {
  Query query = From(40, kTargets);
  query.tolerance = 1e-2;
  const std::vector<DistanceRow> rows = Ask(query);
  EXPECT_EQ(means_.fields, kTargets.size());
  for (size_t row = 0; row < rows.size(); ++row) {
    EXPECT_LE(rows[row].certified_error, 1e-2);
    for (size_t column = 0; column < kTargets.size(); ++column) {
      const double expected = Expected(query, row, column);
      EXPECT_NEAR(rows[row].values[column], expected,
                  (rows[row].certified_error + 1e-12) * expected);
    }
  }
}

TEST_F(MatrixQuestionTest, AsManyTargetsOrACurveTakeAFieldForEachSource) {
  std::vector<SurfacePoint> many;
  for (uint32_t v = 0; v < 20; ++v) many.push_back(VertexPoint{100 + v});
  EXPECT_FALSE(Make(From(20, many))->TransposingPays());
  Query curve = From(40, kTargets);
  curve.sources[7].place = Curve{{VertexPoint{0}, VertexPoint{1}}};
  Ask(curve);
  EXPECT_EQ(means_.fields, 1);
  EXPECT_EQ(means_.loans, 39);
}

TEST_F(MatrixQuestionTest, ApproximateRowsAreFieldsOfTheMethod) {
  const RowMethod fmm{
      ApproximateMethod::kFmm,
      PrepareMethod(*mesh_, ApproximateMethod::kFmm, {}, checkpoint_).value()};
  Query query = From(40, {VertexPoint{7}, VertexPoint{119}});
  const std::vector<DistanceRow> some = Ask(Make(query, {}, fmm).value());
  query.targets.clear();
  const std::vector<DistanceRow> all = Ask(Make(query, {}, fmm).value());
  for (size_t row = 0; row < some.size(); ++row) {
    const std::vector<double> field =
        fmm.prepared
            ->Distances(Valid(*mesh_, {.sources = {query.sources[row]}}),
                        checkpoint_)
            .value()
            .distances;
    EXPECT_EQ(all[row].values, field);
    EXPECT_EQ(some[row].values, (std::vector<double>{field[7], field[119]}));
  }
  EXPECT_EQ(means_.fields, 0);
  EXPECT_EQ(means_.loans, 0);
}

// A line's solver may be a field or a search. Beside it there are the field's
// distances and those of the targets, which a sparse row has numbers for, and
// within a tolerance what is certified of each vertex.
TEST_F(MatrixQuestionTest, PlansForAllThatALineTakes) {
  const uint64_t vertices = mesh_->vertex_count();
  Query query = From(1, kTargets);
  EXPECT_GE(Make(query)->PlannedBytes(),
            TargetSearch::PlannedBytes(*mesh_, Valid(*mesh_, query)));
  // With so many a field takes more.
  query.targets.assign(200'000, VertexPoint{7});
  EXPECT_GE(Make(query)->PlannedBytes(),
            PlannedSolverBytes(*mesh_, Valid(*mesh_, query)));
  constexpr uint64_t kInRow = sizeof(double) + sizeof(uint32_t);
  EXPECT_GE(Make(query)->LineBytes(),
            vertices * sizeof(double) + query.targets.size() * kInRow);
  query = From(1, {});
  query.tolerance = 1e-2;
  EXPECT_GE(Make(query)->LineBytes(), vertices * (kInRow + sizeof(float)));
}

TEST_F(MatrixQuestionTest, WhatIsWrongIsNamed) {
  const auto fault = [&](const Query& query, const RowFilter& filter,
                         std::optional<RowMethod> method = {}) {
    const absl::Status status = Make(query, filter, method).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    return FieldPathOf(status).value_or("none");
  };
  const Query query = From(2, kTargets);
  EXPECT_EQ(fault(query, {.radius = -1}), "radius");
  EXPECT_EQ(fault(query, {.radius = std::nan("")}), "radius");
  EXPECT_EQ(fault(query, {.nearest = 0}), "count");
  EXPECT_EQ(fault(From(2, {}), {.nearest = 3}), "targets");
  // Before the method is there.
  const RowMethod method{ApproximateMethod::kFmm, nullptr};
  EXPECT_EQ(fault(query, {}, method), "targets[1]");
  Query curve = From(2, {});
  curve.sources[1].place = Curve{{VertexPoint{0}, VertexPoint{1}}};
  EXPECT_EQ(fault(curve, {}, method), "sources[1].curve");
  EXPECT_TRUE(Make(From(2, {}), {}, method).ok());
}

}  // namespace
}  // namespace geodesic
