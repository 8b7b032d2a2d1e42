#include "client/cli/commands/field_rows.h"

#include <cerrno>
#include <fstream>
#include <list>
#include <stop_token>
#include <string>

#include "absl/strings/str_cat.h"
#include "client/output/columns.h"
#include "client/output/csv.h"

namespace geodesic::client {
namespace {

// The files of the outputs, or the terminal.
class Rows {
 public:
  Rows(const Session& session, const std::vector<OutputArgument>& outputs)
      : outputs_(outputs) {
    for (const OutputArgument& output : outputs) {
      places_.push_back(&files_.emplace_back(output.path));
    }
    if (outputs.empty()) places_.push_back(&session.out);
  }

  void Write(const std::string& text) {
    for (std::ostream* place : places_) *place << text;
  }

  // Whether all is written so far.
  bool Flush() {
    bool good = true;
    for (std::ostream* place : places_) good &= !place->flush().fail();
    if (!good && error_ == 0) error_ = errno;
    return good;
  }

  absl::Status Close(std::vector<WrittenFile>* written) {
    if (!Flush()) {
      return outputs_.empty() ? OutputFailed()
                              : FileError(absl::ErrnoToStatus(
                                    error_, absl::StrCat("cannot write ",
                                                         outputs_[0].path)));
    }
    auto file = files_.begin();
    for (const OutputArgument& output : outputs_) {
      written->push_back({output, static_cast<uint64_t>((file++)->tellp())});
    }
    return absl::OkStatus();
  }

 private:
  const std::vector<OutputArgument>& outputs_;
  std::list<std::ofstream> files_;
  std::vector<std::ostream*> places_;
  int error_ = 0;
};

}  // namespace

absl::StatusOr<Field> StreamRows(const Session& session,
                                 const FieldQuery& query,
                                 const std::vector<OutputArgument>& outputs,
                                 Stopwatch* watch, FieldExtremes* extremes,
                                 std::vector<WrittenFile>* written) {
  // A stop asked for by the user, or because nothing more can be written.
  std::stop_source stop;
  const std::stop_callback pass_on(session.call.stop,
                                   [&stop] { stop.request_stop(); });
  CallOptions call = session.call;
  call.stop = stop.get_token();

  Rows rows(session, outputs);
  rows.Write(absl::StrCat("vertex,", kDistanceColumn, "\n"));
  if (!rows.Flush()) stop.request_stop();
  CsvLine line;
  const auto on_settled = [&](std::span<const SettledVertex> settled) {
    for (const SettledVertex& vertex : settled) {
      extremes->Add(vertex.vertex, vertex.distance);
      line.Integer(vertex.vertex).Number(vertex.distance);
      rows.Write(line.End());
    }
    if (!rows.Flush()) stop.request_stop();
  };
  absl::StatusOr<Field> field =
      session.client.StreamField(query, on_settled, call, watch->OnSolve());
  if (absl::Status status = rows.Close(written); !status.ok()) return status;
  return field;
}

}  // namespace geodesic::client
