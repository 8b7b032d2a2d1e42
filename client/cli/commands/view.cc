// view: shows a mesh on the server's page, in the browser.

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <unistd.h>

#include <optional>
#include <string>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "client/cli/arguments/options.h"
#include "client/cli/commands/command.h"
#include "client/cli/commands/mesh_argument.h"

extern char** environ;

namespace geodesic::client {
namespace {

struct ViewArguments {
  MeshArgument mesh;
  std::string page;
  bool no_browser = false;
};

absl::StatusOr<std::string> ParsePage(const std::string& text) {
  if (absl::StartsWith(text, "http://") || absl::StartsWith(text, "https://")) {
    return text;
  }
  return absl::InvalidArgumentError(
      absl::StrCat("\"", text, "\" is not http://HOST:PORT or https://"));
}

void AddViewOptions(CLI::App* app, ViewArguments* arguments) {
  AddMesh(app, kMeshHelp, &arguments->mesh);
  AddValue(app,
           {.name = "--page",
            .help = "Where the server that --server names has its page "
                    "(geodesicd --web)",
            .type = "URL"},
           ParsePage, &arguments->page);
  AddFlag(app,
          {.name = "--no-browser",
           .help = "Print the address, and leave it to you to open it"},
          &arguments->no_browser);
}

// Whether the desktop was asked to open it; there may be no desktop.
bool Open(const std::string& what) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY,
                                   0);
  for (const int output : {STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&files, output, "/dev/null", O_WRONLY, 0);
  }
  // The browser, if it is not running yet, outlives the command and its Ctrl-C.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes,
                           POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGMASK);
  sigset_t signals;
  sigemptyset(&signals);
  posix_spawnattr_setsigmask(&attributes, &signals);
  std::string program = "xdg-open";
  std::string argument = what;
  char* const words[] = {program.data(), argument.data(), nullptr};
  pid_t process = -1;
  const int error = posix_spawnp(&process, program.c_str(), &files, &attributes,
                                 words, environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return error == 0;
}

absl::Status RunView(const ViewArguments& arguments, const Session& session) {
  const std::optional<std::string> own =
      session.page ? session.page->Url() : std::nullopt;
  if (!own && arguments.page.empty()) {
    return absl::InvalidArgumentError(
        "say with --page where the server that is named has its page "
        "(geodesicd --web), or name none: geodesic then starts its own");
  }
  const std::string page = arguments.page.empty() ? *own : arguments.page;
  const auto show = [&](const std::string& digest) {
    const absl::StatusOr<MeshInfo> mesh =
        session.client.GetMesh(digest, session.call);
    if (!mesh.ok()) return mesh.status();
    const std::string url = absl::StrCat(
        page, absl::StrContains(page, '#') ? "&" : "#", "mesh=", mesh->digest);
    if (session.json) {
      *session.json = {{"url", url}, {"mesh", mesh->digest}};
    } else {
      session.out << url << std::endl;
    }
    if (arguments.no_browser) return absl::OkStatus();
    // A token must not be seen among the arguments of a program.
    absl::StatusOr<std::string> target = url;
    if (arguments.page.empty()) target = session.page->WriteLink(url);
    if (!target.ok()) return target.status();
    if (!Open(*target) && !session.quiet) {
      session.err << "geodesic: there is no xdg-open: open the address in a "
                     "browser of this machine\n";
    }
    return absl::OkStatus();
  };
  return AskAboutMesh(session, arguments.mesh, show);
}

}  // namespace

Command ViewCommand() {
  Command command = MakeCommand<ViewArguments>(
      "view", "Show a mesh in the browser",
      "  geodesic view horse.ply\n"
      "  geodesic view horse.ply --server meshes.example:50051 \\\n"
      "    --page https://meshes.example",
      AddViewOptions, RunView);
  command.needs_page = true;
  return command;
}

}  // namespace geodesic::client
