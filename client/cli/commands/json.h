// What --json prints.

#ifndef GEODESIC_CLIENT_CLI_COMMANDS_JSON_H_
#define GEODESIC_CLIENT_CLI_COMMANDS_JSON_H_

#include <nlohmann/json.hpp>
#include <ostream>

#include "absl/status/status.h"
#include "client/cli/terminal/exit_code.h"
#include "geodesic_client/field.h"
#include "geodesic_client/mesh.h"

namespace geodesic::client {

// Keys keep their order, so that people can read it too.
using Json = nlohmann::ordered_json;

Json ToJson(const MeshInfo& mesh);
Json ToJson(const FieldStatistics& statistics);

// Prints one object.
void PrintJson(const Json& json, std::ostream* out);

// {"error": {"code": "NOT_FOUND", "message": ..., "exit_code": 5}}.
Json ErrorToJson(const absl::Status& status, ExitCode exit_code);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_COMMANDS_JSON_H_
