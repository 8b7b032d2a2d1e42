// Lines on the surface into the files the command line names.

#ifndef GEODESIC_CLIENT_CLI_COMMANDS_LINE_OUTPUTS_H_
#define GEODESIC_CLIENT_CLI_COMMANDS_LINE_OUTPUTS_H_

#include <functional>
#include <vector>

#include "absl/status/statusor.h"
#include "client/cli/commands/question.h"
#include "client/output/line_writers.h"

namespace geodesic::client {

// `write_picture` draws the .png, which is all that differs between commands.
absl::StatusOr<std::vector<WrittenFile>> WriteLineOutputs(
    const Session& session, const std::vector<OutputArgument>& outputs,
    const Lines& lines,
    const std::function<absl::StatusOr<uint64_t>(const std::string& path)>&
        write_picture);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_COMMANDS_LINE_OUTPUTS_H_
