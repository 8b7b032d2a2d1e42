// What a command prints about an answer, as text or as JSON.

#ifndef GEODESIC_CLIENT_CLI_COMMANDS_REPORT_H_
#define GEODESIC_CLIENT_CLI_COMMANDS_REPORT_H_

#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "client/cli/commands/command.h"
#include "client/cli/commands/outputs.h"
#include "client/cli/commands/question.h"
#include "client/cli/terminal/text.h"
#include "geodesic_client/answer.h"

namespace geodesic::client {

// What a command prints about an answer.
struct Report {
  // A table; no header means no table.
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::vector<Fact> facts;
  // What the user should know of the answer, beside those of the question.
  std::vector<std::string> notes = {};
  // Members for the object that --json prints.
  Json json = Json::object();
};

// Prints the table, the facts of `report`, those of all answers and the notes,
// or one JSON object. With --quiet it prints only the table and the report's
// own facts, and nothing if the answer went to files; the notes go to standard
// error then. It prints nothing if the files could not
// be written, and to standard error if one of them is standard output.
// Errors: that of `files`.
absl::Status PrintReport(const Session& session, const Question& question,
                         const AnswerInfo& info, double call_seconds,
                         const absl::StatusOr<std::vector<WrittenFile>>& files,
                         const Report& report);

// The parameters that are set, by the names of their options.
Json ParametersJson(const Approximation& approximation);

// The status of a command whose output cannot be written.
absl::Status OutputFailed();

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_COMMANDS_REPORT_H_
