// Reads answers, as geodesic/v1/answer.proto has them.

#ifndef GEODESIC_CODEC_ANSWER_READER_H_
#define GEODESIC_CODEC_ANSWER_READER_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/v1/answer.pb.h"
#include "geodesic/v1/query.pb.h"

namespace geodesic::codec {

// Checks the messages of an answer, and puts the numbers of its arrays where
// they are wanted. Memory grows with the bytes that have arrived, not with the
// announced counts. Not thread-safe.
class AnswerReader {
 public:
  // An array's shape. Of the dimensions that the reader does not know, those
  // with the same name turn out the same. Others below 0 name more of them.
  using Shape = std::vector<int64_t>;
  static constexpr int64_t kVertices = -1;  // of the answer's mesh
  static constexpr int64_t kAny = -2;
  static constexpr int64_t kPoints = -3;  // of lines

  // Where the numbers of an array go: each into an element, or as many as the
  // last dimension has.
  using Values =
      std::variant<std::vector<double>*, std::vector<std::array<double, 2>>*,
                   std::vector<std::array<double, 3>>*, std::vector<float>*,
                   std::vector<uint8_t>*, std::vector<uint32_t>*,
                   std::vector<std::array<uint32_t, 2>>*,
                   std::vector<uint64_t>*>;

  // Appends the elements of an array to `values`, floats also to doubles. An
  // answer without this array is refused. To be called before the first message
  // comes. Between messages the caller may take elements out of `values`, from
  // the first on.
  void Collect(std::string_view name, const Shape& shape, Values values);

  // Takes the next message of the stream.
  // Errors: DATA_LOSS if it breaks the protocol.
  absl::Status Consume(const v1::Answer& message);

  // Whether the server has begun to answer, and whether the answer is complete.
  bool has_header() const { return is_begun_; }
  bool has_trailer() const { return is_complete_; }
  const v1::AnswerHeader& header() const { return header_; }
  const v1::AnswerTrailer& trailer() const { return trailer_; }
  // How many numbers have arrived.
  uint64_t received() const;

  // To be called after a stream has broken. Returns what asks for the rest, or
  // nothing if the answer can only be begun anew, after Restart.
  std::optional<v1::Resumption> Resume();
  // Drops all that has arrived.
  void Restart();

 private:
  struct Wanted {
    std::string name;
    Shape shape;
    Values values;
  };
  // Of the header.
  struct Array {
    // How many numbers share the first index, and how many there are.
    uint64_t per_row = 1;
    std::optional<uint64_t> count = {};
    uint64_t received = 0;
    std::optional<Wanted> wanted = {};
    // The beginning of an element that does not end in the same block.
    std::string rest = {};
  };

  absl::Status TakeHeader(const v1::AnswerHeader& header);
  absl::Status TakeBlock(const v1::Block& block);
  absl::Status CheckComplete() const;

  std::vector<Wanted> wanted_;
  v1::AnswerHeader header_;
  std::vector<Array> arrays_;
  v1::AnswerTrailer trailer_;
  std::string answer_id_;
  bool is_begun_ = false;
  bool is_complete_ = false;
};

}  // namespace geodesic::codec

#endif  // GEODESIC_CODEC_ANSWER_READER_H_
