// distance: from one place to another, for one pair or a list of any length.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "absl/strings/cord.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_replace.h"
#include "client/cli/arguments/pair_list.h"
#include "client/cli/commands/command.h"
#include "client/cli/commands/mesh_argument.h"
#include "client/cli/commands/notes.h"
#include "client/cli/commands/outputs.h"
#include "client/cli/commands/question.h"
#include "client/cli/commands/report.h"
#include "client/cli/commands/stopwatch.h"
#include "client/cli/terminal/exit_code.h"
#include "client/output/line_writers.h"
#include "client/output/matrix_writers.h"
#include "client/output/number_text.h"
#include "client/output/pair_writers.h"
#include "client/output/place_text.h"
#include "client/places/place_finder.h"
#include "geodesic_client/errors.h"

namespace geodesic::client {
namespace {

// How many pairs of a list are in memory.
constexpr size_t kPairsAtOnce = 65'536;

struct DistanceArguments {
  MeshArgument mesh;
  // The places A and B as they are written; empty with `list`.
  std::string source;
  std::string target;
  std::optional<WrittenPair> pair;
  std::string list;
  bool float32 = false;
  std::string algorithm;
  Approximation approximation;
  double tolerance = 0;
  Priority priority = Priority::kInteractive;
  std::vector<OutputArgument> outputs;
  std::vector<std::string> other_inputs;  // OtherInputs

  std::string mark() const {
    return tolerance == 0 ? ApproximationMark(algorithm, approximation)
                          : ToleranceMark(tolerance);
  }
};

// Files of other formats hold paths.
bool HoldsDistances(OutputFormat format) {
  return format == OutputFormat::kNpy || format == OutputFormat::kCsv;
}

WrittenPoint PlaceOf(const std::string& name, const std::string& text) {
  absl::StatusOr<WrittenPoint> place = ParsePoint(text);
  if (!place.ok()) Refuse(name, std::string(place.status().message()));
  return *place;
}

void CheckArguments(DistanceArguments* arguments) {
  CheckTolerance(arguments->tolerance, arguments->algorithm);
  const bool has_list = !arguments->list.empty();
  if (has_list != arguments->source.empty()) {
    Refuse("A B", "name two places, or --pairs FILE, not both");
  }
  if (has_list) return;
  if (arguments->target.empty()) Refuse("B", "name the second place");
  arguments->pair = WrittenPair{PlaceOf("A", arguments->source),
                                PlaceOf("B", arguments->target)};
}

void AddOptions(CLI::App* app, DistanceArguments* arguments) {
  AddMesh(app, kMeshHelp, &arguments->mesh);
  app->add_option("A", arguments->source,
                  absl::StrCat("The place to measure from: ", kPointHelp))
      ->type_name("");
  app->add_option("B", arguments->target, "The place to measure to")
      ->type_name("");
  app->add_option("--pairs", arguments->list,
                  "Read pairs from a file, two places a line with blanks, tabs "
                  "or a comma between them, or from standard input (-)")
      ->type_name("FILE");
  AddFloat32(app, &arguments->float32);
  AddAlgorithm(
      app,
      "Find distances between vertices by an approximate algorithm: no "
      "bound on its error is known. svg searches its graph, gtu looks "
      "them up, others compute fields. Default: exact distances",
      ApproximateAlgorithmNames(), &arguments->algorithm);
  AddApproximation(app, &arguments->approximation);
  AddTolerance(app, &arguments->tolerance);
  AddPriority(app, &arguments->priority);
  AddOutputs(app,
             "Write the distances here as they come (.npy, .csv), or the "
             "shortest paths, which are kept in memory until the end",
             kPairFormats, &arguments->outputs);
  app->callback([app, arguments] {
    CheckArguments(arguments);
    CheckOutputs(*app, arguments->outputs);
    arguments->other_inputs = OtherInputs(*app);
  });
}

// Takes the distances: files, the terminal, or one JSON object.
class Destination {
 public:
  Destination(const DistanceArguments& arguments, const Session& session)
      : arguments_(arguments), session_(session) {}

  // Errors: those of opening files.
  absl::Status Open() {
    for (const OutputArgument& output : arguments_.outputs) {
      if (!HoldsDistances(output.format)) continue;
      absl::StatusOr<PairWriter> writer = PairWriter::Create(
          output.path, output.format, type(), arguments_.mark());
      if (!writer.ok()) return FileError(writer.status());
      writers_.push_back(*std::move(writer));
    }
    if (is_text()) session_.out << MatrixCsvHeader(arguments_.mark());
    return absl::OkStatus();
  }

  absl::Status Append(std::span<const PointPair> pairs,
                      std::span<const double> distances) {
    count_ += distances.size();
    for (size_t i = 0; i < distances.size(); ++i) {
      if (std::isfinite(distances[i])) {
        ++finite_;
        largest_ = std::max(largest_, distances[i]);
      } else if (!unreached_.has_value()) {
        unreached_ = pairs[i];
      }
    }
    if (arguments_.pair.has_value()) pair_ = pairs[0];
    if (keeps()) kept_.insert(kept_.end(), distances.begin(), distances.end());
    // Whoever reads may wait for them before asking more.
    if (is_text())
      session_.out << CsvPairs(pairs, distances, type()) << std::flush;
    if (!session_.out) return OutputFailed();
    for (PairWriter& writer : writers_) {
      absl::Status status = writer.Append(pairs, distances);
      if (!status.ok()) return FileError(status);
    }
    return absl::OkStatus();
  }

  // REQUIRES: has_paths().
  void Append(double distance, Polyline path) {
    lines_.lines.push_back(
        {.polyline = std::move(path),
         .values = {static_cast<double>(count_ - 1), distance}});
  }

  // Without any path no file of paths appears.
  absl::StatusOr<std::vector<WrittenFile>> Commit() {
    std::vector<OutputArgument> outputs = arguments_.outputs;
    if (LacksPaths()) {
      std::erase_if(outputs, [](const OutputArgument& output) {
        return !HoldsDistances(output.format);
      });
    }
    size_t next = 0;
    const auto write = [&](const OutputArgument& output,
                           const MeshArrays&) -> absl::StatusOr<uint64_t> {
      if (!HoldsDistances(output.format)) {
        return WriteFile(output.path, [&](AtomicFile* file) {
          WriteLines(lines_, output.format, file);
        });
      }
      absl::StatusOr<uint64_t> size = writers_[next++].Commit();
      if (!size.ok()) return FileError(size.status());
      return size;
    };
    return WriteOutputs(session_, outputs, /*info=*/{},
                        /*with_mesh=*/{}, write);
  }

  Report ReportOf(const PairSummary& summary) const {
    Report report = {
        .facts = {{"pairs", GroupedNumber(count_)},
                  {"finite distances", GroupedNumber(finite_)},
                  {"largest distance",
                   finite_ == 0 ? "none" : ShortNumber(largest_)},
                  {"found by",
                   absl::StrCat(GroupedNumber(summary.searched), " searches; ",
                                GroupedNumber(summary.from_fields),
                                " pairs from fields, ",
                                GroupedNumber(summary.from_cache),
                                " from the cache")}},
        .json = {{"pairs", count_},
                 {"finite_distances", finite_},
                 {"largest_distance", finite_ == 0 ? Json() : Json(largest_)},
                 {"pairs_searched", summary.searched},
                 {"pairs_from_fields", summary.from_fields},
                 {"pairs_from_cache", summary.from_cache}}};
    const std::string name = DistanceName("distance", arguments_.mark());
    if (arguments_.pair.has_value()) {
      report.facts.clear();
      report.header = {"source", "target", name};
      report.rows = {{PointText(pair_.source), PointText(pair_.target),
                      TextOf(kept_[0], type())}};
      report.json["source"] = PointToJson(pair_.source);
      report.json["target"] = PointToJson(pair_.target);
      report.json[name] = kept_[0];
      report.json["unreached"] = nullptr;
      if (unreached_.has_value()) {
        const std::string reason = WhyUnreached(summary);
        report.json["unreached"] = reason;
        report.notes.push_back(absl::StrCat(
            "no path leads to ", PointText(pair_.target), ": ", reason));
      }
      return report;
    }
    if (keeps()) report.json[name + "s"] = kept_;
    if (unreached_.has_value()) {
      report.notes.push_back(absl::StrCat(
          "no path joins ", GroupedNumber(count_ - finite_),
          " of the pairs, the first of them ", PointText(unreached_->source),
          " and ", PointText(unreached_->target), ": ", WhyUnreached(summary)));
    }
    return report;
  }

  // Whether paths were asked for, and none was found.
  bool LacksPaths() const {
    return has_paths() &&
           std::ranges::all_of(lines_.lines, [](const Line& line) {
             return line.polyline.points.empty();
           });
  }

  bool has_unreached() const { return unreached_.has_value(); }

  uint64_t count() const { return count_; }
  bool has_paths() const { return writers_.size() < arguments_.outputs.size(); }
  // Whether lines go to the terminal as they come; nothing else does then.
  bool is_text() const {
    return arguments_.outputs.empty() && !session_.json &&
           !arguments_.pair.has_value();
  }

 private:
  // REQUIRES: unreached_.
  std::string WhyUnreached(const PairSummary& summary) const {
    const Source source = {unreached_->source};
    constexpr double kUnreached = std::numeric_limits<double>::infinity();
    return client::WhyUnreached(session_, summary.info.mesh_digest,
                                {&source, 1}, {&unreached_->target, 1},
                                {&kUnreached, 1},
                                BeyondRadius(std::nullopt))[0];
  }

  NumberType type() const { return NumberTypeOf(arguments_.float32); }
  // Whether the distances are kept for the report.
  bool keeps() const {
    return arguments_.pair.has_value() ||
           (session_.json && arguments_.outputs.empty());
  }

  const DistanceArguments& arguments_;
  const Session& session_;
  std::vector<PairWriter> writers_;
  PointPair pair_;                      // the only one, if it is not a list
  std::optional<PointPair> unreached_;  // the first without a path
  std::vector<double> kept_;
  Lines lines_ = {
      .attributes = {{"pair", NumberType::kInt32}, {"distance", type()}}};
  uint64_t count_ = 0;
  uint64_t finite_ = 0;
  double largest_ = 0;
};

// Asks piece by piece.
class PairRun {
 public:
  PairRun(const DistanceArguments& arguments, const Session& session,
          std::optional<PairList> list, Destination* destination)
      : arguments_(arguments),
        session_(session),
        list_(std::move(list)),
        destination_(destination),
        watch_(session) {
    if (arguments.pair.has_value()) piece_.pairs = {*arguments.pair};
  }

  // Goes on after the last distance that came, on the mesh with this digest.
  absl::Status GoOn(const std::string& digest) {
    PlaceFinder finder(
        [&] { return session_.client.ReadMesh(digest, session_.call); });
    for (;;) {
      if (pairs_.empty() && piece_.pairs.empty()) {
        if (absl::Status status = ReadPiece(); !status.ok()) return status;
        if (piece_.pairs.empty()) return absl::OkStatus();
      }
      if (absl::Status status = FindPlaces(&finder); !status.ok()) {
        return status;
      }
      if (absl::Status status = AskForPiece(digest); !status.ok()) {
        return status;
      }
    }
  }

  const PairSummary& summary() const { return summary_; }
  double seconds() const { return watch_.seconds(); }

 private:
  // Leaves the piece empty at the end of the list.
  absl::Status ReadPiece() {
    if (!list_.has_value()) return absl::OkStatus();
    absl::StatusOr<PairList::Piece> next = list_->Read(kPairsAtOnce);
    if (!next.ok()) return FileError(next.status());
    piece_ = *std::move(next);
    if (!piece_.pairs.empty() || destination_->count() > 0) {
      return absl::OkStatus();
    }
    return FileError(absl::InvalidArgumentError(absl::StrCat(
        ListName(list_->path()), " lists nothing: write two places a line")));
  }

  // Moves the pairs of the piece to those that can be asked for.
  absl::Status FindPlaces(PlaceFinder* finder) {
    if (piece_.pairs.empty()) return absl::OkStatus();
    std::vector<PointPair> found;
    for (const WrittenPair& written : piece_.pairs) {
      absl::StatusOr<PointPair> pair = finder->Find(written);
      if (!pair.ok()) return pair.status();
      found.push_back(*pair);
    }
    pairs_ = std::move(found);
    piece_.pairs.clear();
    return absl::OkStatus();
  }

  absl::Status AskForPiece(const std::string& digest) {
    // The rest of a piece that was broken off.
    const uint64_t before = destination_->count();
    const uint64_t total = before + pairs_.size();
    const PairQuery query = {.mesh_digest = digest,
                             .pairs = std::exchange(pairs_, {}),
                             .value_type = ValueTypeOf(arguments_.float32),
                             .priority = arguments_.priority,
                             .paths = destination_->has_paths(),
                             .algorithm = arguments_.algorithm,
                             .approximation = arguments_.approximation,
                             .tolerance = arguments_.tolerance};
    const std::span<const PointPair> pairs = query.pairs;
    uint64_t taken = 0;
    // The latest distances, up to that of pair `come` less one.
    std::vector<double> without_path;
    uint64_t come = 0;
    const auto progress = watch_.OnCount("pairs");
    const PairReceiver receiver = {
        .on_distances =
            [&](uint64_t first, std::span<const double> distances) {
              if (query.paths) {
                come = first + distances.size();
                without_path.assign(distances.begin(), distances.end());
                return absl::OkStatus();
              }
              taken = first + distances.size();
              return destination_->Append(
                  pairs.subspan(first, distances.size()), distances);
            },
        .on_path =
            [&](uint64_t pair, Polyline path) {
              const double distance =
                  without_path[without_path.size() - (come - pair)];
              taken = pair + 1;
              absl::Status status =
                  destination_->Append(pairs.subspan(pair, 1), {&distance, 1});
              destination_->Append(distance, std::move(path));
              return status;
            },
        // More pairs may follow than were read.
        .on_progress = [&](uint64_t finished,
                           uint64_t) { progress(before + finished, total); }};
    absl::StatusOr<PairSummary> found =
        session_.client.ComputePairs(query, receiver, session_.call);
    if (!found.ok()) {
      absl::Status status = AtLine(found.status(), before);
      pairs_.assign(pairs.begin() + static_cast<std::ptrdiff_t>(taken),
                    pairs.end());
      if (!piece_.lines.empty()) {
        piece_.lines.erase(
            piece_.lines.begin(),
            piece_.lines.begin() + static_cast<std::ptrdiff_t>(taken));
      }
      return status;
    }
    summary_.Add(*found);
    return absl::OkStatus();
  }

  // Names the line of the pair that the server points at, and numbers the pair
  // in the list. `before` pairs came before those that were sent.
  absl::Status AtLine(const absl::Status& status, uint64_t before) const {
    const std::string field = ErrorField(status);
    const std::string name = field.substr(0, field.find(']') + 1);
    uint64_t number = 0;
    if (!list_.has_value() || !name.starts_with("pairs[") ||
        !absl::SimpleAtoi(name.substr(6, name.size() - 7), &number) ||
        number >= piece_.lines.size()) {
      return status;
    }
    absl::Status result(
        status.code(),
        absl::StrCat(
            ListName(list_->path()), " line ", piece_.lines[number], ": ",
            absl::StrReplaceAll(
                std::string(status.message()),
                {{name, absl::StrCat("pairs[", before + number, "]")}})));
    status.ForEachPayload(
        [&](absl::string_view type, const absl::Cord& payload) {
          result.SetPayload(type, payload);
        });
    return result;
  }

  const DistanceArguments& arguments_;
  const Session& session_;
  std::optional<PairList> list_;
  Destination* destination_;
  Stopwatch watch_;
  PairList::Piece piece_;         // its pairs are to be found on the mesh
  std::vector<PointPair> pairs_;  // found, not answered yet
  PairSummary summary_;
};

absl::Status Run(const DistanceArguments& arguments, const Session& session) {
  std::vector<std::string> inputs = arguments.other_inputs;
  inputs.push_back(arguments.mesh.text);
  inputs.push_back(arguments.list);
  for (const OutputArgument& output : arguments.outputs) {
    absl::Status status = CheckWritable(output.path, inputs);
    if (!status.ok()) return FileError(status);
  }
  std::optional<PairList> list;
  if (!arguments.list.empty()) {
    absl::StatusOr<PairList> opened = PairList::Open(arguments.list);
    if (!opened.ok()) return FileError(opened.status());
    list = *std::move(opened);
  }
  Destination destination(arguments, session);
  absl::Status status = destination.Open();
  if (!status.ok()) return status;
  PairRun run(arguments, session, std::move(list), &destination);
  status = AskAboutMesh(
      session, arguments.mesh,
      [&run](const std::string& digest) { return run.GoOn(digest); });
  if (!status.ok()) return status;
  const double seconds = run.seconds();
  absl::StatusOr<std::vector<WrittenFile>> files = destination.Commit();
  if (!files.ok()) return files.status();
  if (destination.is_text()) {
    PrintNotes(session, destination.ReportOf(run.summary()).notes);
    PrintNotes(session, run.summary().info.mesh_notes);
    return absl::OkStatus();
  }
  status = PrintReport(session, {}, run.summary().info, seconds, files,
                       destination.ReportOf(run.summary()));
  if (!status.ok()) return status;
  if (destination.LacksPaths()) {
    return NoPath("no path leads from source to target, so there is no file");
  }
  if (destination.has_paths() && destination.has_unreached()) {
    return NoPath("the file has no path for some of the pairs");
  }
  return status;
}

}  // namespace

Command DistanceCommand() {
  return MakeCommand<DistanceArguments>(
      "distance", "Distances from one place to another",
      "  geodesic distance horse.ply 0 99\n"
      "  geodesic distance horse.ply min:x nearest:0.1,-0.2,0\n"
      "  geodesic distance horse.ply 0 99 --tolerance 0.01\n"
      "  geodesic distance horse.ply 0 face:5@0.2,0.3,0.5 -o path.obj\n"
      "  geodesic distance horse.ply --pairs pairs.txt -o d.npy",
      AddOptions, Run);
}

}  // namespace geodesic::client
