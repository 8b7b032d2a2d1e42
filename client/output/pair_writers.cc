#include "client/output/pair_writers.h"

#include <array>
#include <utility>

#include "client/output/matrix_writers.h"
#include "client/output/number_text.h"
#include "client/output/place_text.h"

namespace geodesic::client {
namespace {

// Enough for the header of an array of any length, which is known at the end.
constexpr size_t kHeaderSize = 128;

std::string Header(NumberType type, uint64_t count) {
  const std::array<uint64_t, 1> shape = {count};
  return NpyHeader(NumpyName(type), shape, kHeaderSize);
}

}  // namespace

std::string CsvPairs(std::span<const PointPair> pairs,
                     std::span<const double> distances) {
  std::string text;
  CsvLine line;
  for (size_t i = 0; i < pairs.size(); ++i) {
    text.append(line.Text(PointText(pairs[i].source))
                    .Text(PointText(pairs[i].target))
                    .Number(distances[i])
                    .End());
  }
  return text;
}

absl::StatusOr<PairWriter> PairWriter::Create(const std::string& path,
                                              OutputFormat format,
                                              NumberType type) {
  absl::StatusOr<AtomicFile> file = AtomicFile::Create(path);
  if (!file.ok()) return file.status();
  file->Append(format == OutputFormat::kCsv ? kMatrixCsvHeader
                                            : Header(type, 0));
  return PairWriter(*std::move(file), format, type);
}

absl::Status PairWriter::Append(std::span<const PointPair> pairs,
                                std::span<const double> distances) {
  if (format_ == OutputFormat::kCsv) {
    file_.Append(CsvPairs(pairs, distances));
  } else {
    AppendNumbers(distances, type_, &file_);
  }
  count_ += pairs.size();
  return file_.status();
}

absl::StatusOr<uint64_t> PairWriter::Commit() {
  if (format_ == OutputFormat::kNpy) file_.Replace(Header(type_, count_));
  if (absl::Status status = file_.Commit(); !status.ok()) return status;
  return file_.size();
}

}  // namespace geodesic::client
