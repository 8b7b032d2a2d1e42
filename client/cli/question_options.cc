#include "client/cli/question_options.h"

#include <algorithm>

#include "client/cli/options.h"
#include "client/cli/surface_text.h"

namespace geodesic::client {
namespace {

void AddField(CLI::App* command, Arguments* arguments) {
  AddMesh(command, arguments);
  AddSources(command, Need::kRequired, arguments);
  AddTargets(command, Need::kOptional, "Print the distance to this point too",
             arguments);
  // Without a count the flag is kAllTargets; the help shows [=N] for it.
  command
      ->add_flag_function(
          "--stop-at-targets{9223372036854775807}",
          [arguments](int64_t count) {
            if (count < 1) {
              throw CLI::ValidationError("--stop-at-targets",
                                         "give a count from 1, or none");
            }
            arguments->stop_at_targets = static_cast<uint64_t>(count);
          },
          "Stop once all targets, or the nearest N of them, are known")
      ->group("Targets");
  AddRadius(command, "Stop at this distance; what is beyond is at infinity",
            arguments);
  command->add_flag("--labels", arguments->labels,
                    "Also which source is nearest to each vertex, by number "
                    "from 0; -1 where none is. A picture shows the cells");
  command->add_flag("--gradients", arguments->gradients,
                    "Also the unit vector in which distance grows at each "
                    "vertex");
  AddFloat32(command, arguments);
  command->add_flag("--progressive", arguments->progressive,
                    "Print vertices and their distances as they become final, "
                    "in order of distance; or write them to -o FILE.csv");
  AddAlgorithm(command, arguments);
  AddPriority(command, arguments);
  AddOutputs(command,
             "Write the field here (labels and gradients too in .npz, .csv, "
             ".ply and .vtk)",
             kFieldFormats, arguments);
  AddPicture(command, arguments);
}

void AddPath(CLI::App* command, Arguments* arguments) {
  AddMesh(command, arguments);
  AddSources(command, Need::kRequired, arguments);
  AddTargets(command, Need::kRequired,
             "Find the path here from the nearest source", arguments);
  AddRadius(command, "Give up targets that are farther", arguments);
  AddAlgorithm(command, arguments);
  AddPriority(command, arguments);
  AddOutputs(command, "Write the paths here", kLineFormats, arguments);
  AddPicture(command, arguments);
}

void AddIsolines(CLI::App* command, Arguments* arguments) {
  AddMesh(command, arguments);
  AddSources(command, Need::kRequired, arguments);
  AddParsed(command, "-l,--level",
            "Draw the line at this distance; may be repeated", ParseLevel,
            [arguments](const std::string&, double level) {
              arguments->levels.push_back(level);
            })
      ->type_name("DISTANCE");
  AddParsed(command, "-n,--count",
            "Draw lines at this many distances instead, evenly spread up to "
            "the largest",
            ParseCount,
            [arguments](const std::string&, uint64_t count) {
              arguments->count = count;
            })
      ->type_name("N");
  AddAlgorithm(command, arguments);
  AddPriority(command, arguments);
  AddOutputs(command, "Write the lines here", kLineFormats, arguments);
  AddPicture(command, arguments);
}

void AddMatrix(CLI::App* command, Arguments* arguments) {
  AddMesh(command, arguments);
  AddSources(command, Need::kRequired, arguments);
  AddTargets(command, Need::kOptional,
             "Make this point a column (default: every vertex)", arguments);
  AddRadius(command, "Leave out distances beyond this one", arguments);
  AddFloat32(command, arguments);
  AddAlgorithm(command, arguments);
  AddPriority(command, arguments);
  AddOutputs(command,
             "Write the matrix here, row by row: dense to .npy, as sparse "
             "rows to .npz (scipy.sparse.load_npz reads it), as "
             "source,target,distance to .csv",
             kMatrixFormats, arguments);
}

void AddNearest(CLI::App* command, Arguments* arguments) {
  AddMesh(command, arguments);
  AddSources(command, Need::kRequired, arguments);
  AddTargets(command, Need::kRequired, "A member of the set to search",
             arguments);
  AddParsed(command, "-k,--count",
            "How many members to find for each source; default: 1", ParseCount,
            [arguments](const std::string&, uint64_t count) {
              arguments->count = count;
            })
      ->type_name("K");
  AddRadius(command, "Find no members farther than this", arguments);
  AddAlgorithm(command, arguments);
  AddPriority(command, arguments);
  AddOutputs(command, "Write what was found here", kTableFormats, arguments);
}

void AddSample(CLI::App* command, Arguments* arguments) {
  AddMesh(command, arguments);
  AddParsed(command, "-n,--count", "How many samples to take; default: 10",
            ParseCount,
            [arguments](const std::string&, uint64_t count) {
              arguments->count = count;
            })
      ->type_name("N");
  AddSources(command, Need::kOptional, arguments);
  AddAlgorithm(command, arguments);
  AddPriority(command, arguments);
  AddOutputs(command, "Write the samples here", kSampleFormats, arguments);
}

void AddLogMap(CLI::App* command, Arguments* arguments) {
  AddMesh(command, arguments);
  AddParsed(command, "-s,--source",
            "The middle of the map, a POINT: VERTEX, edge:A-B@T or "
            "face:F@W0,W1,W2",
            ParsePoint,
            [arguments](const std::string&, SurfacePoint point) {
              std::visit(
                  [arguments](const auto& place) {
                    arguments->sources.push_back({.place = place});
                  },
                  point);
            })
      ->required()
      ->type_name("POINT");
  AddRadius(command, "End the map at this distance", arguments);
  AddFloat32(command, arguments);
  AddAlgorithm(command, arguments);
  AddPriority(command, arguments);
  AddOutputs(command, "Write u and v of every vertex here", kLogMapFormats,
             arguments);
}

bool HasSources(const Arguments& arguments) {
  return !arguments.sources.empty() || !arguments.curves.empty() ||
         !arguments.source_files.empty();
}

bool HasTargets(const Arguments& arguments) {
  return !arguments.targets.empty() || !arguments.target_files.empty();
}

void CheckField(const Arguments& arguments) {
  if (arguments.stop_at_targets.has_value() && !HasTargets(arguments)) {
    throw CLI::ValidationError("--stop-at-targets",
                               "needs --target or --targets");
  }
  if (!arguments.progressive) return;
  if (arguments.labels || arguments.gradients) {
    throw CLI::ValidationError("--progressive",
                               "gives distances only: leave --labels and "
                               "--gradients to a run without it");
  }
  for (const OutputArgument& output : arguments.outputs) {
    if (output.format != OutputFormat::kCsv) {
      throw CLI::ValidationError("--progressive",
                                 "writes .csv only, not " + output.path);
    }
  }
  if (arguments.json && arguments.outputs.empty()) {
    throw CLI::ValidationError(
        "--progressive", "with --json needs -o FILE.csv for the distances");
  }
}

}  // namespace

void AddQuestions(const AddCommand& add, Arguments* arguments) {
  AddField(add("field", "Distances to every vertex, and to any point",
               "  geodesic field horse.ply --source 0 --source 77:0.5 "
               "-o horse.png\n"
               "  geodesic field horse.ply --source face:9@0.2,0.3,0.5 "
               "--radius 0.1 -o d.npy\n"
               "  geodesic field horse.ply --curve '0;edge:0-3@0.5' --source 9 "
               "--labels -o f.npz\n"
               "  geodesic field horse.ply --source 0 --target 9 "
               "--stop-at-targets",
               Command::kField),
           arguments);
  AddPath(add("path", "Shortest paths to points",
              "  geodesic path horse.ply --source 0 --target 99 -o path.obj "
              "-o path.png\n"
              "  geodesic path horse.ply --source 0 --source 7 --targets "
              "points.txt -o p.json",
              Command::kPath),
          arguments);
  AddIsolines(add("isolines", "Lines of equal distance",
                  "  geodesic isolines horse.ply --source 0 --level 0.05 "
                  "--level 0.1 -o l.obj\n"
                  "  geodesic isolines horse.ply --source 0 --count 20 "
                  "-o l.png",
                  Command::kIsolines),
              arguments);
  AddMatrix(add("matrix", "Distances between many points",
                "  geodesic matrix horse.ply --source 0 --source 9 --target 5 "
                "--target 7\n"
                "  geodesic matrix horse.ply --sources rows.txt --radius 0.02 "
                "-o near.npz\n"
                "  geodesic matrix horse.ply --sources all.txt --float32 "
                "-o d.npy",
                Command::kMatrix),
            arguments);
  AddNearest(add("nearest", "The nearest members of a set",
                 "  geodesic nearest horse.ply --source 0 --targets "
                 "stations.txt -k 3",
                 Command::kNearest),
             arguments);
  AddSample(add("sample", "Vertices far from each other",
                "  geodesic sample horse.ply --count 100 -o samples.ply",
                Command::kSample),
            arguments);
  AddLogMap(add("logmap", "Directions and distances around a point",
                "  geodesic logmap horse.ply --source 0 --radius 0.05 "
                "-o uv.npy",
                Command::kLogMap),
            arguments);
}

void CheckArguments(const Arguments& arguments) {
  const Command command = arguments.command;
  const auto is_one_of = [command](std::initializer_list<Command> list) {
    return std::ranges::find(list, command) != list.end();
  };
  if (is_one_of({Command::kField, Command::kPath, Command::kIsolines,
                 Command::kMatrix, Command::kNearest}) &&
      !HasSources(arguments)) {
    throw CLI::RequiredError("--source (or --curve, or --sources FILE)");
  }
  if (is_one_of({Command::kPath, Command::kNearest}) &&
      !HasTargets(arguments)) {
    throw CLI::RequiredError("--target (or --targets FILE)");
  }
  if (command == Command::kField) CheckField(arguments);
  if (command == Command::kIsolines &&
      arguments.levels.empty() != arguments.count.has_value()) {
    throw CLI::ValidationError(
        "--level",
        "give distances with --level, or their number with "
        "--count");
  }
  if (command == Command::kLogMap && arguments.sources.size() != 1) {
    throw CLI::ValidationError("--source", "a log map has one source");
  }
}

}  // namespace geodesic::client
