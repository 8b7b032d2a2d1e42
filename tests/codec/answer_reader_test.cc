// What is put together from the messages of an answer, and what is refused.

#include "codec/answer_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/v1/answer.pb.h"

namespace geodesic::codec {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using Messages = std::vector<v1::Answer>;

constexpr int64_t kAny = AnswerReader::kAny;
constexpr int64_t kVertices = AnswerReader::kVertices;

struct Info {
  std::string name;
  std::vector<int64_t> shape;
  v1::ValueType type = v1::VALUE_TYPE_FLOAT64;
};

// On a mesh of four vertices.
v1::Answer Header(const std::vector<Info>& arrays) {
  v1::Answer message;
  message.mutable_header()->set_vertex_count(4);
  for (const Info& array : arrays) {
    v1::ArrayInfo& info = *message.mutable_header()->add_arrays();
    info.set_name(array.name);
    info.set_type(array.type);
    info.mutable_shape()->Add(array.shape.begin(), array.shape.end());
  }
  return message;
}

v1::Answer BytesBlock(uint32_t array, uint64_t first, const std::string& bytes,
                      const std::string& id = "") {
  v1::Answer message;
  v1::Block& block = *message.add_blocks();
  block.set_array(array);
  block.set_first(first);
  block.set_values(bytes);
  message.set_answer_id(id);
  return message;
}

template <typename Number = double>
v1::Answer Block(uint32_t array, uint64_t first,
                 const std::vector<Number>& numbers,
                 const std::string& id = "") {
  return BytesBlock(array, first,
                    {reinterpret_cast<const char*>(numbers.data()),
                     numbers.size() * sizeof(Number)},
                    id);
}

v1::Answer Trailer() {
  v1::Answer message;
  message.mutable_trailer()->set_compute_seconds(7);
  return message;
}

// Takes the messages; the first status that is not OK.
absl::Status Consume(const Messages& messages, AnswerReader* reader) {
  for (const v1::Answer& message : messages) {
    absl::Status status = reader->Consume(message);
    if (!status.ok()) return status;
  }
  return absl::OkStatus();
}

void ExpectDataLoss(const absl::Status& status, const std::string& words) {
  EXPECT_EQ(status.code(), absl::StatusCode::kDataLoss) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr(words));
}

// One array that has a number for each vertex.
class AnswerReaderTest : public ::testing::Test {
 protected:
  AnswerReaderTest() { reader_.Collect("distance", {kVertices}, &distances_); }

  const v1::Answer header_ = Header({{"distance", {4}}});
  AnswerReader reader_;
  std::vector<double> distances_;
};

TEST_F(AnswerReaderTest, PutsBlocksTogether) {
  EXPECT_FALSE(reader_.has_header());
  ASSERT_TRUE(Consume({header_, Block(0, 0, {0, 1.5}), Block(0, 2, {3, 2.25})},
                      &reader_)
                  .ok());
  EXPECT_TRUE(reader_.has_header());
  EXPECT_FALSE(reader_.has_trailer());
  ASSERT_TRUE(reader_.Consume(Trailer()).ok());
  EXPECT_TRUE(reader_.has_trailer());
  EXPECT_THAT(distances_, ElementsAre(0, 1.5, 3, 2.25));
  EXPECT_EQ(reader_.header().vertex_count(), 4);
  EXPECT_EQ(reader_.trailer().compute_seconds(), 7);
}

TEST_F(AnswerReaderTest, OneMessageMayBeAll) {
  v1::Answer message = header_;
  message.MergeFrom(Block(0, 0, {0, 1}));
  message.MergeFrom(Block(0, 2, {2, 3}));
  message.MergeFrom(Trailer());
  ASSERT_TRUE(reader_.Consume(message).ok());
  EXPECT_THAT(distances_, ElementsAre(0, 1, 2, 3));
  EXPECT_TRUE(reader_.has_trailer());
}

TEST_F(AnswerReaderTest, WidensFloats) {
  ASSERT_TRUE(Consume({Header({{"distance", {4}, v1::VALUE_TYPE_FLOAT32}}),
                       Block<float>(0, 0, {0.5F, 0.1F, 1, 2}), Trailer()},
                      &reader_)
                  .ok());
  EXPECT_THAT(distances_, ElementsAre(0.5, double{0.1F}, 1, 2));
}

TEST_F(AnswerReaderTest, ElementsMayBeTakenOutMeanwhile) {
  ASSERT_TRUE(Consume({header_, Block(0, 0, {0, 1, 2})}, &reader_).ok());
  distances_.erase(distances_.begin(), distances_.begin() + 2);
  ASSERT_TRUE(Consume({Block(0, 3, {3}), Trailer()}, &reader_).ok());
  EXPECT_THAT(distances_, ElementsAre(2, 3));
}

// They count nevertheless.
TEST_F(AnswerReaderTest, SkipsWhatItDoesNotKnow) {
  ASSERT_TRUE(
      Consume({Header({{"later", {-1, 2}, v1::VALUE_TYPE_UINT8},
                       {"distance", {4}}}),
               BytesBlock(0, 0, "12", "the answer"), Block(1, 0, {0, 1, 2})},
              &reader_)
          .ok());
  EXPECT_THAT(distances_, ElementsAre(0, 1, 2));
  EXPECT_EQ(reader_.received(), 5);
  const std::optional<v1::Resumption> rest = reader_.Resume();
  ASSERT_TRUE(rest.has_value());
  EXPECT_THAT(rest->received(), ElementsAre(2, 3));
}

TEST(AnswerArraysTest, HaveAllTypesAndShapes) {
  AnswerReader reader;
  std::vector<float> floats;
  std::vector<uint8_t> bytes;
  std::vector<uint32_t> words;
  std::vector<uint64_t> longs;
  std::vector<std::array<double, 2>> plane;
  std::vector<std::array<uint32_t, 2>> edges;
  std::vector<double> matrix;
  reader.Collect("floats", {2}, &floats);
  reader.Collect("bytes", {kAny}, &bytes);
  reader.Collect("words", {AnswerReader::kPoints}, &words);
  reader.Collect("longs", {1}, &longs);
  reader.Collect("plane", {AnswerReader::kPoints, 2}, &plane);
  reader.Collect("edges", {1, 2}, &edges);
  reader.Collect("matrix", {1, kVertices}, &matrix);
  ASSERT_TRUE(Consume({Header({{"floats", {2}, v1::VALUE_TYPE_FLOAT32},
                               {"bytes", {-1}, v1::VALUE_TYPE_UINT8},
                               {"words", {-1}, v1::VALUE_TYPE_UINT32},
                               {"longs", {1}, v1::VALUE_TYPE_UINT64},
                               {"plane", {-1, 2}},
                               {"edges", {1, 2}, v1::VALUE_TYPE_UINT32},
                               {"matrix", {1, 4}}}),
                       Block<float>(0, 0, {1, 2}),
                       BytesBlock(1, 0, std::string("\x01\xff\x00", 3)),
                       Block<uint32_t>(2, 0, {7}), Block<uint64_t>(3, 0, {9}),
                       Block(4, 0, {0.5, 0.25}), Block<uint32_t>(5, 0, {3, 4}),
                       Block(6, 0, {1, 2, 3, 4}), Trailer()},
                      &reader)
                  .ok());
  EXPECT_THAT(floats, ElementsAre(1, 2));
  EXPECT_THAT(bytes, ElementsAre(1, 255, 0));
  EXPECT_THAT(words, ElementsAre(7));
  EXPECT_THAT(longs, ElementsAre(9));
  EXPECT_THAT(plane, ElementsAre(std::array{0.5, 0.25}));
  EXPECT_THAT(edges, ElementsAre(std::array{3U, 4U}));
  EXPECT_THAT(matrix, ElementsAre(1, 2, 3, 4));
}

// Element by element, whatever the blocks are.
TEST(AnswerArraysTest, AnElementMayBeInSeveralBlocks) {
  for (const v1::ValueType type :
       {v1::VALUE_TYPE_FLOAT64, v1::VALUE_TYPE_FLOAT32}) {
    AnswerReader reader;
    std::vector<std::array<double, 3>> gradients;
    reader.Collect("gradient", {kVertices, 3}, &gradients);
    ASSERT_TRUE(reader.Consume(Header({{"gradient", {4, 3}, type}})).ok());
    uint64_t first = 0;
    for (const uint64_t size : {1, 1, 3, 0, 4, 3}) {
      std::vector<double> doubles;
      for (uint64_t i = 0; i < size; ++i) doubles.push_back(first + i);
      const std::vector<float> floats(doubles.begin(), doubles.end());
      ASSERT_TRUE(reader
                      .Consume(type == v1::VALUE_TYPE_FLOAT64
                                   ? Block(0, first, doubles)
                                   : Block(0, first, floats))
                      .ok());
      first += size;
      EXPECT_EQ(gradients.size(), first / 3);
    }
    ASSERT_TRUE(reader.Consume(Trailer()).ok());
    EXPECT_THAT(gradients, ElementsAre(std::array<double, 3>{0, 1, 2},
                                       std::array<double, 3>{3, 4, 5},
                                       std::array<double, 3>{6, 7, 8},
                                       std::array<double, 3>{9, 10, 11}));
  }
}

TEST_F(AnswerReaderTest, ABrokenStreamIsReadOn) {
  ASSERT_TRUE(
      Consume({header_, Block(0, 0, {0, 1.5}, "the answer"), Block(0, 2, {2})},
              &reader_)
          .ok());
  const std::optional<v1::Resumption> rest = reader_.Resume();
  ASSERT_TRUE(rest.has_value());
  EXPECT_EQ(rest->answer_id(), "the answer");
  EXPECT_THAT(rest->received(), ElementsAre(3));
  EXPECT_FALSE(reader_.has_header());
  ASSERT_TRUE(
      Consume({header_, Block(0, 3, {7}, "the answer"), Trailer()}, &reader_)
          .ok());
  EXPECT_THAT(distances_, ElementsAre(0, 1.5, 2, 7));
}

// Also within an element, and after the trailer.
TEST(AnswerArraysTest, AnElementMayBeInSeveralStreams) {
  AnswerReader reader;
  std::vector<std::array<double, 2>> plane;
  reader.Collect("plane", {kAny, 2}, &plane);
  const v1::Answer header = Header({{"plane", {-1, 2}}});
  ASSERT_TRUE(Consume({header, Block(0, 0, {1, 2, 3}, "id")}, &reader).ok());
  ASSERT_TRUE(reader.Resume().has_value());
  ASSERT_TRUE(
      Consume({header, Block(0, 3, {4}, "id"), Trailer()}, &reader).ok());
  ASSERT_TRUE(reader.Resume().has_value());
  EXPECT_FALSE(reader.has_trailer());
  ASSERT_TRUE(Consume({header, Trailer()}, &reader).ok());
  EXPECT_THAT(plane, ElementsAre(std::array{1.0, 2.0}, std::array{3.0, 4.0}));
}

TEST_F(AnswerReaderTest, WhatHasNoNameIsReadFromTheStart) {
  ASSERT_TRUE(Consume({header_, Block(0, 0, {0, 1.5})}, &reader_).ok());
  EXPECT_FALSE(reader_.Resume().has_value());
  reader_.Restart();
  EXPECT_THAT(distances_, IsEmpty());
  EXPECT_EQ(reader_.received(), 0);
  ExpectDataLoss(Consume({header_, Block(0, 2, {2})}, &reader_),
                 "from number 2 after 0");
}

TEST_F(AnswerReaderTest, IsNotReadOnWithAnotherAnswer) {
  v1::Answer other_mesh = header_;
  other_mesh.mutable_header()->set_vertex_count(5);
  for (const v1::Answer& other :
       {other_mesh, Header({{"distance", {4}, v1::VALUE_TYPE_FLOAT32}}),
        Header({{"distance", {4}}, {"more", {4}}}), Header({})}) {
    AnswerReader reader;
    reader.Collect("distance", {4}, &distances_);
    ASSERT_TRUE(Consume({header_, Block(0, 0, {0}, "id")}, &reader).ok());
    reader.Resume();
    ExpectDataLoss(reader.Consume(other), "another answer");
  }
}

TEST_F(AnswerReaderTest, RefusesWhatIsNotDue) {
  v1::Answer unknown = Header({{"distance", {4}}, {"later", {4}}});
  unknown.mutable_header()->mutable_arrays(1)->set_type(
      static_cast<v1::ValueType>(99));
  const std::vector<std::pair<Messages, std::string>> table = {
      // Parts out of order.
      {{Block(0, 0, {1})}, "out of order"},
      {{Trailer()}, "out of order"},
      {{header_, header_}, "out of order"},
      {{header_, Block(0, 0, {1, 2, 3, 4}), Trailer(), Trailer()},
       "out of order"},
      {{header_, Block(0, 0, {1, 2, 3, 4}), Trailer(), Block(0, 4, {1})},
       "out of order"},
      // Arrays that were not asked for, or cannot be.
      {{Header({})}, "numbers of distance"},
      {{Header({{"distances", {4}}})}, "numbers of distance"},
      {{Header({{"distance", {3}}})}, "numbers of distance"},
      {{Header({{"distance", {-1}}})}, "numbers of distance"},
      {{Header({{"distance", {4, 1}}})}, "numbers of distance"},
      {{Header({{"distance", {4}, v1::VALUE_TYPE_UINT64}})},
       "numbers of distance"},
      {{Header({{"distance", {4}, v1::VALUE_TYPE_UINT32}})},
       "numbers of distance"},
      {{Header({{"distance", {4}, v1::VALUE_TYPE_UNSPECIFIED}})}, "cannot be"},
      {{unknown}, "cannot be: later"},
      {{Header({{"distance", {4}}, {"later", {}}})}, "cannot be"},
      {{Header({{"distance", {4}}, {"later", {-2}}})}, "cannot be"},
      {{Header({{"distance", {4}}, {"later", {4, -1}}})}, "cannot be"},
      {{Header({{"distance", {4}}, {"later", {-1, 0}}})}, "cannot be"},
      {{Header({{"distance", {4}}, {"later", {int64_t{1} << 62, 8}}})},
       "cannot be"},
      // Blocks.
      {{header_, Block(1, 0, {1})}, "array 1 of 1"},
      {{header_, Block(0, 1, {1})}, "8 bytes of distance from number 1"},
      {{header_, Block(0, 0, {1}), Block(0, 0, {1})}, "from number 0 after 1"},
      {{header_, Block(0, 0, {1, 2, 3, 4, 5})}, "after 0 of 4"},
      {{header_, Block(0, 0, {1, 2, 3}), Block(0, 3, {4, 5})}, "after 3 of 4"},
      {{header_, BytesBlock(0, 0, "0123456789")}, "10 bytes of distance"},
      // The end.
      {{header_, Trailer()}, "0 of 4 numbers of distance"},
      {{header_, Block(0, 0, {1}), Trailer()}, "1 of 4"},
      {{Header({{"distance", {4}}, {"later", {-1, 3}}}),
        Block(0, 0, {1, 2, 3, 4}), Block(1, 0, {1, 2}), Trailer()},
       "numbers of later"}};
  for (const auto& [messages, words] : table) {
    AnswerReader reader;
    std::vector<double> distances;
    reader.Collect("distance", {kVertices}, &distances);
    ExpectDataLoss(Consume(messages, &reader), words);
  }
}

TEST(AnswerArraysTest, WhatBelongsTogetherIsEquallyMuch) {
  const v1::Answer header =
      Header({{"vertex", {-1}, v1::VALUE_TYPE_UINT32}, {"distance", {-1}}});
  const auto status = [&](const std::vector<double>& distances) {
    AnswerReader reader;
    std::vector<uint32_t> vertices;
    std::vector<double> values;
    reader.Collect("vertex", {kAny}, &vertices);
    reader.Collect("distance", {kAny}, &values);
    return Consume({header, Block<uint32_t>(0, 0, {3, 1}),
                    Block(1, 0, distances), Trailer()},
                   &reader);
  };
  EXPECT_TRUE(status({1, 2}).ok());
  ExpectDataLoss(status({1}), "1 of 2 numbers of distance");
  ExpectDataLoss(status({1, 2, 3}), "3 of 2 numbers of distance");
}

TEST(AnswerArraysTest, AnnouncedCountsTakeNoMemory) {
  constexpr auto kHuge = std::numeric_limits<int64_t>::max();
  AnswerReader reader;
  std::vector<double> values;
  reader.Collect("distance", {kAny}, &values);
  ASSERT_TRUE(
      Consume({Header({{"distance", {kHuge}}}), Block(0, 0, {1})}, &reader)
          .ok());
  EXPECT_LT(values.capacity(), uint64_t{1} << 25);
  ExpectDataLoss(reader.Consume(Trailer()), "1 of 9223372036854775807");
}

}  // namespace
}  // namespace geodesic::codec
