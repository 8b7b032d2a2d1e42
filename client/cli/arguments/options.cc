#include "client/cli/arguments/options.h"

#include <CLI/CLI.hpp>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "client/cli/arguments/surface_text.h"
#include "client/cli/arguments/values.h"
#include "geodesic_client/answer.h"

namespace geodesic::client {
namespace {

// One of these words.
CLI::Option* AddChoice(CLI::App* app, const OptionText& text,
                       const std::vector<std::string>& words,
                       std::function<void(const std::string&)> take) {
  return app
      ->add_option_function<std::string>(text.name, std::move(take), text.help)
      ->type_name(absl::StrJoin(words, "|"))
      ->check(CLI::IsMember(words).description(""))
      ->group(text.group);
}

absl::StatusOr<std::string> TakeWord(const std::string& word) { return word; }

void RequirePlaces(const QuestionArguments& question) {
  const SourceArguments& sources = question.sources;
  if (sources.need == Need::kRequired && sources.points.empty() &&
      sources.curves.empty() && sources.files.empty()) {
    throw CLI::RequiredError("--source (or --curve, or --sources FILE)");
  }
  const TargetArguments& targets = question.targets;
  if (targets.need == Need::kRequired && targets.points.empty() &&
      targets.files.empty()) {
    throw CLI::RequiredError("--target (or --targets FILE)");
  }
}

}  // namespace

CLI::Option* AddText(CLI::App* app, const OptionText& text,
                     std::function<absl::Status(const std::string&)> take) {
  const auto take_all = [name = text.name, take = std::move(take)](
                            const std::vector<std::string>& words) {
    for (const std::string& word : words) {
      const absl::Status status = take(word);
      if (!status.ok()) {
        throw CLI::ValidationError(name, std::string(status.message()));
      }
    }
  };
  return app
      ->add_option_function<std::vector<std::string>>(text.name, take_all,
                                                      text.help)
      // One value after each mention: what follows may be MESH.
      ->allow_extra_args(false)
      ->type_name(text.type)
      ->group(text.group)
      ->required(text.required);
}

void AddFlag(CLI::App* app, const OptionText& text, bool* flag) {
  app->add_flag(text.name, *flag, text.help)->group(text.group);
}

void AddFlagOrCount(CLI::App* app, const OptionText& text, int64_t all,
                    std::optional<uint64_t>* count) {
  // The help shows [=N] for what is in braces.
  app->add_flag_function(
         absl::StrCat(text.name, "{", all, "}"),
         [name = text.name, count](int64_t number) {
           if (number < 1) Refuse(name, "give a count from 1, or none");
           *count = static_cast<uint64_t>(number);
         },
         text.help)
      ->group(text.group);
}

void Refuse(const std::string& option, const std::string& why) {
  throw CLI::ValidationError(option, why);
}

bool WantsJson(const CLI::App& app) {
  return app.get_parent()->count("--json") > 0;
}

void AddFiles(CLI::App* app, const std::string& help,
              std::vector<std::string>* files) {
  app->add_option("FILE", *files, help)->required()->type_name("...");
}

void AddFormat(CLI::App* app, std::optional<MeshFormat>* format) {
  AddChoice(app,
            {"--format", "How to read the file, if its ending does not tell"},
            {"obj", "ply", "off", "stl"}, [format](const std::string& name) {
              *format = *MeshFormatFromPath("." + name);
            });
}

void AddMesh(CLI::App* app, const std::string& help, MeshArgument* mesh) {
  app->add_option("MESH", mesh->text, help)->required()->type_name("");
  AddFormat(app, &mesh->format);
}

void AddSources(CLI::App* app, Need need, SourceArguments* sources) {
  sources->need = need;
  AddValue(app,
           {"-s,--source",
            absl::StrCat("Measure from this POINT: VERTEX, edge:A-B@T or "
                         "face:F@W0,W1,W2; it starts with OFFSET (default 0); "
                         "may be repeated",
                         need == Need::kRequired
                             ? " (required, or --curve or --sources)"
                             : "; default: vertex 0"),
            "POINT[:OFFSET]", "Sources"},
           ParseSource, &sources->points);
  AddValue(app,
           {"--curve",
            "Measure from every point of this line, whose neighbouring points "
            "share a face; quote it; may be repeated",
            "'POINT;POINT;...[:OFFSET]'", "Sources"},
           ParseCurve, &sources->curves);
  AddValue(app,
           {"--sources",
            "Read sources and curves from a file, one a line, or from standard "
            "input (-); numbered after those of --source and --curve",
            "FILE", "Sources"},
           TakeWord, &sources->files);
}

void AddTargets(CLI::App* app, Need need, const std::string& help,
                TargetArguments* targets) {
  targets->need = need;
  AddValue(
      app,
      {"-t,--target",
       absl::StrCat(help, "; a POINT as in --source; may be repeated",
                    need == Need::kRequired ? " (required, or --targets)" : ""),
       "POINT", "Targets"},
      ParsePoint, &targets->points);
  AddValue(app,
           {"--targets",
            "Read targets from a file, one a line, or from standard input (-); "
            "numbered after those of --target",
            "FILE", "Targets"},
           TakeWord, &targets->files);
}

void AddQuestion(CLI::App* app, const std::string& output_help,
                 std::span<const OutputFormat> formats,
                 QuestionArguments* question, std::function<void()> check) {
  AddChoice(app,
            {"-a,--algorithm",
             "How windows are propagated; all give the same distances. "
             "Default: the server's choice"},
            AlgorithmNames(), [question](const std::string& name) {
              question->algorithm = name;
            });
  AddChoice(app,
            {"--priority",
             "Let the questions of those who wait go first: batch; default: "
             "interactive"},
            {"interactive", "batch"}, [question](const std::string& priority) {
              question->priority = priority == "batch" ? Priority::kBatch
                                                       : Priority::kInteractive;
            });
  AddValue(
      app,
      {"-o,--output",
       absl::StrCat(output_help, "; may be repeated. The ending says what: ",
                    OutputEndings(formats)),
       "FILE"},
      [formats](const std::string& path) -> absl::StatusOr<OutputArgument> {
        absl::StatusOr<OutputFormat> format =
            OutputFormatFromPath(path, formats);
        if (!format.ok()) return format.status();
        return OutputArgument{path, *format};
      },
      &question->outputs);
  app->callback([question, check = std::move(check)] {
    RequirePlaces(*question);
    if (check != nullptr) check();
  });
}

void AddRadius(CLI::App* app, const std::string& help,
               std::optional<double>* radius) {
  AddValue(app, {"-r,--radius", help, "R"}, ParseRadius, radius);
}

void AddFloat32(CLI::App* app, bool* float32) {
  AddFlag(app,
          {"--float32",
           "Transfer 4-byte floats instead of 8-byte doubles; NumPy files then "
           "hold floats too"},
          float32);
}

void AddPicture(CLI::App* app, PictureOptions* picture) {
  AddValue(app,
           {"--view",
            "Direction the picture is seen from, in degrees; default: one that "
            "shows much of the mesh and what is drawn on it",
            "AZIMUTH,ELEVATION", "Picture"},
           ParseView, &picture->direction);
  AddChoice(app,
            {.name = "--up",
             .help = "Axis that points up in the picture; default: guessed",
             .group = "Picture"},
            {"y", "z"}, [picture](const std::string& axis) {
              picture->up = axis == "z" ? UpAxis::kZ : UpAxis::kY;
            });
  AddText(app,
          {"--size", "Size of the picture; default: 1600x1200", "WIDTHxHEIGHT",
           "Picture"},
          [picture](const std::string& text) {
            absl::StatusOr<PictureSize> size = ParseSize(text);
            if (size.ok()) {
              picture->width = size->width;
              picture->height = size->height;
            }
            return size.status();
          });
}

}  // namespace geodesic::client
