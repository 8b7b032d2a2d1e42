// Answers that are written and read again.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "codec/answer_reader.h"
#include "codec/answer_writer.h"
#include "geodesic/v1/answer.pb.h"

namespace geodesic::codec {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

// Takes several messages.
constexpr uint64_t kCount = 150'001;

template <typename Number>
std::vector<Number> Numbers(uint64_t count) {
  std::vector<Number> numbers;
  for (uint64_t i = 0; i < count; ++i) {
    numbers.push_back(static_cast<Number>(i * 0x9e3779b97f4a7c15 >> 11));
  }
  return numbers;
}

// An answer with numbers of all types.
struct Arrays {
  std::vector<double> doubles;
  std::vector<double> narrow;  // travel as floats
  std::vector<std::array<double, 3>> vectors;
  std::vector<float> floats;
  std::vector<uint8_t> bytes;
  std::vector<uint32_t> words;
  std::vector<uint64_t> longs;

  bool operator==(const Arrays&) const = default;
};

Arrays Sent() {
  Arrays arrays = {.doubles = Numbers<double>(kCount),
                   .floats = Numbers<float>(kCount),
                   .bytes = Numbers<uint8_t>(kCount),
                   .words = Numbers<uint32_t>(kCount),
                   .longs = Numbers<uint64_t>(kCount)};
  arrays.narrow.assign(arrays.floats.begin(), arrays.floats.end());
  for (const double number : arrays.doubles) {
    arrays.vectors.push_back({number, -number, 1 / (1 + number)});
  }
  return arrays;
}

// The messages that bring what the reader has not received.
std::vector<v1::Answer> Written(const Arrays& arrays,
                                const std::vector<uint64_t>& received = {}) {
  constexpr auto kRows = static_cast<int64_t>(kCount);
  AnswerWriter writer(received);
  const uint32_t doubles =
      writer.Announce("doubles", v1::VALUE_TYPE_FLOAT64, {kRows});
  const uint32_t narrow =
      writer.Announce("narrow", v1::VALUE_TYPE_FLOAT32, {kRows});
  const uint32_t vectors =
      writer.Announce("vectors", v1::VALUE_TYPE_FLOAT64, {kRows, 3});
  const uint32_t floats =
      writer.Announce("floats", v1::VALUE_TYPE_FLOAT32, {-1});
  const uint32_t bytes = writer.Announce("bytes", v1::VALUE_TYPE_UINT8, {-1});
  const uint32_t words = writer.Announce("words", v1::VALUE_TYPE_UINT32, {-1});
  const uint32_t longs = writer.Announce("longs", v1::VALUE_TYPE_UINT64, {-1});
  std::vector<v1::Answer> messages(1);
  *messages[0].mutable_header()->mutable_arrays() = writer.infos();
  messages[0].set_answer_id("the answer");
  const auto put_all = [&] {
    return writer.Put(doubles, 0, arrays.doubles) &&
           writer.Put(narrow, 0, arrays.narrow) &&
           writer.Put(
               vectors, 0, 3 * kCount,
               [&](uint64_t i) { return arrays.vectors[i / 3][i % 3]; }) &&
           writer.Put(floats, 0, kCount,
                      [&](uint64_t i) { return arrays.floats[i]; }) &&
           writer.Put(bytes, 0, kCount,
                      [&](uint64_t i) { return arrays.bytes[i]; }) &&
           writer.Put(words, 0, arrays.words) &&
           writer.Put(longs, 0, kCount,
                      [&](uint64_t i) { return arrays.longs[i]; });
  };
  writer.Begin(messages.back());
  while (!put_all()) writer.Begin(messages.emplace_back());
  EXPECT_TRUE(writer.CheckReceived().ok());
  messages.back().mutable_trailer();
  return messages;
}

class Reading {
 public:
  Reading() {
    constexpr auto kRows = static_cast<int64_t>(kCount);
    constexpr int64_t kAny = AnswerReader::kAny;
    reader_.Collect("doubles", {kRows}, &arrays_.doubles);
    reader_.Collect("narrow", {kRows}, &arrays_.narrow);
    reader_.Collect("vectors", {kRows, 3}, &arrays_.vectors);
    reader_.Collect("floats", {kAny}, &arrays_.floats);
    reader_.Collect("bytes", {kAny}, &arrays_.bytes);
    reader_.Collect("words", {kAny}, &arrays_.words);
    reader_.Collect("longs", {kAny}, &arrays_.longs);
  }

  AnswerReader& reader() { return reader_; }
  const Arrays& arrays() const { return arrays_; }

 private:
  Arrays arrays_;
  AnswerReader reader_;
};

TEST(AnswerRoundTripTest, BringsAllNumbers) {
  const Arrays sent = Sent();
  const std::vector<v1::Answer> messages = Written(sent);
  EXPECT_GT(messages.size(), 10);
  Reading reading;
  for (const v1::Answer& message : messages) {
    ASSERT_TRUE(reading.reader().Consume(message).ok());
  }
  EXPECT_TRUE(reading.reader().has_trailer());
  EXPECT_TRUE(reading.arrays() == sent);
}

// After each message, of which the next stream may end in any.
TEST(AnswerRoundTripTest, GoesOnWhereItBroke) {
  const Arrays sent = Sent();
  Reading reading;
  std::vector<uint64_t> received;
  int streams = 0;
  for (; !reading.reader().has_trailer(); ++streams) {
    ASSERT_LT(streams, 100);
    const v1::Answer first = Written(sent, received).front();
    ASSERT_TRUE(reading.reader().Consume(first).ok());
    if (reading.reader().has_trailer()) break;
    const std::optional<v1::Resumption> rest = reading.reader().Resume();
    ASSERT_TRUE(rest.has_value());
    received = {rest->received().begin(), rest->received().end()};
  }
  EXPECT_GT(streams, 10);
  EXPECT_TRUE(reading.arrays() == sent);
}

// Without any message, and with any block a number short, twice or elsewhere.
TEST(AnswerRoundTripTest, DamagedStreamsAreRefused) {
  const std::vector<v1::Answer> messages = Written(Sent());
  const auto is_refused = [](const std::vector<v1::Answer>& damaged) {
    Reading reading;
    for (const v1::Answer& message : damaged) {
      const absl::Status status = reading.reader().Consume(message);
      if (!status.ok()) return absl::IsDataLoss(status);
    }
    return !reading.reader().has_trailer();
  };
  for (size_t i = 0; i < messages.size(); ++i) {
    std::vector<v1::Answer> damaged = messages;
    damaged.erase(damaged.begin() + static_cast<ptrdiff_t>(i));
    EXPECT_TRUE(is_refused(damaged)) << "without message " << i;
    damaged = messages;
    damaged[i].mutable_blocks(0)->mutable_values()->pop_back();
    EXPECT_TRUE(is_refused(damaged)) << "short message " << i;
    damaged = messages;
    damaged[i].add_blocks()->CopyFrom(damaged[i].blocks(0));
    EXPECT_TRUE(is_refused(damaged)) << "a block twice in message " << i;
    damaged = messages;
    damaged[i].mutable_blocks(0)->set_array(damaged[i].blocks(0).array() + 1);
    EXPECT_TRUE(is_refused(damaged)) << "another array in message " << i;
  }
}

TEST(AnswerRoundTripTest, LinesKeepTheirPoints) {
  const std::vector<SurfacePoint> points = {
      VertexPoint{7}, EdgePoint{1, 2, 0.25}, FacePoint{9, {0.5, 0.25, 0.25}}};
  const std::vector<std::array<double, 3>> places = {
      {0, 0, 0}, {1, 2, 3}, {4, 5, 6}};
  AnswerWriter writer;
  LineWriter lines(writer, 2);
  v1::Answer message;
  *message.mutable_header()->mutable_arrays() = writer.infos();
  writer.Begin(message);
  ASSERT_TRUE(lines.Put(points, places));
  lines.Next();
  ASSERT_TRUE(lines.Put({}, {}));
  lines.Next();
  message.mutable_trailer();

  AnswerReader reader;
  constexpr int64_t kPoints = AnswerReader::kPoints;
  std::vector<std::array<double, 3>> positions;
  std::vector<uint8_t> kinds;
  std::vector<std::array<uint32_t, 2>> numbers;
  std::vector<std::array<double, 3>> weights;
  std::vector<uint64_t> ends;
  reader.Collect("position", {kPoints, 3}, &positions);
  reader.Collect("point_kind", {kPoints}, &kinds);
  reader.Collect("point_numbers", {kPoints, 2}, &numbers);
  reader.Collect("point_weights", {kPoints, 3}, &weights);
  reader.Collect("line_end", {2}, &ends);
  ASSERT_TRUE(reader.Consume(message).ok());
  EXPECT_EQ(positions, places);
  EXPECT_THAT(kinds, ElementsAre(0, 1, 2));
  EXPECT_THAT(numbers, ElementsAre(std::array{7U, 0U}, std::array{1U, 2U},
                                   std::array{9U, 0U}));
  EXPECT_THAT(weights,
              ElementsAre(std::array{0.0, 0.0, 0.0}, std::array{0.25, 0.0, 0.0},
                          std::array{0.5, 0.25, 0.25}));
  EXPECT_THAT(ends, Each(3));
}

}  // namespace
}  // namespace geodesic::codec
