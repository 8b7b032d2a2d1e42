// Puts together what the server sends in pieces. Memory grows with the bytes
// that have arrived, not with the announced counts. None of this is
// thread-safe.

#ifndef GEODESIC_CLIENT_ASSEMBLERS_H_
#define GEODESIC_CLIENT_ASSEMBLERS_H_

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/v1/field_service.pb.h"
#include "geodesic/v1/mesh_service.pb.h"
#include "geodesic/v1/surface.pb.h"
#include "geodesic_client/answer.h"
#include "geodesic_client/field.h"
#include "geodesic_client/mesh.h"
#include "geodesic_client/questions.h"

namespace geodesic::client {

// Numbers arrive little endian and are copied as they are.
static_assert(std::endian::native == std::endian::little);

// Appends the elements that `bytes` holds. Returns false and appends nothing if
// the last one is not whole.
template <typename Element>
bool AppendElements(std::string_view bytes, std::vector<Element>* elements) {
  static_assert(std::is_trivially_copyable_v<Element>);
  if (bytes.size() % sizeof(Element) != 0) return false;
  const size_t had = elements->size();
  elements->resize(had + bytes.size() / sizeof(Element));
  if (!bytes.empty()) {
    std::memcpy(elements->data() + had, bytes.data(), bytes.size());
  }
  return true;
}

// The same for real numbers, which may travel as floats. A `Value` is a double
// or an array of doubles.
template <typename Value>
bool AppendValues(std::string_view bytes, ValueType type,
                  std::vector<Value>* values) {
  if (type == ValueType::kFloat64) return AppendElements(bytes, values);
  std::vector<float> floats;
  if (!AppendElements(bytes, &floats)) return false;
  const std::vector<double> doubles(floats.begin(), floats.end());
  return AppendElements({reinterpret_cast<const char*>(doubles.data()),
                         doubles.size() * sizeof(double)},
                        values);
}

// Errors: DATA_LOSS unless `received` is `expected`; `items` names what is
// counted.
absl::Status CheckCount(std::string_view items, uint64_t received,
                        uint64_t expected);

// Puts polylines together, one after the other.
class PolylineAssembler {
 public:
  // Whether the next piece begins a line.
  bool complete() const { return due_ == 0; }

  // Appends a piece to `line`, which is empty before its first piece.
  // Errors: DATA_LOSS for a piece other than the one that is due.
  absl::Status Consume(const v1::PolylinePiece& piece, Polyline* line);

 private:
  // Points of the line that have not arrived.
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

// Puts the rows of a matrix together. Holds one row at a time.
class RowAssembler {
 public:
  RowAssembler(ValueType value_type, bool has_numbers)
      : value_type_(value_type), has_numbers_(has_numbers) {}

  // Whether the current row is whole and the next one is due.
  bool complete() const { return complete_; }
  uint64_t row() const { return row_count_ - (complete_ ? 1 : 0); }
  // How many rows are whole.
  uint64_t row_count() const { return row_count_; }

  const std::vector<uint32_t>& numbers() const { return numbers_; }
  const std::vector<double>& values() const { return values_; }

  // Takes a piece of the row that is due. A row has at most `column_count`
  // values, and its numbers are below that.
  // Errors: DATA_LOSS for a piece other than the one that is due.
  absl::Status Consume(const RowPiece& piece, uint64_t column_count);

 private:
  ValueType value_type_;
  bool has_numbers_;
  bool complete_ = true;
  uint64_t row_count_ = 0;
  std::vector<uint32_t> numbers_;
  std::vector<double> values_;
};

// Puts a mesh together from the messages of a ReadMesh stream.
class MeshAssembler {
 public:
  // Takes the next message of the stream.
  // Errors: DATA_LOSS if it breaks the stream's protocol.
  absl::Status Consume(const v1::ReadMeshResponse& message);

  // The mesh, once the stream has ended without error. Every index is checked.
  // Errors: DATA_LOSS if anything is missing.
  absl::StatusOr<MeshArrays> Finish() &&;

 private:
  MeshArrays mesh_;
  uint64_t vertex_count_ = 0;
  uint64_t face_count_ = 0;
  bool has_header_ = false;
};

// Puts a distance field together from the messages of a ComputeField stream.
class FieldAssembler {
 public:
  // Assembles the answer to `query`, which must outlive the object. With
  // `on_settled` the field is progressive: the server sends settled vertices
  // instead of chunks. Both callbacks may be empty.
  FieldAssembler(const FieldQuery& query, SettledCallback on_settled,
                 SolveProgressCallback progress)
      : query_(query),
        on_settled_(std::move(on_settled)),
        progress_(std::move(progress)) {}

  // Takes the next message of the stream.
  // Errors: DATA_LOSS if it breaks the stream's protocol.
  absl::Status Consume(const v1::ComputeFieldResponse& message);

  // Whether the server has begun to answer.
  bool has_header() const { return has_header_; }
  uint64_t received() const { return field_.distances.size(); }

  // To be called after a stream has broken. Returns where the next one must
  // begin: where this one ended, or at the start if the field cannot be
  // continued.
  struct Position {
    std::string field_id;  // empty: at the start
    uint64_t first_vertex = 0;
  };
  Position Resume();
  // To be called after a stream has broken, if the next one begins at the
  // start.
  void Restart();

  // The field, once the stream has ended without error.
  // Errors: DATA_LOSS if anything is missing.
  absl::StatusOr<Field> Finish() &&;

 private:
  absl::Status ConsumeChunk(const v1::FieldChunk& chunk);
  absl::Status ConsumeTargets(const v1::TargetChunk& chunk);
  absl::Status ConsumeSettled(const v1::SettledChunk& chunk);
  absl::Status TakeHeader(const v1::FieldHeader& header);

  const FieldQuery& query_;
  SettledCallback on_settled_;
  SolveProgressCallback progress_;
  Field field_;
  uint64_t settled_count_ = 0;
  std::string field_id_;
  bool has_header_ = false;
  bool complete_ = false;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_ASSEMBLERS_H_
