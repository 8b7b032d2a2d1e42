// upload: makes mesh files resident.

#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/cli/commands/command.h"
#include "client/cli/commands/json.h"
#include "client/cli/commands/mesh_argument.h"
#include "client/cli/commands/mesh_facts.h"

namespace geodesic::client {
namespace {

struct UploadArguments {
  std::vector<std::string> files;
  std::optional<MeshFormat> format;
};

void AddOptions(CLI::App* app, UploadArguments* arguments) {
  AddFiles(app,
           "Meshes in OBJ, PLY, OFF or STL; sent only if the server does not "
           "know them",
           &arguments->files);
  AddFormat(app, &arguments->format);
}

std::string Sent(const UploadOutcome& outcome) {
  if (outcome.bytes_sent == 0) return "nothing sent: already resident";
  return absl::StrCat(ByteCount(outcome.bytes_sent),
                      outcome.already_resident ? ", already resident" : "");
}

void Print(const Session& session, const UploadOutcome& outcome) {
  if (session.quiet) {
    session.out << outcome.mesh.digest << '\n';
    return;
  }
  std::vector<Fact> facts = FactsOf(outcome.mesh);
  facts.push_back({"upload", Sent(outcome)});
  PrintFacts(facts, &session.out);
}

absl::Status Run(const UploadArguments& arguments, const Session& session) {
  Json uploads = Json::array();
  for (const std::string& file : arguments.files) {
    absl::StatusOr<UploadOutcome> outcome =
        UploadMesh(session, {file, arguments.format});
    if (!outcome.ok()) return outcome.status();
    uploads.push_back({{"mesh", ToJson(outcome->mesh)},
                       {"already_resident", outcome->already_resident},
                       {"bytes_sent", outcome->bytes_sent}});
    if (session.json) continue;
    if (uploads.size() > 1 && !session.quiet) session.out << '\n';
    Print(session, *outcome);
  }
  if (session.json) {
    PrintJson(uploads.size() == 1 ? uploads[0] : Json{{"uploads", uploads}},
              &session.out);
  }
  return absl::OkStatus();
}

}  // namespace

Command UploadCommand() {
  return MakeCommand("upload", "Make mesh files resident on the server",
                     "  geodesic upload horse.ply\n"
                     "  geodesic upload --quiet left.ply right.ply",
                     AddOptions, Run);
}

}  // namespace geodesic::client
