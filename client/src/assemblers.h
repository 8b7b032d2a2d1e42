// Puts together what travels in pieces. Memory grows with the bytes that have
// arrived, not with the counts announced.

#ifndef GEODESIC_CLIENT_ASSEMBLERS_H_
#define GEODESIC_CLIENT_ASSEMBLERS_H_

#include <cstdint>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/v1/mesh_service.pb.h"
#include "geodesic/v1/surface.pb.h"
#include "geodesic_client/answer.h"
#include "geodesic_client/mesh.h"
#include "geodesic_client/polyline.h"

namespace geodesic::client {

// Puts polylines together, one after the other. Not thread-safe.
class PolylineAssembler {
 public:
  // Whether the next piece begins a line.
  bool complete() const { return due_ == 0; }

  // Appends a piece to `line`, which is empty where a line begins.
  // Errors: DATA_LOSS for a piece other than the one that is due.
  absl::Status Consume(const v1::PolylinePiece& piece, Polyline* line);

 private:
  // Points of the line that have not come.
  uint64_t due_ = 0;
};

// A piece of a row: see MatrixChunk and NearestChunk in matrix_service.proto.
struct RowPiece {
  uint64_t row = 0;
  uint64_t value_count = 0;
  uint64_t offset = 0;
  // Columns or targets; empty in a dense row.
  std::string_view numbers;
  std::string_view values;
};

// Puts the rows of a matrix together, and holds one. Not thread-safe.
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

// Puts a mesh together from the messages of a ReadMesh stream. Not thread-safe.
class MeshAssembler {
 public:
  // Takes the next message of the stream. Memory grows with the bytes that have
  // arrived, not with the counts announced.
  // Errors: DATA_LOSS if it breaks the stream's protocol.
  absl::Status Consume(const v1::ReadMeshResponse& message);

  // The mesh, after the stream has ended well; every index is that of a vertex.
  // Errors: DATA_LOSS if anything is missing.
  absl::StatusOr<MeshArrays> Finish() &&;

 private:
  MeshArrays mesh_;
  uint64_t vertex_count_ = 0;
  uint64_t face_count_ = 0;
  bool has_header_ = false;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_ASSEMBLERS_H_
