// Streams that break: the client reads on, or begins anew, or gives up.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>

#include "geodesic_client/client.h"
#include "geodesic_client/errors.h"
#include "tests/client/scripted_service.h"

namespace geodesic::client {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class BrokenStreamTest : public AnswersTest {
 protected:
  const Message header_ = FieldHeader();
  const Message rest_ = Message().Put(0, 2, D{2}).Trailer();
  const Message whole_ = Message().Put(0, 0, D{0, 1, 2}).Trailer();
  const Stream broken_ = {{header_, Message().Put(0, 0, D{0, 1})}, Broken()};
};

TEST_F(BrokenStreamTest, IsReadOn) {
  Play({broken_, {{header_}, Broken()}, {{header_, rest_}}});
  const absl::StatusOr<Field> field = client_->ComputeField({});
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_THAT(field->distances, ElementsAre(0, 1, 2));
  EXPECT_THAT(Received(),
              ElementsAre(IsEmpty(), ElementsAre(2), ElementsAre(2)));
  EXPECT_EQ(service_.Resumptions()[1].answer_id(), "the answer");
}

TEST_F(BrokenStreamTest, WhatIsNotKeptIsAskedForAnew) {
  Play({broken_, {{}, NotKept()}, {{header_, whole_}}});
  const absl::StatusOr<Field> field = client_->ComputeField({});
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_THAT(field->distances, ElementsAre(0, 1, 2));
  EXPECT_THAT(Received(), ElementsAre(IsEmpty(), ElementsAre(2), IsEmpty()));
  // Not for ever.
  Play(std::deque<Stream>(9, {{}, NotKept()}));
  EXPECT_EQ(ErrorReason(client_->ComputeField({}).status()), "ANSWER_NOT_KEPT");
  EXPECT_THAT(service_.Resumptions(), SizeIs(4));
}

TEST_F(BrokenStreamTest, WhatHasNoNameIsAskedForAnew) {
  Play({{{header_, Message().Put(0, 0, D{0, 1}).Unnamed()}, Broken()},
        {{header_, whole_}}});
  ASSERT_TRUE(client_->ComputeField({}).ok());
  EXPECT_EQ(service_.Resumptions()[1].answer_id(), "");
}

TEST_F(BrokenStreamTest, AnotherAnswerIsRefused) {
  Play({broken_, {{FieldHeader().Doubles("more", {1}), rest_}}});
  ExpectDataLoss(client_->ComputeField({}).status(), "another answer");
}

// As long as something new comes, it is read on.
TEST_F(BrokenStreamTest, IsNotReadOnForEver) {
  Play({broken_,
        {{header_}, Broken()},
        {{header_}, Broken()},
        {{header_}, Broken()},
        {{header_, rest_}}});
  EXPECT_TRUE(absl::IsUnavailable(client_->ComputeField({}).status()));
  EXPECT_THAT(service_.Resumptions(), SizeIs(4));
}

// What was handed out would be there twice.
TEST_F(BrokenStreamTest, AProgressiveFieldIsNotReadOn) {
  const Message header =
      Message().Words("settled_vertex", {-1}).Doubles("settled_distance", {-1});
  const Message whole =
      Message().Put(0, 0, W{2, 0, 1}).Put(1, 0, D{0, 1, 2}).Trailer();
  size_t settled = 0;
  const auto stream = [&] {
    settled = 0;
    return client_->StreamField({}, [&](auto more) { settled += more.size(); })
        .status();
  };
  Play({{{header, Message().Put(0, 0, W{2}).Put(1, 0, D{0})}, Broken()},
        {{header, whole}}});
  EXPECT_TRUE(absl::IsUnavailable(stream()));
  EXPECT_EQ(settled, 1);
  EXPECT_THAT(service_.Resumptions(), SizeIs(1));
  // Before that it is asked for anew.
  Play({{{header}, Broken()}, {{header, whole}}});
  EXPECT_TRUE(stream().ok());
  EXPECT_EQ(settled, 3);
  EXPECT_EQ(service_.Resumptions()[1].answer_id(), "");
}

TEST_F(BrokenStreamTest, OtherErrorsAreFinal) {
  Play({{{header_}, {grpc::StatusCode::RESOURCE_EXHAUSTED, "no"}},
        {{header_, whole_}}});
  EXPECT_TRUE(absl::IsResourceExhausted(client_->ComputeField({}).status()));
  EXPECT_THAT(service_.Resumptions(), SizeIs(1));
}

class BrokenMatrixTest : public AnswersTest {
 protected:
  absl::Status Ask() {
    const MatrixQuery query = {.sources = {{VertexPoint{0}}, {VertexPoint{1}}}};
    matrix_.shape.clear();
    matrix_.rows.clear();
    return client_->ComputeMatrix(query, matrix_.Receiver()).status();
  }

  const Message dense_ = Message().Doubles("distance", {2, 3});
  Matrix matrix_;
};

TEST_F(BrokenMatrixTest, IsReadOnWhereItBroke) {
  Play({{{dense_, Message().Put(0, 0, D{1, 2, 3, 4})}, Broken()},
        {{dense_, Message().Put(0, 4, D{5, 6}).Trailer()}}});
  ASSERT_TRUE(Ask().ok());
  EXPECT_THAT(Received(), ElementsAre(IsEmpty(), ElementsAre(4)));
  EXPECT_THAT(matrix_.shape, ElementsAre(2, 3));
  EXPECT_THAT(matrix_.rows, ElementsAre(std::pair(W{}, D{1, 2, 3}),
                                        std::pair(W{}, D{4, 5, 6})));
}

// However often it breaks.
TEST_F(BrokenMatrixTest, IsReadOnAsLongAsSomethingComes) {
  std::deque<Stream> script;
  for (uint64_t i = 0; i < 5; ++i) {
    script.push_back(
        {{dense_, Message().Put(0, i, D{1.0 + static_cast<double>(i)})},
         Broken()});
  }
  script.push_back({{dense_, Message().Put(0, 5, D{6}).Trailer()}});
  Play(std::move(script));
  ASSERT_TRUE(Ask().ok());
  EXPECT_THAT(matrix_.rows, ElementsAre(std::pair(W{}, D{1, 2, 3}),
                                        std::pair(W{}, D{4, 5, 6})));
}

TEST_F(BrokenMatrixTest, RowsThatWereHandedOutAreNotTakenBack) {
  Play({{{dense_, Message().Put(0, 0, D{1, 2, 3})}, Broken()},
        {{}, NotKept()},
        {{dense_, Message().Put(0, 0, D{1, 2, 3, 4, 5, 6}).Trailer()}}});
  EXPECT_EQ(ErrorReason(Ask()), "ANSWER_NOT_KEPT");
  EXPECT_THAT(matrix_.rows, SizeIs(1));
  // Nor is one begun again that cannot be named.
  Play({{{dense_, Message().Put(0, 0, D{1, 2, 3}).Unnamed()}, Broken()},
        {{dense_, Message().Put(0, 0, D{1, 2, 3, 4, 5, 6}).Trailer()}}});
  EXPECT_TRUE(absl::IsUnavailable(Ask()));
  EXPECT_THAT(matrix_.rows, SizeIs(1));
}

TEST_F(BrokenMatrixTest, TheReceiversErrorEndsTheCall) {
  matrix_.status = absl::UnavailableError("enough");
  Play({{{dense_, Message().Put(0, 0, D{1, 2, 3, 4, 5, 6}).Trailer()}}});
  EXPECT_EQ(Ask(), absl::UnavailableError("enough"));
  EXPECT_THAT(matrix_.rows, SizeIs(1));
  EXPECT_THAT(service_.Resumptions(), SizeIs(1));
}

}  // namespace
}  // namespace geodesic::client
