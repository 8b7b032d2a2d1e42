#include "client/cli/options.h"

#include <map>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "client/cli/surface_text.h"
#include "geodesic_client/answer.h"

namespace geodesic::client {
namespace {

constexpr char kMeshHelp[] =
    "A mesh file, uploaded if the server lacks it; or the digest of a resident "
    "mesh, of which the first 8 digits do if they are unique";

const std::map<std::string, MeshFormat>& FormatNames() {
  static const auto& names =
      *new std::map<std::string, MeshFormat>{{"obj", MeshFormat::kObj},
                                             {"ply", MeshFormat::kPly},
                                             {"off", MeshFormat::kOff},
                                             {"stl", MeshFormat::kStl}};
  return names;
}

}  // namespace

void AddFormat(CLI::App* command, Arguments* arguments) {
  command
      ->add_option_function<std::string>(
          "--format",
          [arguments](const std::string& name) {
            arguments->format = FormatNames().at(name);
          },
          "How to read the file, if its ending does not tell")
      ->type_name("obj|ply|off|stl")
      ->check(CLI::IsMember(FormatNames()).description(""));
}

void AddMesh(CLI::App* command, const std::string& help, Arguments* arguments) {
  command->add_option("MESH", arguments->mesh, help)->required()->type_name("");
  AddFormat(command, arguments);
}

void AddMesh(CLI::App* command, Arguments* arguments) {
  AddMesh(command, kMeshHelp, arguments);
}

void AddSources(CLI::App* command, Need need, Arguments* arguments) {
  constexpr char kGroup[] = "Sources";
  AddParsed(command, "-s,--source",
            absl::StrCat("Measure from this POINT: VERTEX, edge:A-B@T or "
                         "face:F@W0,W1,W2; it starts with OFFSET (default 0); "
                         "may be repeated",
                         need == Need::kRequired
                             ? " (required, or --curve or --sources)"
                             : "; default: vertex 0"),
            ParseSource,
            [arguments](const std::string&, Source source) {
              arguments->sources.push_back(std::move(source));
            })
      ->type_name("POINT[:OFFSET]")
      ->group(kGroup);
  AddParsed(command, "--curve",
            "Measure from every point of this line, whose neighbouring points "
            "share a face; quote it; may be repeated",
            ParseCurve,
            [arguments](const std::string&, Source source) {
              arguments->curves.push_back(std::move(source));
            })
      ->type_name("'POINT;POINT;...[:OFFSET]'")
      ->group(kGroup);
  command
      ->add_option("--sources", arguments->source_files,
                   "Read sources and curves from a file, one a line; numbered "
                   "after those of --source and --curve")
      ->allow_extra_args(false)
      ->default_str("")
      ->type_name("FILE")
      ->group(kGroup);
}

void AddTargets(CLI::App* command, Need need, const std::string& help,
                Arguments* arguments) {
  constexpr char kGroup[] = "Targets";
  AddParsed(
      command, "-t,--target",
      absl::StrCat(help, "; a POINT as in --source; may be repeated",
                   need == Need::kRequired ? " (required, or --targets)" : ""),
      ParsePoint,
      [arguments](const std::string&, SurfacePoint point) {
        arguments->targets.push_back(point);
      })
      ->type_name("POINT")
      ->group(kGroup);
  command
      ->add_option("--targets", arguments->target_files,
                   "Read targets from a file, one a line; numbered after those "
                   "of --target")
      ->allow_extra_args(false)
      ->default_str("")
      ->type_name("FILE")
      ->group(kGroup);
}

void AddAlgorithm(CLI::App* command, Arguments* arguments) {
  command
      ->add_option("-a,--algorithm", arguments->algorithm,
                   "How windows are propagated; all give the same distances. "
                   "Default: the server's choice")
      ->type_name(absl::StrJoin(AlgorithmNames(), "|"))
      ->check(CLI::IsMember(AlgorithmNames()).description(""));
}

void AddPriority(CLI::App* command, Arguments* arguments) {
  command
      ->add_option_function<std::string>(
          "--priority",
          [arguments](const std::string& priority) {
            arguments->priority =
                priority == "batch" ? Priority::kBatch : Priority::kInteractive;
          },
          "Let the questions of those who wait go first: batch; default: "
          "interactive")
      ->type_name("interactive|batch")
      ->check(CLI::IsMember({"interactive", "batch"}).description(""));
}

void AddRadius(CLI::App* command, const std::string& help,
               Arguments* arguments) {
  AddParsed(command, "-r,--radius", help, ParseRadius,
            [arguments](const std::string&, double radius) {
              arguments->radius = radius;
            })
      ->type_name("R");
}

void AddFloat32(CLI::App* command, Arguments* arguments) {
  command->add_flag("--float32", arguments->float32,
                    "Transfer 4-byte floats instead of 8-byte doubles; NumPy "
                    "files then hold floats too");
}

void AddOutputs(CLI::App* command, const std::string& help,
                std::span<const OutputFormat> formats, Arguments* arguments) {
  AddParsed(
      command, "-o,--output",
      absl::StrCat(help, "; may be repeated. The ending says what: ",
                   OutputEndings(formats)),
      [formats](std::string_view path) {
        return OutputFormatFromPath(path, formats);
      },
      [arguments](const std::string& path, OutputFormat format) {
        arguments->outputs.push_back({path, format});
      })
      ->type_name("FILE");
}

void AddPicture(CLI::App* command, Arguments* arguments) {
  constexpr char kGroup[] = "Picture";
  AddParsed(command, "--view",
            "Direction the picture is seen from, in degrees; default: one that "
            "shows much of the mesh and what is drawn on it",
            ParseView,
            [arguments](const std::string&, ViewDirection view) {
              arguments->picture.direction = view;
            })
      ->type_name("AZIMUTH,ELEVATION")
      ->group(kGroup);
  command
      ->add_option_function<std::string>(
          "--up",
          [arguments](const std::string& axis) {
            arguments->picture.up = axis == "z" ? UpAxis::kZ : UpAxis::kY;
          },
          "Axis that points up in the picture; default: guessed")
      ->type_name("y|z")
      ->check(CLI::IsMember({"y", "z"}).description(""))
      ->group(kGroup);
  AddParsed(command, "--size", "Size of the picture; default: 1600x1200",
            ParseSize,
            [arguments](const std::string&, PictureSize size) {
              arguments->picture.width = size.width;
              arguments->picture.height = size.height;
            })
      ->type_name("WIDTHxHEIGHT")
      ->group(kGroup);
}

}  // namespace geodesic::client
