#include "server/rpc/streams/matrix_stream.h"

#include "absl/strings/str_cat.h"
#include "geodesic/field_path.h"

namespace geodesic::server {

absl::Status MatrixStream::Translate(MatrixRequest& question) const {
  switch (request().layout()) {
    case v1::MATRIX_LAYOUT_UNSPECIFIED:
    case v1::MATRIX_LAYOUT_DENSE:
      return absl::OkStatus();
    case v1::MATRIX_LAYOUT_SPARSE:
      question.sparse = true;
      return absl::OkStatus();
    default:
      return InvalidField(
          "layout",
          absl::StrCat("layout is ", static_cast<int>(request().layout()),
                       ", which this server does not know"));
  }
}

MatrixStream::Chunk MatrixStream::MakeChunk(v1::ComputeMatrixResponse& message,
                                            uint64_t row, uint64_t value_count,
                                            uint64_t offset) const {
  auto& chunk = *message.mutable_chunk();
  chunk.set_row(row);
  chunk.set_value_count(value_count);
  chunk.set_offset(offset);
  return {chunk.mutable_columns(), chunk.mutable_values()};
}

}  // namespace geodesic::server
