#include "client/cli/arguments/options.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "client/output/number_text.h"
#include "client/output/place_text.h"
#include "geodesic_client/answer.h"
#include "geodesic_types/questions.h"

namespace geodesic::client {
namespace {

absl::Status Wrong(std::string_view text, std::string_view expected) {
  return absl::InvalidArgumentError(
      absl::StrCat("'", std::string(text), "' is not ", std::string(expected)));
}

template <typename Number, typename Accept>
absl::StatusOr<Number> ParseIf(std::string_view text, std::string_view expected,
                               Accept accept) {
  Number number = 0;
  if (!ParseNumber(text, &number) || !accept(number)) {
    return Wrong(text, expected);
  }
  return number;
}

// Parses AZIMUTH,ELEVATION in degrees.
absl::StatusOr<ViewDirection> ParseView(std::string_view text) {
  ViewDirection view;
  const size_t comma = text.find(',');
  if (comma == std::string_view::npos ||
      !ParseNumber(text.substr(0, comma), &view.azimuth) ||
      !ParseNumber(text.substr(comma + 1), &view.elevation) ||
      !(std::abs(view.azimuth) <= 360) || !(std::abs(view.elevation) <= 90)) {
    return Wrong(text,
                 "a view: AZIMUTH,ELEVATION in degrees, such as 30,20 "
                 "(azimuth -360 to 360, elevation -90 to 90)");
  }
  return view;
}

// Parses WIDTHxHEIGHT in pixels.
absl::Status TakeSize(std::string_view text, int* width, int* height) {
  const size_t x = text.find('x');
  const auto in_range = [](int pixels) {
    return pixels >= kLeastPictureSize && pixels <= kMostPictureSize;
  };
  if (x != std::string_view::npos && ParseNumber(text.substr(0, x), width) &&
      ParseNumber(text.substr(x + 1), height) && in_range(*width) &&
      in_range(*height)) {
    return absl::OkStatus();
  }
  return Wrong(text,
               absl::StrCat("a size: WIDTHxHEIGHT in pixels, such as "
                            "1600x1200 (each from ",
                            kLeastPictureSize, " to ", kMostPictureSize, ")"));
}

// Adds an option whose value is one of `words`.
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

// Parses FILE.ENDING, "-" (standard output, .csv) or "-.ENDING".
absl::StatusOr<OutputArgument> ParseOutput(
    const std::string& path, std::span<const OutputFormat> formats) {
  absl::StatusOr<OutputFormat> format = OutputFormatFromPath(path, formats);
  if (!format.ok()) return format.status();
  if (path != kStandardOutput && !path.starts_with("-.")) {
    return OutputArgument{path, *format};
  }
  if (IsCompressed(path)) {
    return absl::InvalidArgumentError(
        "standard output is not compressed: send it through gzip");
  }
  if (*format == OutputFormat::kNpy && isatty(STDOUT_FILENO) != 0) {
    return absl::InvalidArgumentError(
        "standard output is a terminal, which cannot show .npy; send it to a "
        "program or a file, or write -.csv");
  }
  if (*format != OutputFormat::kNpy && *format != OutputFormat::kCsv &&
      *format != OutputFormat::kJson) {
    return absl::InvalidArgumentError(
        absl::StrCat("standard output takes .csv, .npy and .json only, not .",
                     std::string(OutputFormatName(*format)), ": name a file"));
  }
  return OutputArgument{kStandardOutput, *format};
}

void CheckPlaces(const QuestionArguments& question) {
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
  if (std::ranges::count(sources.files, kStandardInput) +
          std::ranges::count(targets.files, kStandardInput) >
      1) {
    Refuse("--sources, --targets",
           "standard input (-) can be read by one of them only, and once");
  }
}

// Adds --algorithm as the question has it.
void AddAlgorithmOf(CLI::App* app, QuestionArguments* question) {
  std::vector<std::string> names = AlgorithmNames();
  std::string help =
      "How windows are propagated; all give the same distances. ";
  if (question->may_be_approximate) {
    const std::vector<std::string> more = ApproximateAlgorithmNames();
    names.insert(names.end(), more.begin(), more.end());
    help = absl::StrCat(
        "How distances are found. Exact algorithms all give the same: ",
        absl::StrJoin(AlgorithmNames(), ", "), ". ", absl::StrJoin(more, ", "),
        " are approximate, and no bound on their error is known. ");
    AddApproximation(app, &question->approximation);
  }
  AddAlgorithm(app, help + "Default: the server's choice, exact", names,
               &question->algorithm);
  // The names are too many for a line.
  if (question->may_be_approximate) {
    app->get_option("--algorithm")->type_name("NAME");
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
      // Each mention takes one value only, since the next word may be MESH.
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
  // Braces hold the value of the flag without a count. The help shows [=N].
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

void AddReading(CLI::App* app, MeshArgument* mesh) {
  std::vector<std::string> names;
  for (const MeshFormatInfo& info : kMeshFormats) names.emplace_back(info.name);
  AddChoice(app,
            {"--format", "How to read the file, if its ending does not tell"},
            names, [mesh](const std::string& name) {
              mesh->format = *MeshFormatFromPath("." + name);
            });
  CLI::Option* const weld =
      app->add_option_function<double>(
             "--weld",
             [mesh](double distance) {
               if (!(distance >= 0 && std::isfinite(distance))) {
                 Refuse("--weld", "give a distance from 0");
               }
               mesh->welding.distance = distance;
             },
             "Join boundary edges whose ends lie within this distance "
             "(default: "
             "within the rounding of the file's numbers)")
          ->type_name("DISTANCE");
  app->add_flag("--no-weld", mesh->welding.keep_seams,
                "Join nothing: faces hang together as the file says")
      ->excludes(weld);
}

void AddMesh(CLI::App* app, const std::string& help, MeshArgument* mesh) {
  app->add_option("MESH", mesh->text, help)->required()->type_name("");
  AddReading(app, mesh);
}

void AddSource(CLI::App* app, const std::string& what,
               SourceArguments* sources) {
  AddText(app,
          {.name = "-s,--source",
           .help = absl::StrCat(what, ", a POINT: ", kPointHelp),
           .type = "POINT",
           .required = true},
          [sources](const std::string& text) {
            absl::StatusOr<WrittenPoint> point = ParsePoint(text);
            if (!point.ok()) return point.status();
            sources->points.push_back({.points = {*point}});
            return absl::OkStatus();
          });
}

void AddSources(CLI::App* app, Need need, SourceArguments* sources) {
  sources->need = need;
  AddValue(app,
           {"-s,--source",
            absl::StrCat("Measure from this POINT: ", kPointHelp,
                         "; it starts with OFFSET (default 0); may be repeated",
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
  if (question->has_algorithm) AddAlgorithmOf(app, question);
  if (question->may_have_tolerance) AddTolerance(app, &question->tolerance);
  AddPriority(app, &question->priority);
  AddOutputs(app, output_help, formats, &question->outputs);
  if (question->adds_to_ply) {
    AddFlag(
        app,
        {"--in-place",
         "Let -o write over MESH, a .ply file, which keeps all it holds and "
         "gets the answer beside it"},
        &question->in_place);
  }
  app->callback([app, question, check = std::move(check)] {
    CheckPlaces(*question);
    CheckOutputs(*app, question->outputs);
    question->other_inputs = OtherInputs(*app);
    CheckTolerance(question->tolerance, question->algorithm);
    if (check != nullptr) check();
  });
}

void AddAlgorithm(CLI::App* app, const std::string& help,
                  const std::vector<std::string>& names,
                  std::string* algorithm) {
  AddChoice(app, {"-a,--algorithm", help}, names,
            [algorithm](const std::string& name) { *algorithm = name; });
}

void AddApproximation(CLI::App* app, Approximation* approximation) {
  const auto parse_count = [](const std::string& text) {
    return ParseIf<uint32_t>(text, "a count: a whole number from 1",
                             [](uint32_t count) { return count > 0; });
  };
  const auto parse_lambda = [](const std::string& text) {
    return ParseIf<double>(
        text,
        "a time to spread: a number above 0, in squared mean edge lengths",
        [](double time) { return time > 0 && std::isfinite(time); });
  };
  AddValue(app,
           {"--neighbours",
            "svg: how many vertices around each one are looked at; default: 50",
            "K", "Approximate algorithms"},
           parse_count, &approximation->neighbours);
  AddValue(app,
           {"--lambda",
            "heat: how long it spreads, in squared mean edge lengths; more is "
            "smoother; default: 1",
            "L", "Approximate algorithms"},
           parse_lambda, &approximation->lambda);
  AddValue(app,
           {"--samples",
            "gtu: how many vertices' exact fields are kept; default: 200", "M",
            "Approximate algorithms"},
           parse_count, &approximation->samples);
}

void AddTolerance(CLI::App* app, double* tolerance) {
  const auto parse = [](const std::string& text) {
    return ParseIf<double>(text, "a tolerance: 0, or a number from 1e-9 to 0.1",
                           [](double number) {
                             return number == 0 || (number >= kLeastTolerance &&
                                                    number <= kMostTolerance);
                           });
  };
  AddValue(app,
           {"--tolerance",
            "Largest relative error that distances may have, from 1e-9 to 0.1. "
            "Less time on large meshes, and the answer certifies its error; "
            "default: 0, exact",
            "E"},
           parse, tolerance);
}

void CheckTolerance(double tolerance, const std::string& algorithm) {
  if (tolerance != 0 && IsApproximate(algorithm)) {
    Refuse("--tolerance", "is certified, and " + algorithm +
                              " is approximate: leave one of them out");
  }
}

void AddPriority(CLI::App* app, Priority* priority) {
  AddChoice(app,
            {"--priority",
             "Let the questions of those who wait go first: batch; default: "
             "interactive"},
            {"interactive", "batch"}, [priority](const std::string& word) {
              *priority =
                  word == "batch" ? Priority::kBatch : Priority::kInteractive;
            });
}

void AddOutputs(CLI::App* app, const std::string& help,
                std::span<const OutputFormat> formats,
                std::vector<OutputArgument>* outputs) {
  AddValue(
      app,
      {"-o,--output",
       absl::StrCat(help, "; may be repeated. The ending says what: ",
                    OutputEndings(formats),
                    "; - is standard output, as .csv unless it has an ending "
                    "too (-.npy, -.json)"),
       "FILE"},
      [formats](const std::string& path) { return ParseOutput(path, formats); },
      outputs);
}

std::vector<std::string> OtherInputs(const CLI::App& app) {
  std::vector<std::string> inputs;
  for (const char* name :
       {"--token-file", "--tls-ca", "--tls-cert", "--tls-key"}) {
    const std::vector<std::string> files =
        app.get_parent()->get_option(name)->results();
    inputs.insert(inputs.end(), files.begin(), files.end());
  }
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& text : option->results()) {
      const std::vector<std::string> files = FilesOfNames(text);
      inputs.insert(inputs.end(), files.begin(), files.end());
    }
  }
  return inputs;
}

void CheckOutputs(const CLI::App& app,
                  const std::vector<OutputArgument>& outputs) {
  const auto count =
      std::ranges::count(outputs, kStandardOutput, &OutputArgument::path);
  if (count > 1) Refuse("--output", "standard output (-) takes one answer");
  std::set<std::filesystem::path> files;
  for (const OutputArgument& output : outputs) {
    std::error_code error;
    auto place = std::filesystem::absolute(output.path, error);
    if (error) place = output.path;  // the working folder is gone
    if (!files.insert(place.lexically_normal()).second) {
      Refuse("--output", output.path + " is named twice, but takes one answer");
    }
  }
  if (count > 0 && WantsJson(app)) {
    Refuse("--json", "prints to standard output, which -o - takes");
  }
}

void AddRadius(CLI::App* app, const std::string& help,
               std::optional<double>* radius) {
  const auto parse = [](const std::string& text) {
    return ParseIf<double>(text,
                           "a radius: a number >= 0, in the unit of the mesh",
                           [](double number) { return number >= 0; });
  };
  AddValue(app, {"-r,--radius", help, "R"}, parse, radius);
}

void AddFloat32(CLI::App* app, bool* float32) {
  AddFlag(app,
          {"--float32",
           "Transfer and write 4-byte floats instead of 8-byte doubles (not "
           "to .f64)"},
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
            return TakeSize(text, &picture->width, &picture->height);
          });
}

absl::StatusOr<double> ParseLevel(std::string_view text) {
  return ParseIf<double>(
      text, "a level: a distance above 0, in the unit of the mesh",
      [](double level) { return level > 0 && std::isfinite(level); });
}

absl::StatusOr<double> ParseChordError(std::string_view text) {
  return ParseIf<double>(
      text, "a chord error: a length above 0, in the unit of the mesh, or inf",
      [](double error) { return error > 0; });
}

absl::StatusOr<double> ParseTimeout(std::string_view text) {
  return ParseIf<double>(text, "a time: a number of seconds above 0",
                         [](double seconds) { return seconds > 0; });
}

absl::StatusOr<uint64_t> ParseCount(std::string_view text) {
  return ParseIf<uint64_t>(text, "a count: a whole number from 1",
                           [](uint64_t count) { return count > 0; });
}

absl::StatusOr<std::string> ParseServer(std::string_view text) {
  if (text.starts_with("unix:/")) return std::string(text);
  const size_t colon = text.rfind(':');
  const std::string_view host = text.substr(0, colon);
  const bool is_ipv6 =
      host.size() > 2 && host.starts_with('[') && host.ends_with(']');
  const bool is_host =
      is_ipv6 || (!host.empty() && std::ranges::all_of(host, [](char c) {
        return absl::ascii_isalnum(c) || c == '.' || c == '-' || c == '_';
      }));
  uint16_t port = 0;
  if (colon == std::string_view::npos || !is_host ||
      !ParseNumber(text.substr(colon + 1), &port) || port == 0) {
    return Wrong(text,
                 "a server: HOST:PORT, such as 127.0.0.1:50051 or "
                 "[::1]:50051, with a port from 1 to 65535; or unix:/PATH");
  }
  return std::string(text);
}

}  // namespace geodesic::client
