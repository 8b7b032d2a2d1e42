// Writes distances of pairs as they come. Memory holds those of one call.

#ifndef GEODESIC_CLIENT_OUTPUT_PAIR_WRITERS_H_
#define GEODESIC_CLIENT_OUTPUT_PAIR_WRITERS_H_

#include <cstdint>
#include <span>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "client/output/atomic_file.h"
#include "client/output/binary_numbers.h"
#include "client/output/output_format.h"
#include "geodesic_client/pairs.h"

namespace geodesic::client {

// A line for each pair, "source,target,distance"; places are as the command
// line has them, distances have the digits of `type`. REQUIRES: as many
// distances as pairs.
std::string CsvPairs(std::span<const PointPair> pairs,
                     std::span<const double> distances, NumberType type);

// Writes .csv, lines as above with a header, or .npy, an array of one
// dimension. Nothing appears under the file's name before Commit. Not
// thread-safe.
class PairWriter {
 public:
  // `type` is that of the values, a float type. `mark`: as CreateMatrixWriter.
  // Errors: those of opening files for writing, naming the path.
  static absl::StatusOr<PairWriter> Create(const std::string& path,
                                           OutputFormat format, NumberType type,
                                           const std::string& mark = "");

  // Appends more pairs. REQUIRES: as CsvPairs. Errors: those of writing, naming
  // the path.
  absl::Status Append(std::span<const PointPair> pairs,
                      std::span<const double> distances);

  // Puts the file in its place. Returns its size in bytes.
  absl::StatusOr<uint64_t> Commit();

 private:
  PairWriter(AtomicFile file, OutputFormat format, NumberType type,
             std::string mark)
      : file_(std::move(file)),
        format_(format),
        type_(type),
        mark_(std::move(mark)) {}

  AtomicFile file_;
  OutputFormat format_;
  NumberType type_;
  std::string mark_;
  uint64_t count_ = 0;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_OUTPUT_PAIR_WRITERS_H_
