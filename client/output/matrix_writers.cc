#include "client/output/matrix_writers.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/output/approximation_mark.h"
#include "client/output/atomic_file.h"
#include "client/output/number_text.h"
#include "client/output/place_text.h"
#include "client/output/zip_archive.h"

namespace geodesic::client {
namespace {

// Calls `visit(column, value)` for all values of a row, or for the finite ones.
template <typename Visit>
void VisitValues(const MatrixRow& row, bool finite_only, Visit visit) {
  for (size_t i = 0; i < row.values.size(); ++i) {
    if (finite_only && !std::isfinite(row.values[i])) continue;
    visit(row.columns.empty() ? i : row.columns[i], row.values[i]);
  }
}

// A growing .npy file of one dimension, without a name. Its header holds its
// length, so it is written last.
class GrowingNpy {
 public:
  // Creates the file in the folder of `path`, where the archive needs room
  // anyway.
  static absl::StatusOr<GrowingNpy> Create(const std::string& path,
                                           NumberType type) {
    std::filesystem::path folder = std::filesystem::path(path).parent_path();
    if (folder.empty()) folder = ".";
    const int descriptor =
        open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    // Some file systems do not support files without a name.
    const bool is_unknown =
        descriptor < 0 && (errno == EOPNOTSUPP || errno == EISDIR);
    std::FILE* file = descriptor >= 0 ? fdopen(descriptor, "w+b")
                      : is_unknown    ? std::tmpfile()
                                      : nullptr;
    if (file == nullptr) {
      return absl::ErrnoToStatus(errno, absl::StrCat("cannot write ", path));
    }
    GrowingNpy npy(path, file, type);
    npy.Write(std::string(kHeaderSize, ' '));
    return npy;
  }

  void Append(std::span<const double> values) {
    bytes_.clear();
    AppendNumbers(values, type_, &bytes_);
    Write(bytes_);
    count_ += values.size();
  }

  absl::Status Finish() {
    const std::array<uint64_t, 1> shape = {count_};
    const std::string header = NpyHeader(NumpyName(type_), shape, kHeaderSize);
    std::rewind(file_.get());
    Write(header);
    if (std::fflush(file_.get()) != 0 && error_ == 0) error_ = errno;
    // A reader begins at the file's position.
    std::rewind(file_.get());
    return status();
  }

  absl::Status status() const {
    return error_ == 0 ? absl::OkStatus()
                       : absl::ErrnoToStatus(
                             error_, absl::StrCat("cannot write ", path_));
  }

  uint64_t count() const { return count_; }
  // The caller owns the file then.
  std::FILE* Release() { return file_.release(); }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  // Enough for the header of an array of any length.
  static constexpr size_t kHeaderSize = 128;

  GrowingNpy(std::string path, std::FILE* file, NumberType type)
      : path_(std::move(path)), file_(file), type_(type) {}

  void Write(const std::string& bytes) {
    if (error_ == 0 && std::fwrite(bytes.data(), 1, bytes.size(),
                                   file_.get()) != bytes.size()) {
      error_ = errno;
    }
  }

  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
  NumberType type_;
  uint64_t count_ = 0;
  int error_ = 0;
  std::string bytes_;
};

// Writes .npy or .csv, which have a header and then one row after the other.
class PlainMatrixWriter final : public MatrixWriter {
 public:
  PlainMatrixWriter(AtomicFile file, OutputFormat format, NumberType type,
                    const MatrixPlaces& places, std::string mark)
      : file_(std::move(file)),
        format_(format),
        type_(type),
        places_(places),
        mark_(std::move(mark)) {}

  absl::Status Begin(const MatrixShape& shape) override {
    const std::array<uint64_t, 2> sizes = {shape.rows, shape.columns};
    file_.Append(format_ == OutputFormat::kCsv
                     ? MatrixCsvHeader(mark_)
                     : NpyHeader(NumpyName(type_), sizes, 0, mark_));
    return file_.status();
  }

  absl::Status Append(const MatrixRow& row) override {
    if (format_ == OutputFormat::kCsv) {
      file_.Append(CsvRow(places_, row, type_));
    } else {
      AppendNumbers(row.values, type_, &file_);
    }
    return file_.status();
  }

  absl::StatusOr<uint64_t> Commit() override {
    if (absl::Status status = file_.Commit(); !status.ok()) return status;
    return file_.size();
  }

 private:
  AtomicFile file_;
  const OutputFormat format_;
  const NumberType type_;
  const MatrixPlaces places_;
  const std::string mark_;
};

class NpzMatrixWriter final : public MatrixWriter {
 public:
  NpzMatrixWriter(std::string path, GrowingNpy data, GrowingNpy indices,
                  std::string mark)
      : path_(std::move(path)),
        data_(std::move(data)),
        indices_(std::move(indices)),
        mark_(std::move(mark)) {}

  absl::Status Begin(const MatrixShape& shape) override {
    shape_ = shape;
    return absl::OkStatus();
  }

  absl::Status Append(const MatrixRow& row) override {
    std::vector<double> columns;
    std::vector<double> values;
    VisitValues(row, /*finite_only=*/true, [&](uint64_t column, double value) {
      columns.push_back(static_cast<double>(column));
      values.push_back(value);
    });
    data_.Append(values);
    indices_.Append(columns);
    row_ends_.push_back(static_cast<double>(data_.count()));
    absl::Status status = data_.status();
    status.Update(indices_.status());
    return status;
  }

  absl::StatusOr<uint64_t> Commit() override {
    absl::Status status = data_.Finish();
    status.Update(indices_.Finish());
    if (!status.ok()) return status;
    absl::StatusOr<ZipArchive> archive = ZipArchive::Create(path_);
    if (!archive.ok()) return archive.status();
    // SciPy prefers one type for both index arrays.
    const bool is_small = data_.count() <= std::numeric_limits<int32_t>::max();
    archive->Add("indices.npy", indices_.Release());
    archive->Add(
        "indptr.npy",
        NpyArray(row_ends_, is_small ? NumberType::kInt32 : NumberType::kInt64,
                 {row_ends_.size()}));
    archive->Add("format.npy", NpyHeader("|S3", {}) + "csr");
    const std::array<double, 2> sizes = {static_cast<double>(shape_.rows),
                                         static_cast<double>(shape_.columns)};
    archive->Add("shape.npy", NpyArray(sizes, NumberType::kInt64, {2}));
    archive->Add("data.npy", data_.Release());
    if (!mark_.empty()) {
      archive->Add(
          IsToleranceMark(mark_) ? "within_tolerance.npy" : "approximate.npy",
          NpyHeader(absl::StrCat("|S", mark_.size()), {}) + mark_);
    }
    return archive->Commit();
  }

 private:
  std::string path_;
  GrowingNpy data_;
  GrowingNpy indices_;
  std::string mark_;
  std::vector<double> row_ends_ = {0};
  MatrixShape shape_;
};

}  // namespace

std::string MatrixCsvHeader(const std::string& mark) {
  return absl::StrCat("source,target,", DistanceName("distance", mark), "\n");
}

std::string CsvRow(const MatrixPlaces& places, const MatrixRow& row,
                   NumberType type) {
  const std::string source = SourceText(places.sources.at(row.row));
  std::string text;
  CsvLine line;
  VisitValues(row, /*finite_only=*/false, [&](uint64_t column, double value) {
    const std::string target = column < places.targets.size()
                                   ? PointText(places.targets[column])
                                   : NumberText(column);
    text.append(line.Text(source).Text(target).Text(TextOf(value, type)).End());
  });
  return text;
}

absl::StatusOr<std::unique_ptr<MatrixWriter>> CreateMatrixWriter(
    const std::string& path, OutputFormat format, NumberType type,
    const MatrixPlaces& places, const std::string& mark) {
  if (format == OutputFormat::kNpz) {
    absl::StatusOr<GrowingNpy> data = GrowingNpy::Create(path, type);
    if (!data.ok()) return data.status();
    absl::StatusOr<GrowingNpy> indices =
        GrowingNpy::Create(path, NumberType::kInt32);
    if (!indices.ok()) return indices.status();
    return std::make_unique<NpzMatrixWriter>(path, *std::move(data),
                                             *std::move(indices), mark);
  }
  absl::StatusOr<AtomicFile> file = AtomicFile::Create(path);
  if (!file.ok()) return file.status();
  return std::make_unique<PlainMatrixWriter>(*std::move(file), format, type,
                                             places, mark);
}

}  // namespace geodesic::client
