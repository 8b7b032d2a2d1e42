// matrix: distances between many points, row by row to files or the terminal.

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/cli/commands.h"
#include "client/cli/question.h"
#include "client/output/csv.h"
#include "client/output/matrix_writers.h"

namespace geodesic::client {
namespace {

// The largest finite distance and how many finite ones there are.
struct MatrixSummary {
  MatrixShape shape;
  uint64_t finite = 0;
  double largest = 0;
};

// The writers of all outputs, or the terminal if there are none.
class Destination {
 public:
  explicit Destination(const Session& session) : session_(session) {}

  // Errors: those of opening files.
  absl::Status Open(NumberType type) {
    for (const OutputArgument& output : session_.arguments.outputs) {
      absl::StatusOr<std::unique_ptr<MatrixWriter>> writer =
          CreateMatrixWriter(output.path, output.format, type);
      if (!writer.ok()) return FileError(writer.status());
      writers_.push_back(*std::move(writer));
    }
    return absl::OkStatus();
  }

  MatrixReceiver Receiver(Stopwatch* watch) {
    return {.on_shape = [this](const MatrixShape& s) { return Begin(s); },
            .on_row = [this](const MatrixRow& row) { return Append(row); },
            .on_progress = watch->OnCount("rows")};
  }

  absl::StatusOr<std::vector<WrittenFile>> Commit() {
    size_t next = 0;
    return WriteOutputs(
        session_, [&](const OutputArgument&) -> absl::StatusOr<uint64_t> {
          absl::StatusOr<uint64_t> size = writers_[next++]->Commit();
          if (!size.ok()) return FileError(size.status());
          return size;
        });
  }

  const MatrixSummary& summary() const { return summary_; }
  // With --json and no file: the rows.
  const Json& rows() const { return rows_; }

 private:
  bool is_text() const { return writers_.empty() && !session_.arguments.json; }

  absl::Status Begin(const MatrixShape& shape) {
    summary_.shape = shape;
    if (is_text()) session_.out << "source,target,distance\n";
    for (const auto& writer : writers_) {
      absl::Status status = writer->Begin(shape);
      if (!status.ok()) return FileError(status);
    }
    return absl::OkStatus();
  }

  absl::Status Append(const MatrixRow& row) {
    for (const double value : row.values) {
      if (!std::isfinite(value)) continue;
      ++summary_.finite;
      summary_.largest = std::max(summary_.largest, value);
    }
    if (is_text()) Print(row);
    if (writers_.empty() && session_.arguments.json) {
      rows_.push_back({{"columns", std::vector<uint32_t>(row.columns.begin(),
                                                         row.columns.end())},
                       {"distances", std::vector<double>(row.values.begin(),
                                                         row.values.end())}});
    }
    for (const auto& writer : writers_) {
      absl::Status status = writer->Append(row);
      if (!status.ok()) return FileError(status);
    }
    return absl::OkStatus();
  }

  void Print(const MatrixRow& row) const {
    CsvLine line;
    for (size_t i = 0; i < row.values.size(); ++i) {
      const size_t column = row.columns.empty() ? i : row.columns[i];
      line.Integer(static_cast<int64_t>(row.row))
          .Integer(static_cast<int64_t>(column))
          .Number(row.values[i]);
      session_.out << line.End();
    }
  }

  const Session& session_;
  std::vector<std::unique_ptr<MatrixWriter>> writers_;
  MatrixSummary summary_;
  Json rows_ = Json::array();
};

// Rows travel dense if a file needs them so; .npz never does.
bool IsSparse(const Arguments& arguments) {
  if (arguments.outputs.empty()) return arguments.radius.has_value();
  return std::ranges::all_of(arguments.outputs,
                             [&arguments](const OutputArgument& output) {
                               return output.format == OutputFormat::kNpz ||
                                      (output.format == OutputFormat::kCsv &&
                                       arguments.radius.has_value());
                             });
}

}  // namespace

absl::Status RunMatrix(const Session& session) {
  const Arguments& arguments = session.arguments;
  absl::StatusOr<Question> question = Prepare(session);
  if (!question.ok()) return question.status();
  Destination destination(session);
  absl::Status opened = destination.Open(
      arguments.float32 ? NumberType::kFloat32 : NumberType::kFloat64);
  if (!opened.ok()) return opened;
  Stopwatch watch(session);
  absl::StatusOr<AnswerInfo> info = session.client.ComputeMatrix(
      {.mesh_digest = question->mesh_digest,
       .sources = question->sources,
       .targets = question->targets,
       .algorithm = arguments.algorithm,
       .value_type =
           arguments.float32 ? ValueType::kFloat32 : ValueType::kFloat64,
       .max_distance = arguments.radius,
       .sparse = IsSparse(arguments),
       .priority = arguments.priority},
      destination.Receiver(&watch), session.call);
  if (!info.ok()) return info.status();
  const double seconds = watch.seconds();
  absl::StatusOr<std::vector<WrittenFile>> files = destination.Commit();
  if (!files.ok()) return files.status();

  const MatrixSummary& summary = destination.summary();
  if (arguments.json) {
    Json json = AnswerJson(*question, *info, seconds);
    json["rows"] = summary.shape.rows;
    json["columns"] = summary.shape.columns;
    json["finite_values"] = summary.finite;
    json["max_distance"] = summary.largest;
    if (files->empty()) json["matrix"] = destination.rows();
    json["outputs"] = ToJson(*files);
    PrintJson(json, &session.out);
  } else if (!files->empty()) {
    std::vector<Fact> facts = {
        {"mesh", info->mesh_digest},
        {"algorithm", info->algorithm},
        {"matrix",
         absl::StrCat(GroupedNumber(summary.shape.rows), " rows x ",
                      GroupedNumber(summary.shape.columns), " columns")},
        {"finite values", GroupedNumber(summary.finite)},
        {"largest distance", ShortNumber(summary.largest)}};
    AddClosingFacts(*info, seconds, *files, &facts);
    PrintFacts(facts, &session.out);
  }
  return absl::OkStatus();
}

}  // namespace geodesic::client
