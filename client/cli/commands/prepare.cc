// prepare: makes what questions with an algorithm need before they are asked.

#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "client/cli/commands/command.h"
#include "client/cli/commands/mesh_argument.h"
#include "client/cli/commands/report.h"
#include "client/cli/commands/stopwatch.h"

namespace geodesic::client {
namespace {

// What is prepared for exact distances of pairs.
constexpr char kLandmarks[] = "landmarks";

struct PrepareArguments {
  MeshArgument mesh;
  std::string algorithm;
  Approximation approximation;
  Priority priority = Priority::kInteractive;
};

void AddOptions(CLI::App* app, PrepareArguments* arguments) {
  AddMesh(app, kMeshHelp, &arguments->mesh);
  std::vector<std::string> names = ApproximateAlgorithmNames();
  names.emplace_back(kLandmarks);
  AddAlgorithm(app,
               "What to prepare: an approximate algorithm, or the landmarks of "
               "exact distances between two places; default: landmarks",
               names, &arguments->algorithm);
  AddApproximation(app, &arguments->approximation);
  AddPriority(app, &arguments->priority);
}

absl::Status Run(const PrepareArguments& arguments, const Session& session) {
  const bool is_method = IsApproximate(arguments.algorithm);
  return AskAboutMesh(session, arguments.mesh, [&](const std::string& digest) {
    Stopwatch watch(session);
    const absl::StatusOr<Preparation> made = session.client.Prepare(
        {.mesh_digest = digest,
         .algorithm = is_method ? arguments.algorithm : "",
         .approximation = arguments.approximation,
         .priority = arguments.priority},
        session.call, watch.OnPrepare("preparing"));
    if (!made.ok()) return made.status();
    const std::string name = is_method ? arguments.algorithm : kLandmarks;
    const Approximation parameters =
        made->info.approximation.value_or(Approximation());
    if (session.json) {
      *session.json = {{"mesh", digest},
                       {"prepared", name},
                       {"approximate", is_method},
                       {"parameters", ParametersJson(parameters)},
                       {"already_prepared", made->already_prepared},
                       {"bytes", made->bytes},
                       {"prepare_seconds", made->prepare_seconds},
                       {"call_seconds", watch.seconds()}};
    } else if (!session.quiet) {
      PrintFacts({{"mesh", digest},
                  {"prepared", absl::StrCat(AlgorithmText(name, parameters),
                                            made->already_prepared
                                                ? " (it was there already)"
                                                : "")},
                  {"memory", ByteCount(made->bytes)},
                  {"time", Seconds(made->prepare_seconds)},
                  {"this call", Seconds(watch.seconds())}},
                 &session.out);
    }
    return absl::OkStatus();
  });
}

}  // namespace

Command PrepareCommand() {
  return MakeCommand<PrepareArguments>(
      "prepare", "Make what algorithms need, ahead of questions",
      "  geodesic prepare horse.ply --algorithm svg --neighbours 50\n"
      "  geodesic prepare horse.ply --algorithm landmarks",
      AddOptions, Run);
}

}  // namespace geodesic::client
