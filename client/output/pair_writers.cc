#include "client/output/pair_writers.h"

#include <array>
#include <utility>

#include "client/output/matrix_writers.h"
#include "client/output/number_text.h"
#include "client/output/place_text.h"

namespace geodesic::client {
namespace {

// Enough for the header of an array of any length, which is known at the end,
// without a mark and with one.
constexpr size_t kHeaderSize = 128;
constexpr size_t kMarkedHeaderSize = 256;

std::string Header(NumberType type, uint64_t count, const std::string& mark) {
  const std::array<uint64_t, 1> shape = {count};
  return NpyHeader(NumpyName(type), shape,
                   mark.empty() ? kHeaderSize : kMarkedHeaderSize, mark);
}

}  // namespace

std::string CsvPairs(std::span<const PointPair> pairs,
                     std::span<const double> distances, NumberType type) {
  std::string text;
  CsvLine line;
  for (size_t i = 0; i < pairs.size(); ++i) {
    text.append(line.Text(PointText(pairs[i].source))
                    .Text(PointText(pairs[i].target))
                    .Text(TextOf(distances[i], type))
                    .End());
  }
  return text;
}

absl::StatusOr<PairWriter> PairWriter::Create(const std::string& path,
                                              OutputFormat format,
                                              NumberType type,
                                              const std::string& mark) {
  absl::StatusOr<AtomicFile> file = AtomicFile::Create(path);
  if (!file.ok()) return file.status();
  file->Append(format == OutputFormat::kCsv ? MatrixCsvHeader(mark)
                                            : Header(type, 0, mark));
  return PairWriter(*std::move(file), format, type, mark);
}

absl::Status PairWriter::Append(std::span<const PointPair> pairs,
                                std::span<const double> distances) {
  if (format_ == OutputFormat::kCsv) {
    file_.Append(CsvPairs(pairs, distances, type_));
  } else {
    AppendNumbers(distances, type_, &file_);
  }
  count_ += pairs.size();
  return file_.status();
}

absl::StatusOr<uint64_t> PairWriter::Commit() {
  if (format_ == OutputFormat::kNpy)
    file_.Replace(Header(type_, count_, mark_));
  if (absl::Status status = file_.Commit(); !status.ok()) return status;
  return file_.size();
}

}  // namespace geodesic::client
