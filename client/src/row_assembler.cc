#include "row_assembler.h"

#include <algorithm>

#include "absl/strings/str_cat.h"
#include "wire_values.h"

namespace geodesic::client {

absl::Status RowAssembler::Consume(const RowPiece& piece,
                                   uint64_t column_count) {
  if (complete_) {
    numbers_.clear();
    values_.clear();
  }
  const size_t had = values_.size();
  const bool count_fits = has_numbers_ ? piece.value_count <= column_count
                                       : piece.value_count == column_count;
  if (piece.row != row_count_ || piece.offset != had || !count_fits ||
      !AppendValues(piece.values, value_type_, &values_) ||
      !AppendElements(piece.numbers, &numbers_) ||
      numbers_.size() != (has_numbers_ ? values_.size() : 0) ||
      values_.size() > piece.value_count ||
      (values_.size() == had && piece.value_count != had)) {
    return absl::DataLossError(
        absl::StrCat("the server sent row ", piece.row, " from value ",
                     piece.offset, " of ", piece.value_count, " where row ",
                     row_count_, " from value ", had, " was due"));
  }
  if (std::any_of(numbers_.begin() + (has_numbers_ ? had : 0), numbers_.end(),
                  [&](uint32_t number) { return number >= column_count; })) {
    return absl::DataLossError(absl::StrCat("the server sent row ", piece.row,
                                            " with a column beyond its ",
                                            column_count));
  }
  complete_ = values_.size() == piece.value_count;
  if (complete_) ++row_count_;
  return absl::OkStatus();
}

}  // namespace geodesic::client
