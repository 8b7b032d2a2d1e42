// matrix: distances between many points, row by row to files or the terminal.

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/cli/commands/command.h"
#include "client/cli/commands/notes.h"
#include "client/cli/commands/outputs.h"
#include "client/cli/commands/question.h"
#include "client/cli/commands/report.h"
#include "client/cli/commands/stopwatch.h"
#include "client/cli/terminal/exit_code.h"
#include "client/output/matrix_writers.h"

namespace geodesic::client {
namespace {

void AddOptions(CLI::App* app, QuestionArguments* arguments) {
  arguments->may_be_approximate = true;
  arguments->may_have_tolerance = true;
  AddMesh(app, kMeshHelp, &arguments->mesh);
  AddSources(app, Need::kRequired, &arguments->sources);
  AddTargets(app, Need::kOptional,
             "Make this point a column (default: every vertex)",
             &arguments->targets);
  AddRadius(app, "Leave out distances beyond this one", &arguments->radius);
  AddFloat32(app, &arguments->float32);
  AddQuestion(app,
              "Write the matrix here, row by row: dense to .npy, as sparse "
              "rows to .npz (scipy.sparse.load_npz reads it), as "
              "source,target,distance to .csv",
              kMatrixFormats, arguments);
}

// The largest finite distance and how many finite ones there are.
struct MatrixSummary {
  MatrixShape shape;
  uint64_t finite = 0;
  double largest = 0;
};

// The writers of all outputs, or the terminal if there are none.
class Destination {
 public:
  Destination(const Session& session, const Question& question,
              const QuestionArguments& arguments)
      : session_(session),
        outputs_(arguments.outputs),
        type_(NumberTypeOf(arguments.float32)),
        mark_(arguments.mark()),
        places_{question.sources, question.targets} {}

  // Errors: those of opening files.
  absl::Status Open() {
    for (const OutputArgument& output : outputs_) {
      absl::StatusOr<std::unique_ptr<MatrixWriter>> writer =
          CreateMatrixWriter(output.path, output.format, type_, places_, mark_);
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
    const auto write = [&](const OutputArgument&,
                           const MeshArrays&) -> absl::StatusOr<uint64_t> {
      absl::StatusOr<uint64_t> size = writers_[next++]->Commit();
      if (!size.ok()) return FileError(size.status());
      return size;
    };
    return WriteOutputs(session_, outputs_, /*info=*/{}, /*with_mesh=*/{},
                        write);
  }

  const MatrixSummary& summary() const { return summary_; }
  // The rows, with --json and without files.
  const Json& rows() const { return rows_; }

 private:
  bool is_text() const { return writers_.empty() && !session_.json; }

  absl::Status Begin(const MatrixShape& shape) {
    summary_.shape = shape;
    if (is_text()) session_.out << MatrixCsvHeader(mark_);
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
    if (is_text()) session_.out << CsvRow(places_, row, type_);
    if (!session_.out) return OutputFailed();
    if (writers_.empty() && session_.json) {
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

  const Session& session_;
  const std::vector<OutputArgument>& outputs_;
  const NumberType type_;
  const std::string mark_;
  const MatrixPlaces places_;
  std::vector<std::unique_ptr<MatrixWriter>> writers_;
  MatrixSummary summary_;
  Json rows_ = Json::array();
};

// Rows travel dense if a file needs all values; .npz never does.
bool IsSparse(const QuestionArguments& arguments) {
  const bool is_limited = arguments.radius.has_value();
  const std::vector<OutputArgument>& outputs = arguments.outputs;
  if (outputs.empty()) return is_limited;
  return std::ranges::all_of(outputs, [is_limited](const auto& output) {
    return output.format == OutputFormat::kNpz ||
           (output.format == OutputFormat::kCsv && is_limited);
  });
}

absl::Status Answer(const QuestionArguments& arguments, const Session& session,
                    const Question& question) {
  Destination destination(session, question, arguments);
  absl::Status opened = destination.Open();
  if (!opened.ok()) return opened;
  Stopwatch watch(session);
  auto query = MakeQuery<MatrixQuery>(arguments, question);
  query.sparse = IsSparse(arguments);
  absl::StatusOr<AnswerInfo> info = session.client.ComputeMatrix(
      query, destination.Receiver(&watch), session.call);
  if (!info.ok()) return info.status();
  const double seconds = watch.seconds();
  absl::StatusOr<std::vector<WrittenFile>> files = destination.Commit();
  if (!files.ok()) return files.status();
  // If the rows went to the terminal, nothing else does.
  if (!session.json && files->empty()) {
    PrintNotes(session, info->mesh_notes);
    PrintNotes(session, question.notes);
    return absl::OkStatus();
  }

  const MatrixSummary& summary = destination.summary();
  Report report = {
      .facts = {{"matrix",
                 absl::StrCat(GroupedNumber(summary.shape.rows), " rows x ",
                              GroupedNumber(summary.shape.columns),
                              " columns")},
                {"finite values", GroupedNumber(summary.finite)},
                {"largest distance",
                 summary.finite == 0 ? "none" : ShortNumber(summary.largest)}},
      .json = {{"rows", summary.shape.rows},
               {"columns", summary.shape.columns},
               {"finite_values", summary.finite},
               {"largest_distance",
                summary.finite == 0 ? Json() : Json(summary.largest)}}};
  if (files->empty()) report.json["matrix"] = destination.rows();
  return PrintReport(session, question, *info, seconds, files, report);
}

}  // namespace

Command MatrixCommand() {
  return MakeQuestion(
      "matrix", "Distances between many points",
      "  geodesic matrix horse.ply --source 0 --source 9 --target 5 "
      "--target 7\n"
      "  geodesic matrix horse.ply --sources rows.txt --radius 0.02 "
      "-o near.npz\n"
      "  geodesic matrix horse.ply --sources all.txt --float32 -o d.npy",
      AddOptions, Answer);
}

}  // namespace geodesic::client
