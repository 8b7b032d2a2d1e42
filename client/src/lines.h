// The parts of answers that an array of ends divides into groups: points into
// lines, values into rows.

#ifndef GEODESIC_CLIENT_LINES_H_
#define GEODESIC_CLIENT_LINES_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "codec/answer_reader.h"
#include "geodesic_client/mesh.h"
#include "geodesic_client/questions.h"

namespace geodesic::client {

// Removes the first elements.
template <typename Element>
void DropFront(size_t count, std::vector<Element>* elements) {
  elements->erase(elements->begin(),
                  elements->begin() + static_cast<ptrdiff_t>(count));
}

// Groups of elements, numbered in their order.
struct Groups {
  // Calls `take` with the number of each group that is due, its first element
  // and its size, for those before group `end` that have arrived whole. There
  // are `there` elements, and no more come if `is_complete`. Returns how many
  // were taken.
  // Errors: those of `take`; DATA_LOSS if a group cannot become whole.
  absl::StatusOr<size_t> Take(
      size_t there, bool is_complete, uint64_t end,
      const std::function<absl::Status(uint64_t, size_t, size_t)>& take);

  std::vector<uint64_t> ends;
  uint64_t due = 0;
  uint64_t taken = 0;  // elements
};

// Lines, as answer.proto has them.
class Lines {
 public:
  // `count`: how many there are, or codec::AnswerReader's kAny.
  Lines(int64_t count, codec::AnswerReader* reader);

  // Hands out those before number `end` that have arrived whole.
  // Errors: those of `on_line`; DATA_LOSS if a line or a point is none.
  absl::Status Take(const std::function<absl::Status(Polyline)>& on_line,
                    uint64_t end = std::numeric_limits<uint64_t>::max());

 private:
  const codec::AnswerReader& reader_;
  Groups groups_;
  std::vector<Point> positions_;
  std::vector<uint8_t> kinds_;
  std::vector<std::array<uint32_t, 2>> numbers_;
  std::vector<std::array<double, 3>> weights_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_LINES_H_
