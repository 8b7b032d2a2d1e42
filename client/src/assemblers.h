// Puts together what travels in pieces. Memory grows with the bytes that have
// arrived, not with the counts announced. None of this is thread-safe.

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

// Numbers are copied as they come.
static_assert(std::endian::native == std::endian::little);

// Appends the elements that `bytes` holds. Returns false, and does nothing, if
// it holds a part of one.
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

// Errors: DATA_LOSS unless as many `items` have come as were to.
absl::Status CheckCount(std::string_view items, uint64_t received,
                        uint64_t expected);

// Puts polylines together, one after the other.
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

// Puts the rows of a matrix together, and holds one.
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

  // The mesh, after the stream has ended well; every index is that of a vertex.
  // Errors: DATA_LOSS if anything is missing.
  absl::StatusOr<MeshArrays> Finish() &&;

 private:
  MeshArrays mesh_;
  uint64_t vertex_count_ = 0;
  uint64_t face_count_ = 0;
  bool has_header_ = false;
};

// Puts a distance field together from the messages of a ComputeField stream.
//
class FieldAssembler {
 public:
  // For the answer to `query`, which outlives this. With `on_settled` the field
  // is progressive: settled vertices come instead of chunks. Both callbacks may
  // be empty.
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

  // After a stream has broken: the next one is to begin where this one ended,
  // or at the start if what came cannot be added to.
  struct Position {
    std::string field_id;  // empty: at the start
    uint64_t first_vertex = 0;
  };
  Position Resume();
  // After a stream has broken: the next one begins at the start.
  void Restart();

  // The field, after the stream has ended well.
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
