#include "client/cli/commands/report.h"

#include <algorithm>
#include <optional>
#include <variant>

#include "absl/strings/str_cat.h"
#include "client/cli/commands/notes.h"
#include "client/output/atomic_file.h"
#include "client/output/place_text.h"

namespace geodesic::client {
namespace {

Json FilesJson(const std::vector<WrittenFile>& files) {
  Json outputs = Json::array();
  for (const WrittenFile& file : files) {
    outputs.push_back(
        {{"path", file.output.path},
         {"format", std::string(OutputFormatName(file.output.format))},
         {"bytes", file.bytes}});
  }
  return outputs;
}

Json SourcesJson(const Question& question) {
  Json list = Json::array();
  for (const Source& source : question.sources) {
    list.push_back(SourceToJson(source));
  }
  for (const auto& [number, length] : question.curve_lengths) {
    list[number]["length"] = length;
  }
  return list;
}

// What the curves among the sources are in all.
std::optional<Fact> CurveFact(const Question& question) {
  if (question.curve_lengths.empty()) return std::nullopt;
  size_t points = 0;
  double sum = 0;
  for (const auto& [number, length] : question.curve_lengths) {
    points += std::get<Curve>(question.sources[number].place).points.size();
    sum += length;
  }
  const size_t count = question.curve_lengths.size();
  return Fact(
      count == 1 ? "curve" : absl::StrCat(GroupedNumber(count), " curves"),
      absl::StrCat(GroupedNumber(points), " points, length ",
                   ShortNumber(sum)));
}

std::vector<std::string> AllNotes(const Question& question,
                                  const AnswerInfo& info,
                                  const Report& report) {
  std::vector<std::string> notes = question.notes;
  notes.insert(notes.end(), report.notes.begin(), report.notes.end());
  notes.insert(notes.end(), info.mesh_notes.begin(), info.mesh_notes.end());
  return notes;
}

// Null stands for what has no bound, or is not certified.
void AddAnswer(const Question& question, const AnswerInfo& info,
               double call_seconds, const std::vector<WrittenFile>& files,
               const Report& report, Json& json) {
  json = {{"mesh", info.mesh_digest}, {"algorithm", info.algorithm}};
  if (!question.sources.empty()) {
    json["sources"] = SourcesJson(question);
  }
  json["approximate"] = info.approximation.has_value();
  if (info.approximation.has_value()) {
    json["parameters"] = ParametersJson(*info.approximation);
  }
  json["certified_error"] =
      info.certified_error.has_value() ? Json(*info.certified_error) : Json();
  json.update(Json{{"relative_tolerance", info.relative_tolerance},
                   {"windows_propagated", info.windows_propagated},
                   {"compute_seconds", info.compute_seconds},
                   {"call_seconds", call_seconds},
                   {"server_version", info.server_version}});
  json.update(report.json);
  json["notes"] = AllNotes(question, info, report);
  json["outputs"] = FilesJson(files);
}

// Says that distances are not exact, if they are not.
std::optional<Fact> Inexactness(const AnswerInfo& info) {
  if (info.approximation.has_value()) {
    return Fact("distances", "approximate: no bound on their error");
  }
  if (!info.certified_error.has_value()) return std::nullopt;
  return Fact("distances", absl::StrCat("certified within ",
                                        ShortNumber(*info.certified_error),
                                        " (relative error)"));
}

// The facts of all answers, with those of `report` among them.
std::vector<Fact> AllFacts(const Question& question, const AnswerInfo& info,
                           double call_seconds,
                           const std::vector<WrittenFile>& files,
                           const Report& report) {
  std::vector<Fact> facts = {{"mesh", info.mesh_digest},
                             {"algorithm", info.algorithm}};
  if (info.approximation.has_value()) {
    facts.back().second = AlgorithmText(info.algorithm, *info.approximation);
  }
  if (const auto inexact = Inexactness(info)) facts.push_back(*inexact);
  if (const auto curve = CurveFact(question)) facts.push_back(*curve);
  facts.insert(facts.end(), report.facts.begin(), report.facts.end());
  // Rows of a matrix are computed at the same time.
  facts.push_back({"solver", absl::StrCat(Seconds(info.compute_seconds),
                                          info.compute_seconds > call_seconds
                                              ? " over all threads"
                                              : "")});
  facts.push_back({"this call", Seconds(call_seconds)});
  for (const WrittenFile& file : files) {
    facts.push_back({"wrote", absl::StrCat(file.output.path == kStandardOutput
                                               ? "standard output"
                                               : file.output.path,
                                           " (", ByteCount(file.bytes), ")")});
  }
  for (const std::string& note : AllNotes(question, info, report)) {
    facts.emplace_back("note", note);
  }
  return facts;
}

// What is printed with --quiet.
std::vector<Fact> OwnFacts(const AnswerInfo& info, const Report& report) {
  std::vector<Fact> facts = report.facts;
  const auto inexact = Inexactness(info);
  if (inexact.has_value() && !facts.empty()) {
    facts.insert(facts.begin(), *inexact);
  }
  return facts;
}

}  // namespace

Json ParametersJson(const Approximation& approximation) {
  Json parameters = Json::object();
  if (approximation.lambda.has_value()) {
    parameters["lambda"] = *approximation.lambda;
  }
  if (approximation.neighbours.has_value()) {
    parameters["neighbours"] = *approximation.neighbours;
  }
  if (approximation.samples.has_value()) {
    parameters["samples"] = *approximation.samples;
  }
  return parameters;
}

absl::Status PrintReport(const Session& session, const Question& question,
                         const AnswerInfo& info, double call_seconds,
                         const absl::StatusOr<std::vector<WrittenFile>>& files,
                         const Report& report) {
  if (!files.ok()) return files.status();
  if (session.json) {
    AddAnswer(question, info, call_seconds, *files, report, *session.json);
    return absl::OkStatus();
  }
  if (session.quiet) PrintNotes(session, AllNotes(question, info, report));
  if (session.quiet && !files->empty()) return absl::OkStatus();
  // Nothing else goes where an answer went.
  const bool is_taken = std::ranges::any_of(*files, [](const auto& file) {
    return file.output.path == kStandardOutput;
  });
  std::ostream& out = is_taken ? session.err : session.out;
  if (!report.header.empty()) {
    PrintTable(report.header, report.rows, &out);
    if (!session.quiet) out << '\n';
  }
  PrintFacts(session.quiet
                 ? OwnFacts(info, report)
                 : AllFacts(question, info, call_seconds, *files, report),
             &out);
  return absl::OkStatus();
}

absl::Status OutputFailed() {
  return absl::AbortedError("the output cannot be written");
}

}  // namespace geodesic::client
