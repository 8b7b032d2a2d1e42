// nearest: the nearest members of a set.

#include <string>
#include <utility>
#include <vector>

#include "client/cli/commands.h"
#include "client/cli/question.h"
#include "client/output/csv.h"
#include "client/output/number_text.h"
#include "client/output/place_text.h"

namespace geodesic::client {
namespace {

Json FoundJson(const Question& question, const NearestAnswer& answer) {
  Json rows = Json::array();
  for (size_t source = 0; source < answer.found.size(); ++source) {
    Json found = Json::array();
    for (const NearestTarget& nearest : answer.found[source]) {
      Json target = PointToJson(question.targets[nearest.target]);
      found.push_back({{"target", nearest.target},
                       {"point", std::move(target)},
                       {"distance", nearest.distance}});
    }
    rows.push_back({{"source", SourceToJson(question.sources[source])},
                    {"nearest", std::move(found)}});
  }
  return rows;
}

// Calls `visit(source, rank, nearest)` for all that was found; the nearest has
// rank 1.
template <typename Visit>
void VisitFound(const NearestAnswer& answer, Visit visit) {
  for (size_t source = 0; source < answer.found.size(); ++source) {
    for (size_t rank = 0; rank < answer.found[source].size(); ++rank) {
      visit(source, rank + 1, answer.found[source][rank]);
    }
  }
}

void WriteCsv(const Question& question, const NearestAnswer& answer,
              AtomicFile* file) {
  file->Append("source,rank,target,point,distance\n");
  CsvLine line;
  VisitFound(answer, [&](size_t source, size_t rank, const NearestTarget& t) {
    line.Integer(static_cast<int64_t>(source))
        .Integer(static_cast<int64_t>(rank))
        .Integer(static_cast<int64_t>(t.target))
        .Text(PointText(question.targets[t.target]))
        .Number(t.distance);
    file->Append(line.End());
  });
}

void PrintText(const Session& session, const Question& question,
               const NearestAnswer& answer,
               const std::vector<WrittenFile>& files, double seconds) {
  std::vector<std::vector<std::string>> rows;
  VisitFound(answer, [&](size_t source, size_t rank, const NearestTarget& t) {
    rows.push_back({SourceText(question.sources[source]), NumberText(rank),
                    PointText(question.targets[t.target]),
                    NumberText(t.distance)});
  });
  PrintTable({"source", "rank", "target", "distance"}, rows, &session.out);
  std::vector<Fact> facts = {{"mesh", answer.info.mesh_digest},
                             {"algorithm", answer.info.algorithm}};
  AddClosingFacts(answer.info, seconds, files, &facts);
  session.out << '\n';
  PrintFacts(facts, &session.out);
}

}  // namespace

absl::Status RunNearest(const Session& session) {
  absl::StatusOr<Question> question = Prepare(session);
  if (!question.ok()) return question.status();
  Stopwatch watch(session);
  absl::StatusOr<NearestAnswer> answer =
      session.client.FindNearest({.mesh_digest = question->mesh_digest,
                                  .sources = question->sources,
                                  .targets = question->targets,
                                  .count = session.arguments.count.value_or(1),
                                  .algorithm = session.arguments.algorithm,
                                  .max_distance = session.arguments.radius,
                                  .priority = session.arguments.priority},
                                 session.call, watch.OnCount("sources"));
  if (!answer.ok()) return answer.status();
  const double seconds = watch.seconds();
  absl::StatusOr<std::vector<WrittenFile>> files =
      WriteOutputs(session, [&](const OutputArgument& output) {
        return WriteFile(output.path, [&](AtomicFile* file) {
          if (output.format == OutputFormat::kCsv) {
            WriteCsv(*question, *answer, file);
          } else {
            file->Append(FoundJson(*question, *answer).dump(2) + "\n");
          }
          return absl::OkStatus();
        });
      });
  if (!files.ok()) return files.status();
  if (session.arguments.json) {
    Json json = AnswerJson(*question, answer->info, seconds);
    json["found"] = FoundJson(*question, *answer);
    json["outputs"] = ToJson(*files);
    PrintJson(json, &session.out);
  } else {
    PrintText(session, *question, *answer, *files, seconds);
  }
  return absl::OkStatus();
}

}  // namespace geodesic::client
