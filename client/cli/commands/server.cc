// server: the geodesicd that geodesic started by itself.

#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/time/time.h"
#include "client/cli/arguments/options.h"
#include "client/cli/commands/command.h"
#include "client/cli/own_server/own_server.h"
#include "client/cli/terminal/exit_code.h"
#include "client/cli/terminal/text.h"

namespace geodesic::client {
namespace {

enum class Action { kStatus, kStop };

struct ServerArguments {
  Action action = Action::kStatus;
};

absl::StatusOr<Action> ParseAction(const std::string& text) {
  if (text == "status") return Action::kStatus;
  if (text == "stop") return Action::kStop;
  return absl::InvalidArgumentError(
      absl::StrCat("\"", text, "\" is not status or stop"));
}

void AddServerOptions(CLI::App* app, ServerArguments* arguments) {
  AddValue(app,
           {.name = "ACTION",
            .help = "About the server that geodesic started by itself, "
                    "whatever --server says: status tells where it listens, "
                    "since when, what it holds; stop ends it in order",
            .type = "",
            .required = true},
           ParseAction, &arguments->action);
}

// Bytes of memory that the process has in use; 0 if that cannot be read.
uint64_t MemoryInUse(pid_t process) {
  std::ifstream file(absl::StrCat("/proc/", process, "/statm"));
  uint64_t size = 0, resident = 0;
  file >> size >> resident;
  return file ? resident * static_cast<uint64_t>(sysconf(_SC_PAGESIZE)) : 0;
}

// When the socket was made, which is when its server began to serve.
absl::Time MadeAt(const std::string& path) {
  struct stat file = {};
  return stat(path.c_str(), &file) == 0 ? absl::TimeFromTimespec(file.st_mtim)
                                        : absl::InfinitePast();
}

absl::Status ShowStatus(const OwnServer& server, const Session& session) {
  if (session.json) {
    *session.json = {{"running", false}, {"address", server.address()}};
  }
  const std::optional<pid_t> process = server.Running();
  if (!process) {
    return NoneRuns(absl::StrCat("no server of this version runs at ",
                                 server.address(),
                                 "; a command without --server starts one"));
  }
  const absl::StatusOr<Capabilities> capabilities =
      session.client.GetCapabilities(session.call);
  if (!capabilities.ok()) return capabilities.status();
  const absl::StatusOr<std::vector<MeshInfo>> meshes =
      session.client.ListMeshes(session.call);
  if (!meshes.ok()) return meshes.status();
  const std::string since = absl::FormatTime(
      absl::RFC3339_sec, MadeAt(server.socket_path()), absl::LocalTimeZone());
  const uint64_t memory = MemoryInUse(*process);
  if (session.json) {
    *session.json = {
        {"running", true},        {"address", server.address()},
        {"pid", *process},        {"version", capabilities->version},
        {"since", since},         {"meshes", meshes->size()},
        {"memory_bytes", memory}, {"log", server.log_path()}};
    return absl::OkStatus();
  }
  PrintFacts({{"address", server.address()},
              {"process", absl::StrCat(*process)},
              {"version", capabilities->version},
              {"since", since},
              {"meshes", GroupedNumber(meshes->size())},
              {"memory", ByteCount(memory)},
              {"log", server.log_path()}},
             &session.out);
  return absl::OkStatus();
}

absl::Status StopServer(const OwnServer& server, const Session& session) {
  const absl::StatusOr<bool> stopped = server.Stop(session.call);
  if (!stopped.ok()) return stopped.status();
  if (session.json) {
    *session.json = {{"stopped", *stopped}, {"address", server.address()}};
  } else if (!session.quiet) {
    session.out << (*stopped ? "stopped the server at "
                             : "no server of this version runs at ")
                << server.address() << '\n';
  }
  return absl::OkStatus();
}

absl::Status RunServerCommand(const ServerArguments& arguments,
                              const Session& session) {
  const absl::StatusOr<OwnServer> server = OwnServer::Open();
  if (!server.ok()) return server.status();
  return arguments.action == Action::kStatus ? ShowStatus(*server, session)
                                             : StopServer(*server, session);
}

}  // namespace

Command ServerCommand() {
  Command command = MakeCommand<ServerArguments>(
      "server", "Show or stop the server it started",
      "  geodesic server status\n"
      "  geodesic server stop",
      AddServerOptions, RunServerCommand);
  command.is_about_own_server = true;
  return command;
}

}  // namespace geodesic::client
