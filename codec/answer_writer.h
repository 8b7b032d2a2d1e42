// Makes the messages of an answer (geodesic/v1/answer.proto).
//
//   AnswerWriter writer(received);
//   const uint32_t distance =
//       writer.Announce("distance", v1::VALUE_TYPE_FLOAT64, {vertices});
//   writer.Begin(message);
//   while (!writer.Put(distance, 0, field.distances)) {
//     ...                    // send the message, which is full
//     writer.Begin(message);
//   }
//
// To go on in the next message, put the same numbers again: the writer knows
// which were made, and drops those that the reader has.

#ifndef GEODESIC_CODEC_ANSWER_WRITER_H_
#define GEODESIC_CODEC_ANSWER_WRITER_H_

#include <google/protobuf/repeated_ptr_field.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/v1/answer.pb.h"
#include "geodesic_types/places.h"

namespace geodesic::codec {

// Not thread-safe.
class AnswerWriter {
 public:
  // Of a message: large enough to stream at the speed of memory, small enough
  // to cost little when a reader stalls.
  static constexpr uint64_t kMessageBytes = uint64_t{512} << 10;

  // `received`: how many numbers of each array the reader has
  // (v1::Resumption).
  explicit AnswerWriter(std::vector<uint64_t> received = {})
      : received_(std::move(received)) {}

  // Adds an array to the header; returns its number. A first dimension of -1 is
  // not known yet.
  uint32_t Announce(const std::string& name, v1::ValueType type,
                    const std::vector<int64_t>& shape);

  // For the header.
  const google::protobuf::RepeatedPtrField<v1::ArrayInfo>& infos() const {
    return infos_;
  }

  // From now on numbers go into this message, in place of the blocks it has,
  // whose memory is used again. It outlives the calls of Put until the next.
  void Begin(v1::Answer& message);

  // Puts those of `count` numbers that were not made yet into the message,
  // until it is full. `first` is the first one's place in the array, and
  // `number(i)` the one at place first + i. Returns whether all are made now.
  // An empty message takes some. Doubles are rounded if the array is of floats;
  // other numbers have the type that was announced.
  // REQUIRES: all before `first` were made.
  template <typename Number>
  bool Put(uint32_t array, uint64_t first, uint64_t count, Number number) {
    using Type = std::invoke_result_t<Number, uint64_t>;
    const Part part = Take(array, first, count);
    if (std::is_same_v<Type, double> && arrays_[array].size == sizeof(float)) {
      Write<float>(part, number);
    } else {
      Write<Type>(part, number);
    }
    return part.end == count;
  }
  bool Put(uint32_t array, uint64_t first, std::span<const double> numbers);
  bool Put(uint32_t array, uint64_t first, std::span<const uint32_t> numbers);
  template <typename Type>
  bool PutOne(uint32_t array, uint64_t place, Type number) {
    return Put(array, place, 1, [number](uint64_t) { return number; });
  }

  // What the message's numbers take.
  uint64_t bytes() const { return bytes_; }

  // Whether the reader has no more than there is. Call once all is put.
  // Errors: INVALID_ARGUMENT naming resumption.received.
  absl::Status CheckReceived() const;

 private:
  struct Array {
    uint32_t size;      // of a number
    uint64_t made = 0;  // numbers that were sent, or that the reader has
    uint64_t end = 0;   // numbers that are known of
    v1::Block* block = nullptr;  // of the message, if it has one
  };
  // Of the numbers of a call of Put, those that go into the message.
  struct Part {
    uint64_t begin;
    uint64_t end;
    std::string* bytes;  // null: none do
  };

  Part Take(uint32_t array, uint64_t first, uint64_t count);
  template <typename Type>
  bool PutBytes(uint32_t array, uint64_t first, std::span<const Type> numbers);

  template <typename Wire, typename Number>
  static void Write(const Part& part, Number& number) {
    if (part.bytes == nullptr) return;
    const size_t size = part.bytes->size();
    part.bytes->resize(size + (part.end - part.begin) * sizeof(Wire));
    char* to = part.bytes->data() + size;
    for (uint64_t i = part.begin; i < part.end; ++i, to += sizeof(Wire)) {
      const Wire wire = static_cast<Wire>(number(i));
      std::memcpy(to, &wire, sizeof(Wire));
    }
  }

  std::vector<uint64_t> received_;
  std::vector<Array> arrays_;
  google::protobuf::RepeatedPtrField<v1::ArrayInfo> infos_;
  v1::Answer* message_ = nullptr;
  uint64_t bytes_ = 0;
};

// The arrays of lines. Not thread-safe.
class LineWriter {
 public:
  // Announces them. `lines`: how many, or -1. REQUIRES: `answer` outlives the
  // object.
  LineWriter(AnswerWriter& answer, int64_t lines);

  // Puts the points of the next line, and where they end; as AnswerWriter::Put.
  bool Put(std::span<const SurfacePoint> points,
           std::span<const std::array<double, 3>> positions);

  // The number of the next line.
  uint64_t line() const { return line_; }
  // The line that was put is done with, and what else is told of it.
  void Next() {
    ++line_;
    first_ = end_;
  }

 private:
  AnswerWriter& answer_;
  uint32_t position_;
  uint32_t kind_;
  uint32_t numbers_;
  uint32_t weights_;
  uint32_t line_end_;
  uint64_t line_ = 0;
  uint64_t first_ = 0;  // point of the line
  uint64_t end_ = 0;
};

}  // namespace geodesic::codec

#endif  // GEODESIC_CODEC_ANSWER_WRITER_H_
