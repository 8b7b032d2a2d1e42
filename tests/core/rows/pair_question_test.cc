// Pairs of points, as those who link the core alone ask for them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geodesic/approximate/prepare.h"
#include "geodesic/rows/pairs.h"
#include "geodesic/solve.h"
#include "geodesic_types/field_path.h"
#include "tests/core/rows/counting_means.h"
#include "tests/support/checkpoints.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/planar_meshes.h"

namespace geodesic {
namespace {

using test::CountingMeans;
using test::MakeGrid;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// On the grid geodesics are straight, so every distance is Euclid's.
class PairQuestionTest : public ::testing::Test {
 protected:
  void SetUp() override { Hold(MakeGrid({.columns = 10, .rows = 10})); }

  void Hold(const TriangleSoup& soup) {
    means_.reset();
    mesh_ = Mesh::Build(soup).value();
    means_.emplace(*mesh_);
  }

  absl::StatusOr<std::shared_ptr<const PairQuestion>> Make(
      std::vector<PointPair> pairs, PairOptions options = {},
      size_t threads = 1) {
    return PairQuestion::Make(*mesh_, std::move(pairs), std::move(options),
                              *means_, threads);
  }

  // All rows, the last one first, in order of the pairs.
  DistanceRow Ask(const PairQuestion& question) {
    means_->counts.clear();
    DistanceRow all;
    all.values.resize(question.pair_count(), -1);
    for (uint64_t row = question.rows().size(); row-- > 0;) {
      const absl::StatusOr<DistanceRow> answer =
          question.Answer(row, checkpoint_);
      EXPECT_TRUE(answer.ok()) << answer.status();
      EXPECT_EQ(answer->columns, question.rows()[row].pairs);
      EXPECT_LE(answer->values.size() * sizeof(double), question.RowBytes());
      for (size_t i = 0; i < answer->values.size(); ++i) {
        all.values[answer->columns[i]] = answer->values[i];
      }
      all.certified_error =
          std::max(all.certified_error, answer->certified_error);
      all.paths.insert(all.paths.begin(), answer->paths.begin(),
                       answer->paths.end());
    }
    return all;
  }
  DistanceRow Ask(std::vector<PointPair> pairs, PairOptions options = {}) {
    return Ask(*Make(std::move(pairs), std::move(options)).value());
  }

  double Euclid(const PointPair& pair) const {
    const Point a = PositionOf(pair.source, *mesh_);
    const Point b = PositionOf(pair.target, *mesh_);
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }

  void ExpectEuclid(const std::vector<PointPair>& pairs) {
    const std::vector<double> distances = Ask(pairs).values;
    for (size_t i = 0; i < pairs.size(); ++i) {
      EXPECT_NEAR(distances[i], Euclid(pairs[i]), 1e-12) << i;
    }
  }

  uint64_t count(AnsweredBy how) { return means_->counts[how]; }

  std::shared_ptr<const Mesh> mesh_;
  std::optional<CountingMeans> means_;
  NoCheckpoint checkpoint_;
};

// As many as are worth landmarks, on 441 vertices; no end is shared by so many
// that a field would pay.
std::vector<PointPair> ManyPairs() {
  std::vector<PointPair> pairs;
  for (uint32_t i = 0; i < 1000; ++i) {
    pairs.push_back({VertexPoint{i % 441}, VertexPoint{i * 5 % 441}});
  }
  return pairs;
}

TEST_F(PairQuestionTest, SearchesPairsOfAnyPoints) {
  const FacePoint in_face{7, {0.2, 0.3, 0.5}};
  const EdgePoint on_edge{3, 4, 0.25};
  ExpectEuclid({{VertexPoint{0}, VertexPoint{120}},
                {in_face, VertexPoint{5}},
                {on_edge, in_face},
                {VertexPoint{9}, VertexPoint{9}},
                {in_face, in_face}});
  EXPECT_EQ(count(AnsweredBy::kSearch), 5);
  EXPECT_EQ(means_->fields, 0);
  EXPECT_GT(means_->wishes, 0);
}

TEST_F(PairQuestionTest, AFieldAnswersManyThatShareAnEnd) {
  std::vector<PointPair> pairs;
  const FacePoint shared{100, {0.5, 0.25, 0.25}};
  for (uint32_t i = 0; i < kFieldInSearches; ++i) {
    const VertexPoint vertex{7 * i};
    pairs.push_back({VertexPoint{i}, VertexPoint{120 - i}});
    pairs.push_back(i % 2 == 0 ? PointPair{shared, vertex}
                               : PointPair{vertex, shared});
  }
  ExpectEuclid(pairs);
  EXPECT_EQ(count(AnsweredBy::kSearch), kFieldInSearches);
  EXPECT_EQ(count(AnsweredBy::kField), kFieldInSearches);
  EXPECT_EQ(means_->fields, 1);
}

// The other ends are targets of a field.
TEST_F(PairQuestionTest, PlansForTheOtherEndsOfARow) {
  const std::vector<PointPair> pairs(kFieldInSearches,
                                     {VertexPoint{0}, VertexPoint{120}});
  const auto question = Make(pairs).value();
  EXPECT_GE(question->RowBytes(),
            pairs.size() *
                (sizeof(double) + sizeof(uint32_t) + sizeof(SurfacePoint)));
}

TEST_F(PairQuestionTest, AFieldThatIsThereAnswersBothWays) {
  means_->kept_source = VertexPoint{60};
  means_->kept_field = std::make_shared<const DistanceField>(
      Solve(*mesh_, {.sources = {{VertexPoint{60}}}}).value());
  ExpectEuclid({{VertexPoint{60}, VertexPoint{3}},
                {VertexPoint{4}, VertexPoint{60}},
                {VertexPoint{4}, VertexPoint{5}},
                {VertexPoint{60}, EdgePoint{3, 4, 0.5}}});
  EXPECT_EQ(count(AnsweredBy::kKept), 2);
  EXPECT_EQ(count(AnsweredBy::kSearch), 2);
  std::vector<PointPair> star;
  for (uint32_t i = 0; i < 50; ++i) {
    star.push_back({VertexPoint{60}, VertexPoint{i}});
  }
  ExpectEuclid(star);
  EXPECT_EQ(count(AnsweredBy::kKept), 50);
  // Not where an end is no vertex, nor for a path.
  star.push_back({VertexPoint{60}, EdgePoint{3, 4, 0.5}});
  ExpectEuclid(star);
  EXPECT_EQ(count(AnsweredBy::kField), 51);
  Ask({{VertexPoint{60}, VertexPoint{3}}}, {.paths = true});
  EXPECT_EQ(count(AnsweredBy::kSearch), 1);
}

// All that is kept needs no search, but landmarks would help the next one.
TEST_F(PairQuestionTest, LendsNoSearchForWhatIsThere) {
  means_->kept_source = VertexPoint{60};
  means_->kept_field = std::make_shared<const DistanceField>(
      Solve(*mesh_, {.sources = {{VertexPoint{60}}}}).value());
  ExpectEuclid({{VertexPoint{60}, VertexPoint{3}}});
  EXPECT_EQ(means_->loans, 0);
  EXPECT_EQ(means_->wishes, 1);
}

TEST_F(PairQuestionTest, ManySearchesHaveLandmarksMadeOnce) {
  Hold(MakeGrid({.columns = 20, .rows = 20}));
  const std::vector<PointPair> pairs = ManyPairs();
  const auto question = Make(pairs).value();
  EXPECT_EQ(question->landmarks(), LandmarksWorth(pairs.size()));
  EXPECT_GE(question->PlannedBytes(), Landmarks::PlannedMakingBytes(*mesh_));
  const std::vector<double> distances = Ask(*question).values;
  EXPECT_EQ(means_->makings, 1);
  EXPECT_EQ(means_->landmarks()->count(), LandmarksWorth(pairs.size()));
  for (size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_NEAR(distances[i], Euclid(pairs[i]), 1e-12) << i;
  }
  // Fewer are not worth them.
  EXPECT_EQ((*Make({pairs.begin(), pairs.begin() + 999}))->landmarks(), 0);
}

TEST_F(PairQuestionTest, ALaterRowAsksAgainForLandmarks) {
  Hold(MakeGrid({.columns = 20, .rows = 20}));
  const auto question = Make(ManyPairs()).value();
  means_->can_make_landmarks = false;
  ASSERT_TRUE(question->Answer(0, checkpoint_).ok());
  ASSERT_TRUE(question->Answer(1, checkpoint_).ok());
  EXPECT_EQ(means_->landmarks(), nullptr);
  means_->can_make_landmarks = true;
  ASSERT_TRUE(question->Answer(2, checkpoint_).ok());
  ASSERT_TRUE(question->Answer(3, checkpoint_).ok());
  EXPECT_EQ(means_->makings, 3);
  EXPECT_NE(means_->landmarks(), nullptr);
}

TEST_F(PairQuestionTest, LandmarksAreMadeThoughTheirMakingWasStoppedBefore) {
  test::RecordingCheckpoint stopped(0);
  EXPECT_FALSE(means_->MakeLandmarks(4, stopped).ok());
  const bool made = means_->MakeLandmarks(4, checkpoint_).value();
  EXPECT_TRUE(made);
}

// What answers them changes the rounding at most.
TEST_F(PairQuestionTest, FewSearchesAreSpreadOverThreads) {
  std::vector<PointPair> pairs;
  for (uint32_t i = 0; i < 100; ++i) {
    pairs.push_back({VertexPoint{i}, VertexPoint{120 - i}});
  }
  const auto most_in_a_row = [&](size_t threads) {
    size_t most = 0;
    const auto question = Make(pairs, {}, threads).value();
    for (const PairRow& row : question->rows()) {
      most = std::max(most, row.pairs.size());
    }
    return most;
  };
  EXPECT_EQ(most_in_a_row(1), 25);
  EXPECT_EQ(most_in_a_row(4), 6);
  EXPECT_EQ(most_in_a_row(100), 1);
  pairs.resize(1000, pairs[1]);
  pairs[2].target = FacePoint{0, {0.2, 0.3, 0.5}};
  EXPECT_EQ((*Make(pairs, {.paths = true}))->rows()[0].pairs.size(), 32);
}

TEST_F(PairQuestionTest, FindsPathsInOrder) {
  std::vector<PointPair> pairs;
  for (uint32_t i = 0; i < 40; ++i) {
    pairs.push_back({VertexPoint{60}, VertexPoint{i}});
  }
  const DistanceRow found = Ask(pairs, {.paths = true});
  ASSERT_EQ(found.paths.size(), pairs.size());
  for (size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_EQ(found.paths[i].distance, found.values[i]);
    EXPECT_NEAR(found.values[i], Euclid(pairs[i]), 1e-12);
    EXPECT_EQ(found.paths[i].points.front(), pairs[i].source);
    EXPECT_EQ(found.paths[i].points.back(), pairs[i].target);
  }
  EXPECT_EQ(means_->fields, 0);
}

TEST_F(PairQuestionTest, CertifiesATolerance) {
  std::vector<PointPair> pairs;
  for (uint32_t i = 0; i < 30; ++i) {
    pairs.push_back({VertexPoint{i}, VertexPoint{120 - i}});
  }
  const DistanceRow found = Ask(pairs, {.tolerance = 0.05});
  EXPECT_LE(found.certified_error, 0.05);
  for (size_t i = 0; i < pairs.size(); ++i) {
    const double exact = Euclid(pairs[i]);
    EXPECT_NEAR(found.values[i], exact,
                (found.certified_error + 1e-12) * exact);
  }
}

TEST_F(PairQuestionTest, TellsThatNoPathLeads) {
  // Edges of the same length would be joined.
  Hold(test::Join(MakeGrid({.columns = 3, .rows = 3}),
                  test::Scale(MakeGrid({.columns = 3, .rows = 3}), 1.5)));
  const std::vector<double> distances =
      Ask({{VertexPoint{0}, VertexPoint{20}}, {VertexPoint{0}, VertexPoint{1}}})
          .values;
  EXPECT_EQ(distances[0], kInfinity);
  EXPECT_DOUBLE_EQ(distances[1], 1);
}

// They allow no directed search.
TEST_F(PairQuestionTest, OnFacesWithoutAreaTwoThatShareAnEndGetAField) {
  Hold(test::InsertZeroAreaFaces(MakeGrid({.columns = 4, .rows = 4}), 2, 1));
  const auto question = Make({{VertexPoint{6}, VertexPoint{8}},
                              {VertexPoint{9}, VertexPoint{11}},
                              {VertexPoint{8}, VertexPoint{9}}})
                            .value();
  EXPECT_NE(question->algorithm(), Algorithm::kFwpList);
  for (const double d : Ask(*question).values) EXPECT_GT(d, 0);
  EXPECT_EQ(count(AnsweredBy::kField), 2);
  EXPECT_EQ(count(AnsweredBy::kSearch), 1);
  EXPECT_EQ(means_->wishes, 0);
}

TEST_F(PairQuestionTest, ApproximateOnesAreFieldsOrSearchesOfTheMethod) {
  std::vector<PointPair> pairs;
  for (uint32_t i = 0; i < 30; ++i) {
    pairs.push_back({VertexPoint{i % 3}, VertexPoint{120 - i}});
  }
  for (const ApproximateMethodInfo& info : kApproximateMethods) {
    SCOPED_TRACE(info.name);
    const std::shared_ptr<const PreparedMethod> method =
        PrepareMethod(*mesh_, info.method, {.gtu = {.samples = 20}},
                      checkpoint_)
            .value();
    const auto question =
        Make(pairs, {.method = {{info.method, method}}}).value();
    const std::vector<double> distances = Ask(*question).values;
    for (size_t i = 0; i < pairs.size(); ++i) {
      EXPECT_NEAR(distances[i], Euclid(pairs[i]), 0.3 * Euclid(pairs[i]));
    }
    const bool searches = info.method == ApproximateMethod::kSvg ||
                          info.method == ApproximateMethod::kGtu;
    EXPECT_EQ(count(AnsweredBy::kSearch), searches ? 30 : 0);
    EXPECT_EQ(count(AnsweredBy::kField), searches ? 0 : 30);
    // A field from each of the three common ends.
    if (!searches) EXPECT_EQ(question->rows().size(), 3);
    EXPECT_EQ(question->landmarks(), 0);
  }
  EXPECT_EQ(means_->fields, 0);
  EXPECT_EQ(means_->loans, 0);
}

TEST_F(PairQuestionTest, WrongPairsAreNamed) {
  const auto fault = [&](std::vector<PointPair> pairs,
                         PairOptions options = {}) {
    const absl::Status status =
        Make(std::move(pairs), std::move(options)).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    return FieldPathOf(status).value_or("none");
  };
  const PointPair good{VertexPoint{0}, VertexPoint{1}};
  EXPECT_EQ(fault({}), "pairs");
  EXPECT_EQ(fault({good, {VertexPoint{500}, VertexPoint{1}}}),
            "pairs[1].source.vertex");
  EXPECT_EQ(fault({{VertexPoint{0}, EdgePoint{0, 1, 2}}}),
            "pairs[0].target.edge.t");
  EXPECT_EQ(fault({good}, {.tolerance = 0.5}), "tolerance");
  // Before the method is there.
  const RowMethod method{ApproximateMethod::kFmm, nullptr};
  EXPECT_EQ(fault({good}, {.paths = true, .method = method}), "paths");
  EXPECT_EQ(
      fault({good, {EdgePoint{0, 1, 0.5}, VertexPoint{1}}}, {.method = method}),
      "pairs[1].source");
  EXPECT_TRUE(Make({good}, {.method = method}).ok());
}

TEST_F(PairQuestionTest, StopsWhereverItIsToldTo) {
  std::vector<PointPair> pairs;
  for (uint32_t i = 0; i < 8; ++i) {
    pairs.push_back({VertexPoint{i}, VertexPoint{120 - i}});
  }
  const RowMethod graph{
      ApproximateMethod::kSvg,
      PrepareMethod(*mesh_, ApproximateMethod::kSvg, {}, checkpoint_).value()};
  for (const PairOptions& options : {PairOptions{}, {.method = graph}}) {
    const auto question = Make(pairs, options).value();
    test::RecordingCheckpoint whole;
    ASSERT_TRUE(question->Answer(0, whole).ok());
    EXPECT_GT(whole.polls().size(), 0);
    // Of all searches together.
    uint64_t windows = 0;
    for (const Progress& poll : whole.polls()) {
      EXPECT_GE(poll.windows_propagated, windows);
      windows = poll.windows_propagated;
    }
    for (uint64_t poll = 0; poll < whole.polls().size(); ++poll) {
      test::RecordingCheckpoint checkpoint(poll);
      EXPECT_EQ(question->Answer(0, checkpoint).status(),
                test::RecordingCheckpoint::Stopped());
    }
  }
  // The search that was stopped answers the next question.
  ExpectEuclid(pairs);
}

}  // namespace
}  // namespace geodesic
