// nearest: the nearest members of a set.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/cli/commands/command.h"
#include "client/cli/commands/outputs.h"
#include "client/cli/commands/question.h"
#include "client/cli/commands/report.h"
#include "client/cli/commands/stopwatch.h"
#include "client/output/number_text.h"
#include "client/output/place_text.h"

namespace geodesic::client {
namespace {

struct NearestArguments : QuestionArguments {
  uint64_t count = 1;
};

void AddOptions(CLI::App* app, NearestArguments* arguments) {
  arguments->may_be_approximate = true;
  arguments->may_have_tolerance = true;
  AddMesh(app, kMeshHelp, &arguments->mesh);
  AddSources(app, Need::kRequired, &arguments->sources);
  AddTargets(app, Need::kRequired, "A member of the set to search",
             &arguments->targets);
  AddValue(app,
           {"-k,--count",
            "How many members to find for each source; default: 1", "K"},
           ParseCount, &arguments->count);
  AddRadius(app, "Find no members farther than this", &arguments->radius);
  AddQuestion(app, "Write what was found here", kTableFormats, arguments);
}

// `name` is that of distances.
Json FoundJson(const Question& question, const NearestAnswer& answer,
               const std::string& name) {
  Json rows = Json::array();
  for (size_t source = 0; source < answer.found.size(); ++source) {
    Json found = Json::array();
    for (const NearestTarget& nearest : answer.found[source]) {
      Json target = PointToJson(question.targets[nearest.target]);
      found.push_back({{"target", nearest.target},
                       {"point", std::move(target)},
                       {name, nearest.distance}});
    }
    rows.push_back({{"source", SourceToJson(question.sources[source])},
                    {"nearest", std::move(found)}});
  }
  return rows;
}

// Calls `visit(source, rank, nearest)` for every target that was found. The
// nearest has rank 1.
template <typename Visit>
void VisitFound(const NearestAnswer& answer, Visit visit) {
  for (size_t source = 0; source < answer.found.size(); ++source) {
    for (size_t rank = 0; rank < answer.found[source].size(); ++rank) {
      visit(source, rank + 1, answer.found[source][rank]);
    }
  }
}

void WriteCsv(const Question& question, const NearestAnswer& answer,
              const std::string& name, AtomicFile* file) {
  file->Append(absl::StrCat("source,rank,target,point,", name, "\n"));
  CsvLine line;
  VisitFound(answer, [&](size_t source, size_t rank, const NearestTarget& t) {
    line.Number(source)
        .Number(rank)
        .Number(t.target)
        .Text(PointText(question.targets[t.target]))
        .Number(t.distance);
    file->Append(line.End());
  });
}

Report ReportOf(const NearestArguments& arguments, const Question& question,
                const NearestAnswer& answer, const std::string& name) {
  const uint64_t count = arguments.count;
  const bool is_limited = arguments.radius.has_value();
  Report report = {.header = {"source", "rank", "target", name}};
  VisitFound(answer, [&](size_t source, size_t rank, const NearestTarget& t) {
    report.rows.push_back(
        {SourceText(question.sources[source]), NumberText(rank),
         PointText(question.targets[t.target]), NumberText(t.distance)});
  });
  report.json["found"] = FoundJson(question, answer, name);
  if (count > question.targets.size()) {
    report.notes.push_back(absl::StrCat(
        GroupedNumber(count), " nearest targets were asked for, and there are ",
        GroupedNumber(question.targets.size())));
  }
  const uint64_t most = std::min<uint64_t>(count, question.targets.size());
  const auto fewer = std::ranges::count_if(
      answer.found, [most](const auto& found) { return found.size() < most; });
  if (fewer != 0) {
    report.notes.push_back(absl::StrCat(
        GroupedNumber(fewer), fewer == 1 ? " source has" : " sources have",
        " fewer than ", GroupedNumber(most), " targets: no path leads to more",
        is_limited ? ", or none within the radius" : ""));
  }
  return report;
}

absl::Status Answer(const NearestArguments& arguments, const Session& session,
                    const Question& question) {
  auto query = MakeQuery<NearestQuery>(arguments, question);
  query.count = arguments.count;
  Stopwatch watch(session);
  absl::StatusOr<NearestAnswer> answer =
      session.client.FindNearest(query, session.call, watch.OnCount("sources"));
  if (!answer.ok()) return answer.status();
  const double seconds = watch.seconds();
  const std::string name = DistanceName("distance", arguments.mark());
  const auto write = [&](const OutputArgument& output, const MeshArrays&) {
    return WriteFile(output.path, [&](AtomicFile* file) {
      if (output.format == OutputFormat::kCsv) {
        WriteCsv(question, *answer, name, file);
      } else {
        file->Append(FoundJson(question, *answer, name).dump(2) + "\n");
      }
    });
  };
  return PrintReport(
      session, question, answer->info, seconds,
      WriteOutputs(session, arguments.outputs, answer->info, {}, write),
      ReportOf(arguments, question, *answer, name));
}

}  // namespace

Command NearestCommand() {
  return MakeQuestion(
      "nearest", "The nearest members of a set",
      "  geodesic nearest horse.ply --source 0 --targets stations.txt -k 3",
      AddOptions, Answer);
}

}  // namespace geodesic::client
