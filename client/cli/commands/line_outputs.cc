#include "client/cli/commands/line_outputs.h"

namespace geodesic::client {

absl::StatusOr<std::vector<WrittenFile>> WriteLineOutputs(
    const Session& session, const std::vector<OutputArgument>& outputs,
    const Lines& lines,
    const std::function<absl::StatusOr<uint64_t>(const std::string& path)>&
        write_picture) {
  return WriteOutputs(
      session, outputs,
      [&](const OutputArgument& output) -> absl::StatusOr<uint64_t> {
        if (output.format == OutputFormat::kPng) {
          return write_picture(output.path);
        }
        return WriteFile(output.path, [&](AtomicFile* file) {
          switch (output.format) {
            case OutputFormat::kObj:
              WriteLinesObj(lines, file);
              break;
            case OutputFormat::kPly:
              WriteLinesPly(lines, file);
              break;
            case OutputFormat::kVtk:
              WriteLinesVtk(lines, file);
              break;
            case OutputFormat::kCsv:
              WriteLinesCsv(lines, file);
              break;
            case OutputFormat::kJson:
              WriteLinesJson(lines, file);
              break;
            default:
              return absl::InternalError("no format for lines");
          }
          return absl::OkStatus();
        });
      });
}

}  // namespace geodesic::client
