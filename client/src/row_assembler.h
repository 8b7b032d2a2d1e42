// Puts the rows of a matrix together from the pieces they travel in.

#ifndef GEODESIC_CLIENT_ROW_ASSEMBLER_H_
#define GEODESIC_CLIENT_ROW_ASSEMBLER_H_

#include <cstdint>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "geodesic_client/answer.h"

namespace geodesic::client {

// A piece of a row: see MatrixChunk and NearestChunk in matrix_service.proto.
struct RowPiece {
  uint64_t row = 0;
  uint64_t value_count = 0;
  uint64_t offset = 0;
  // Columns or targets; empty in a dense row.
  std::string_view numbers;
  std::string_view values;
};

// Holds one row. Not thread-safe.
class RowAssembler {
 public:
  RowAssembler(ValueType value_type, bool has_numbers)
      : value_type_(value_type), has_numbers_(has_numbers) {}

  // Whether the row that began last is whole; then the next one is due.
  bool complete() const { return complete_; }
  uint64_t row() const { return row_count_ - (complete_ ? 1 : 0); }
  // Rows that are whole.
  uint64_t row_count() const { return row_count_; }

  const std::vector<uint32_t>& numbers() const { return numbers_; }
  const std::vector<double>& values() const { return values_; }

  // Numbers are below `column_count`, as is how many values a row may have.
  // Errors: DATA_LOSS for a piece other than the one that is due; memory never
  // grows by more than the bytes that have arrived.
  absl::Status Consume(const RowPiece& piece, uint64_t column_count);

 private:
  ValueType value_type_;
  bool has_numbers_;
  bool complete_ = true;
  uint64_t row_count_ = 0;
  std::vector<uint32_t> numbers_;
  std::vector<double> values_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_ROW_ASSEMBLER_H_
