#include "client/output/matrix_writers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <map>

#include "tests/client/written.h"

namespace geodesic::client {
namespace {

using ::testing::ElementsAre;

template <typename Number>
std::vector<Number> Numbers(const std::string& bytes) {
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return numbers;
}

// The members of an archive without compression, read by what the zip format
// says of local headers.
std::map<std::string, std::string> Members(const std::string& zip) {
  std::map<std::string, std::string> members;
  size_t at = 0;
  while (zip.compare(at, 4, "PK\3\4") == 0) {
    const auto sizes = Numbers<uint32_t>(zip.substr(at + 18, 8));
    const auto lengths = Numbers<uint16_t>(zip.substr(at + 26, 4));
    EXPECT_EQ(sizes[0], sizes[1]);  // stored
    const size_t body = at + 30 + lengths[0] + lengths[1];
    members[zip.substr(at + 30, lengths[0])] = zip.substr(body, sizes[0]);
    at = body + sizes[0];
  }
  EXPECT_EQ(zip.compare(at, 4, "PK\1\2"), 0);
  return members;
}

// What follows the header of an .npy file.
std::string Body(const std::string& npy) {
  return npy.substr(10 + Numbers<uint16_t>(npy.substr(8, 2))[0]);
}

class MatrixWritersTest : public ::testing::Test {
 protected:
  void Open(OutputFormat format, NumberType type = NumberType::kFloat64) {
    absl::StatusOr<std::unique_ptr<MatrixWriter>> writer =
        CreateMatrixWriter(path_, format, type, places_);
    ASSERT_TRUE(writer.ok()) << writer.status();
    writer_ = *std::move(writer);
    ASSERT_TRUE(writer_->Begin({2, 3}).ok());
  }

  void Append(uint64_t row, const std::vector<double>& values,
              const std::vector<uint32_t>& columns = {}) {
    ASSERT_TRUE(writer_->Append({row, columns, values}).ok());
  }

  std::string Committed() {
    EXPECT_EQ(folder_.count(), visible_before_);
    absl::StatusOr<uint64_t> size = writer_->Commit();
    EXPECT_TRUE(size.ok()) << size.status();
    const std::string bytes = FileBytes(path_);
    EXPECT_EQ(*size, bytes.size());
    EXPECT_EQ(folder_.count(), 1);
    return bytes;
  }

  TemporaryFolder folder_;
  std::string path_ = folder_ / "m";
  MatrixPlaces places_ = {.sources = {{VertexPoint{7}}, {VertexPoint{0}, 0.5}}};
  std::unique_ptr<MatrixWriter> writer_;
  // An AtomicFile shows beside its place while it grows.
  size_t visible_before_ = 1;
};

TEST_F(MatrixWritersTest, NpyIsDense) {
  Open(OutputFormat::kNpy);
  Append(0, {0, 1, 2});
  Append(1, {1, 0, kInfinity});
  const std::string bytes = Committed();
  EXPECT_NE(bytes.find("'shape': (2, 3), }"), std::string::npos);
  EXPECT_THAT(Numbers<double>(Body(bytes)),
              ElementsAre(0, 1, 2, 1, 0, kInfinity));
}

TEST_F(MatrixWritersTest, FloatsWhereAskedFor) {
  Open(OutputFormat::kNpy, NumberType::kFloat32);
  Append(0, {0, 0.5, 2});
  Append(1, {1, 0, kInfinity});
  const std::string bytes = Committed();
  EXPECT_NE(bytes.find("'<f4'"), std::string::npos);
  EXPECT_EQ(Numbers<float>(Body(bytes))[1], 0.5F);
}

TEST_F(MatrixWritersTest, NpzIsWhatScipyLoads) {
  visible_before_ = 0;
  Open(OutputFormat::kNpz);
  Append(0, {0, 2.5}, {0, 2});
  Append(1, {1}, {1});
  std::map<std::string, std::string> members = Members(Committed());
  EXPECT_THAT(Numbers<double>(Body(members["data.npy"])),
              ElementsAre(0, 2.5, 1));
  EXPECT_NE(members["data.npy"].find("'shape': (3,)"), std::string::npos);
  EXPECT_THAT(Numbers<int32_t>(Body(members["indices.npy"])),
              ElementsAre(0, 2, 1));
  EXPECT_THAT(Numbers<int32_t>(Body(members["indptr.npy"])),
              ElementsAre(0, 2, 3));
  EXPECT_THAT(Numbers<int64_t>(Body(members["shape.npy"])), ElementsAre(2, 3));
  EXPECT_EQ(Body(members["format.npy"]), "csr");
  EXPECT_NE(members["format.npy"].find("'|S3'"), std::string::npos);
  EXPECT_NE(members["format.npy"].find("'shape': ()"), std::string::npos);
  EXPECT_EQ(members.size(), 5);
}

TEST_F(MatrixWritersTest, NpzKeepsTheFiniteValuesOfDenseRows) {
  visible_before_ = 0;
  Open(OutputFormat::kNpz);
  Append(0, {kInfinity, 0, 1});
  Append(1, {kInfinity, kInfinity, kInfinity});
  std::map<std::string, std::string> members = Members(Committed());
  EXPECT_THAT(Numbers<int32_t>(Body(members["indices.npy"])),
              ElementsAre(1, 2));
  EXPECT_THAT(Numbers<int32_t>(Body(members["indptr.npy"])),
              ElementsAre(0, 2, 2));
}

TEST_F(MatrixWritersTest, NpzIsTheSameEveryTime) {
  visible_before_ = 0;
  std::string first;
  for (int i = 0; i < 2; ++i) {
    Open(OutputFormat::kNpz);
    Append(0, {1, 2, 3});
    Append(1, {4, 5, 6});
    ASSERT_TRUE(writer_->Commit().ok());
    if (i == 0) first = FileBytes(path_);
  }
  EXPECT_EQ(FileBytes(path_), first);
}

TEST_F(MatrixWritersTest, CsvHasALineForEachValue) {
  Open(OutputFormat::kCsv);
  Append(0, {0, 2.5}, {0, 2});
  Append(1, {1, 0, kInfinity});
  EXPECT_EQ(Committed(),
            "source,target,distance\n7,0,0\n7,2,2.5\n0:0.5,0,1\n0:0.5,1,0\n"
            "0:0.5,2,inf\n");
}

TEST_F(MatrixWritersTest, NothingIsLeftWithoutCommit) {
  for (const OutputFormat format : kMatrixFormats) {
    Open(format);
    Append(0, {1, 2, 3});
    writer_.reset();
    EXPECT_EQ(folder_.count(), 0);
  }
}

TEST(CreateMatrixWriterTest, NamesThePathItCannotWrite) {
  for (const OutputFormat format : kMatrixFormats) {
    const absl::Status status =
        CreateMatrixWriter("/nowhere/m", format, NumberType::kFloat64, {})
            .status();
    EXPECT_FALSE(status.ok());
    EXPECT_NE(status.message().find("/nowhere/m"), absl::string_view::npos);
  }
}

}  // namespace
}  // namespace geodesic::client
