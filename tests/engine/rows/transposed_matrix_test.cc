// Matrices with more sources than targets, which are computed from the targets.

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "geodesic/rows/kept_searches.h"
#include "geodesic/rows/matrix.h"
#include "geodesic/surface_point.h"
#include "tests/engine/engine_fixture.h"
#include "tests/support/meshes/planar_meshes.h"

namespace geodesic::server {
namespace {

using geodesic::test::MakeGrid;

class TransposedMatrixTest : public test::EngineTest {
 protected:
  explicit TransposedMatrixTest(Limits limits = WithoutLandmarks())
      : EngineTest(limits) {
    start_ = [this](const Mesh& mesh, const ValidQuery& query,
                    const SolveOptions& options) {
      ++fields_;
      used_ = engine_.solver_memory().used();
      return StartComputation(mesh, query, options);
    };
  }

  // With landmarks searches may take the place of fields.
  static Limits WithoutLandmarks() {
    Limits limits = SmallLimits();
    limits.landmark_memory_bytes = 0;
    return limits;
  }

  void SetUp() override {
    digest_ = Upload(MakeGrid({.columns = 10, .rows = 10})).value().mesh.digest;
    mesh_ = *engine_.meshes().Get(digest_);
  }

  // From places of every kind, most of them with an offset.
  MatrixRequest Request(uint32_t sources, std::vector<SurfacePoint> targets) {
    MatrixRequest request{.mesh_digest = digest_};
    for (uint32_t s = 0; s < sources; ++s) {
      const double offset = 0.25 * (s % 4);
      if (s % 3 == 0) {
        request.query.sources.push_back(
            {FacePoint{s, {0.5, 0.25, 0.25}}, offset});
      } else {
        request.query.sources.push_back({VertexPoint{s}, offset});
      }
    }
    request.query.targets = std::move(targets);
    return request;
  }

  MatrixCall Start(const MatrixRequest& request) {
    absl::StatusOr<MatrixCall> call =
        engine_.rows().ComputeMatrix(request, [] {});
    EXPECT_TRUE(call.ok()) << call.status();
    return *std::move(call);
  }

  std::vector<AnswerRow> Rows(const MatrixRequest& request) {
    const MatrixCall call = Start(request);
    fields_ = finished_ = 0;
    std::vector<AnswerRow> rows;
    while (rows.size() < call.row_count) {
      executor_.RunAll();
      const uint64_t finished = call.rows->rows_finished();
      EXPECT_GE(finished, finished_);
      EXPECT_LE(finished, call.row_count);
      finished_ = finished;
      if (auto row = call.rows->Take()) {
        EXPECT_TRUE(row->ok()) << row->status();
        rows.push_back(**std::move(row));
      }
    }
    EXPECT_EQ(call.rows->rows_finished(), call.row_count);
    EXPECT_FALSE(call.rows->Take().has_value());
    return rows;
  }

  std::string digest_;
  MeshHandle mesh_;
  // Of the last matrix:
  uint64_t fields_ = 0;    // computed, but by searches
  uint64_t used_ = 0;      // of the memory for solvers, by the last of them
  uint64_t finished_ = 0;  // rows, as was told
};

const std::vector<SurfacePoint> kTargets{
    VertexPoint{120}, FacePoint{7, {0.2, 0.3, 0.5}}, EdgePoint{3, 4, 0.25}};

// Whoever links the core alone has them from the same question.
TEST_F(TransposedMatrixTest, HasTheBitsOfTheCore) {
  KeptSearches searches(*mesh_->mesh);
  NoCheckpoint checkpoint;
  for (const uint32_t sources : {3, 40}) {
    for (const RowFilter& filter :
         {RowFilter(), RowFilter{.radius = 3, .sparse = true},
          RowFilter{.nearest = 2}}) {
      MatrixRequest request = Request(sources, kTargets);
      request.filter = filter;
      MatrixQuestion question =
          MatrixQuestion::Make(*mesh_->mesh,
                               *ValidQuery::Make(request.query, *mesh_->mesh),
                               filter, {}, searches)
              .value();
      if (question.TransposingPays()) question.Transpose();
      MatrixTable table(question);
      std::vector<DistanceRow> wanted;
      for (uint64_t line = 0; line < question.lines(); ++line) {
        wanted.push_back(question.Answer(line, checkpoint).value());
        if (question.is_transposed()) table.Add(line, wanted.back());
      }
      const std::vector<AnswerRow> rows = Rows(request);
      // Few are searched for; of many, each target has a field.
      if (!filter.sparse && !filter.nearest.has_value()) {
        EXPECT_EQ(fields_, sources == 3 ? 0 : 3);
      }
      for (size_t row = 0; row < rows.size(); ++row) {
        const DistanceRow expected =
            question.is_transposed() ? table.Row(row) : wanted[row];
        EXPECT_EQ(rows[row].columns, expected.columns);
        EXPECT_EQ(rows[row].values, expected.values);
      }
    }
  }
  engine_.searches().pool().DropIdle();
  EXPECT_EQ(engine_.solver_memory().used(), 0);
}

TEST_F(TransposedMatrixTest, ALineHasItsMemoryBeforeItBegins) {
  const MatrixRequest request = Request(1, {});
  Rows(request);
  KeptSearches searches(*mesh_->mesh);
  const MatrixQuestion question =
      MatrixQuestion::Make(*mesh_->mesh,
                           *ValidQuery::Make(request.query, *mesh_->mesh), {},
                           {}, searches)
          .value();
  EXPECT_EQ(used_, question.PlannedBytes() + question.LineBytes());
}

TEST_F(TransposedMatrixTest, GivesItsMemoryBackWhenNobodyWaits) {
  MatrixCall call = Start(Request(40, kTargets));
  EXPECT_GT(engine_.solver_memory().used(), 0);
  call.rows->Cancel();
  executor_.RunAll();
  EXPECT_EQ((*call.rows->Take()).status().code(), absl::StatusCode::kCancelled);
  call = {};
  EXPECT_EQ(engine_.solver_memory().used(), 0);
}

class LargeTableTest : public TransposedMatrixTest {
 protected:
  LargeTableTest() : TransposedMatrixTest(Tight()) {}

  static Limits Tight() {
    Limits limits = WithoutLandmarks();
    limits.max_matrix_rows = 100'000;
    limits.max_matrix_values = 1'000'000;
    limits.solver_memory_bytes = uint64_t{4} << 20;
    return limits;
  }
};

TEST_F(LargeTableTest, IsNotKept) {
  MatrixRequest request{.mesh_digest = digest_};
  request.query.targets = {VertexPoint{120}, VertexPoint{60}};
  request.query.sources.assign(12'000, {VertexPoint{5}});
  const MatrixCall call = Start(request);
  executor_.RunAll();
  ASSERT_TRUE(call.rows->Take().has_value());
  EXPECT_LT(call.rows->rows_finished(), 10);
  call.rows->Cancel();
  executor_.RunAll();
}

}  // namespace
}  // namespace geodesic::server
