#include "client/src/row_assembler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/client/wire_bytes.h"

namespace geodesic::client {
namespace {

using ::testing::ElementsAre;

class RowAssemblerTest : public ::testing::Test {
 protected:
  absl::Status Consume(RowAssembler* assembler, uint64_t row, uint64_t count,
                       uint64_t offset, const std::vector<double>& values,
                       const std::vector<uint32_t>& columns = {}) {
    const std::string numbers = Bytes(columns);
    const std::string bytes = Bytes(values);
    return assembler->Consume({row, count, offset, numbers, bytes}, 3);
  }

  RowAssembler dense_{ValueType::kFloat64, false};
  RowAssembler sparse_{ValueType::kFloat64, true};
};

TEST_F(RowAssemblerTest, DenseRowsComeInPieces) {
  ASSERT_TRUE(Consume(&dense_, 0, 3, 0, {1, 2}).ok());
  EXPECT_FALSE(dense_.complete());
  EXPECT_EQ(dense_.row_count(), 0);
  ASSERT_TRUE(Consume(&dense_, 0, 3, 2, {3}).ok());
  EXPECT_TRUE(dense_.complete());
  EXPECT_THAT(dense_.values(), ElementsAre(1, 2, 3));
  ASSERT_TRUE(Consume(&dense_, 1, 3, 0, {4, 5, 6}).ok());
  EXPECT_EQ(dense_.row(), 1);
  EXPECT_EQ(dense_.row_count(), 2);
  EXPECT_THAT(dense_.values(), ElementsAre(4, 5, 6));
}

TEST_F(RowAssemblerTest, SparseRowsHaveColumnsAndMayBeEmpty) {
  ASSERT_TRUE(Consume(&sparse_, 0, 0, 0, {}).ok());
  EXPECT_TRUE(sparse_.complete());
  ASSERT_TRUE(Consume(&sparse_, 1, 2, 0, {1, 2}, {0, 2}).ok());
  EXPECT_THAT(sparse_.numbers(), ElementsAre(0, 2));
  EXPECT_EQ(sparse_.row_count(), 2);
}

TEST_F(RowAssemblerTest, FloatsBecomeDoubles) {
  RowAssembler assembler(ValueType::kFloat32, false);
  const std::string bytes = Bytes(std::vector<float>{0.5F, 0.1F});
  ASSERT_TRUE(assembler.Consume({0, 2, 0, "", bytes}, 2).ok());
  EXPECT_THAT(assembler.values(), ElementsAre(0.5, double{0.1F}));
}

TEST_F(RowAssemblerTest, RefusesWhatIsNotDue) {
  const auto refused = [this](RowAssembler assembler, uint64_t row,
                              uint64_t count, uint64_t offset,
                              const std::vector<double>& values,
                              const std::vector<uint32_t>& columns = {}) {
    return Consume(&assembler, row, count, offset, values, columns).code() ==
           absl::StatusCode::kDataLoss;
  };
  EXPECT_TRUE(refused(dense_, 1, 3, 0, {1, 2, 3}));     // another row
  EXPECT_TRUE(refused(dense_, 0, 3, 1, {1, 2}));        // a gap
  EXPECT_TRUE(refused(dense_, 0, 2, 0, {1, 2}));        // too short
  EXPECT_TRUE(refused(dense_, 0, 3, 0, {1, 2, 3, 4}));  // too long
  EXPECT_TRUE(refused(dense_, 0, 3, 0, {}));            // without end
  EXPECT_TRUE(refused(dense_, 0, 3, 0, {1, 2, 3}, {0, 1, 2}));
  EXPECT_TRUE(refused(sparse_, 0, 2, 0, {1, 2}, {0}));
  EXPECT_TRUE(refused(sparse_, 0, 1, 0, {1}, {3}));  // no such column
  EXPECT_TRUE(refused(sparse_, 0, 4, 0, {1}, {0}));
  EXPECT_EQ(dense_.Consume({0, 3, 0, "", "123"}, 3).code(),
            absl::StatusCode::kDataLoss);
}

}  // namespace
}  // namespace geodesic::client
