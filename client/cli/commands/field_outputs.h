// A distance field into the files the command line names, whole or row by row.

#ifndef GEODESIC_CLIENT_CLI_COMMANDS_FIELD_OUTPUTS_H_
#define GEODESIC_CLIENT_CLI_COMMANDS_FIELD_OUTPUTS_H_

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "absl/status/statusor.h"
#include "client/cli/commands/question.h"
#include "geodesic_client/field.h"

namespace geodesic::client {

struct FieldArguments : QuestionArguments {
  std::optional<uint64_t> stop_at_targets;
  bool nearest_sources = false;
  bool gradients = false;
  bool progressive = false;
};

absl::StatusOr<std::vector<WrittenFile>> WriteFieldOutputs(
    const Session& session, const FieldArguments& arguments,
    const Question& question, const Field& field);

// What distances have in common.
struct FieldExtremes {
  // 0 if no vertex is reached.
  double largest = 0;
  uint64_t farthest_vertex = 0;
  uint64_t reached = 0;

  void Add(uint64_t vertex, double distance) {
    if (!std::isfinite(distance)) return;
    if (reached++ == 0 || distance > largest) {
      largest = distance;
      farthest_vertex = vertex;
    }
  }
};

// Writes lines "vertex,distance" to the outputs, or to the terminal if there
// are none, as they come. What has come is there even if the command is
// interrupted. Ends the call when nothing more can be written.
absl::StatusOr<Field> StreamRows(const Session& session,
                                 const FieldQuery& query,
                                 const std::vector<OutputArgument>& outputs,
                                 Stopwatch* watch, FieldExtremes* extremes,
                                 std::vector<WrittenFile>* written);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_COMMANDS_FIELD_OUTPUTS_H_
