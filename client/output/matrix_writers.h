// Writes matrices of distances row by row. Memory holds one row.

#ifndef GEODESIC_CLIENT_OUTPUT_MATRIX_WRITERS_H_
#define GEODESIC_CLIENT_OUTPUT_MATRIX_WRITERS_H_

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "client/output/binary_numbers.h"
#include "client/output/output_format.h"
#include "geodesic_client/questions.h"
#include "geodesic_types/places.h"

namespace geodesic::client {

// The places of rows and columns. Without targets every vertex is a column.
struct MatrixPlaces {
  std::vector<Source> sources;
  std::vector<SurfacePoint> targets;
};

// The line above them.
std::string MatrixCsvHeader(const std::string& mark);

// A line for each value of the row, with the digits of `type`. It names source
// and target as the command line does.
std::string CsvRow(const MatrixPlaces& places, const MatrixRow& row,
                   NumberType type);

// Nothing appears under the file's name before Commit. Not thread-safe.
class MatrixWriter {
 public:
  virtual ~MatrixWriter() = default;

  // Called once, before the rows.
  // Errors: those of writing files, naming the path. The other functions have
  // the same errors.
  virtual absl::Status Begin(const MatrixShape& shape) = 0;

  // Called for every row, in order.
  virtual absl::Status Append(const MatrixRow& row) = 0;

  // Puts the file in its place. Returns its size in bytes.
  virtual absl::StatusOr<uint64_t> Commit() = 0;
};

// .npy: dense, shape (rows, columns); takes dense rows only.
// .npz: compressed sparse rows as scipy.sparse.load_npz reads them: data,
//   indices, indptr, shape, format. Of dense rows the finite values are kept.
//   While it grows, data and indices wait in files without a name beside it.
// .csv: "source,target,distance", a line for each value, as CsvRow has it.
// `type` is that of the values, a float type. A `mark`
// (approximation_mark.h) is in the header of .npy, in the member "approximate"
// or "within_tolerance" of .npz and in the column's name of .csv. Errors: those
// of opening files for writing, naming the path.
absl::StatusOr<std::unique_ptr<MatrixWriter>> CreateMatrixWriter(
    const std::string& path, OutputFormat format, NumberType type,
    const MatrixPlaces& places, const std::string& mark = "");

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_OUTPUT_MATRIX_WRITERS_H_
