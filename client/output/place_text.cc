#include "client/output/place_text.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <iostream>
#include <utility>

#include "absl/strings/str_cat.h"
#include "client/output/number_text.h"

namespace geodesic::client {
namespace {

using Json = nlohmann::ordered_json;

struct PlaceText {
  std::string operator()(const SurfacePoint& point) const {
    return std::visit(*this, point);
  }
  std::string operator()(const VertexPoint& point) const {
    return NumberText(point.vertex);
  }
  std::string operator()(const EdgePoint& point) const {
    return absl::StrCat("edge:", point.from, "-", point.to, "@",
                        NumberText(point.t));
  }
  std::string operator()(const FacePoint& point) const {
    return absl::StrCat("face:", point.face, "@", NumberText(point.weights[0]),
                        ",", NumberText(point.weights[1]), ",",
                        NumberText(point.weights[2]));
  }
  std::string operator()(const Curve& curve) const {
    std::string text;
    for (const SurfacePoint& point : curve.points) {
      absl::StrAppend(&text, text.empty() ? "" : ";", PointText(point));
    }
    return text;
  }
};

struct PlaceJson {
  Json operator()(const SurfacePoint& point) const {
    return std::visit(*this, point);
  }
  Json operator()(const VertexPoint& point) const {
    return {{"vertex", point.vertex}};
  }
  Json operator()(const EdgePoint& point) const {
    return {{"edge", {point.from, point.to}}, {"t", point.t}};
  }
  Json operator()(const FacePoint& point) const {
    return {{"face", point.face}, {"weights", point.weights}};
  }
  Json operator()(const Curve& curve) const {
    Json points = Json::array();
    for (const SurfacePoint& point : curve.points) {
      points.push_back(PointToJson(point));
    }
    return {{"curve", points}};
  }
};

constexpr std::string_view kPointForms =
    "VERTEX, edge:A-B@T or face:F@W0,W1,W2 (numbers from 0, T from 0 to 1, "
    "weights >= 0 that sum to 1), nearest:X,Y,Z, min: or max: with x, y or z, "
    "or name:NAME@FILE";

constexpr std::string_view kEdge = "edge:";
constexpr std::string_view kFace = "face:";
constexpr std::string_view kNearest = "nearest:";
constexpr std::string_view kLeast = "min:";
constexpr std::string_view kGreatest = "max:";
constexpr std::string_view kNamed = "name:";

// How many names of a file are told where one is missing.
constexpr size_t kMostNamesTold = 10;

absl::Status Wrong(std::string_view text, const char* kind,
                   const std::string& problem, std::string_view forms) {
  return absl::InvalidArgumentError(
      absl::StrCat("'", std::string(text), "' is not a ", kind, ": ", problem,
                   "; write ", std::string(forms)));
}

std::string Quoted(std::string_view text) {
  return absl::StrCat("'", std::string(text), "'");
}

// Cuts `text` at the first `separator`. Returns false if there is none.
bool Split(std::string_view text, char separator, std::string_view* before,
           std::string_view* after) {
  const size_t at = text.find(separator);
  if (at == std::string_view::npos) return false;
  *before = text.substr(0, at);
  *after = text.substr(at + 1);
  return true;
}

std::string_view Trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

// The functions below return what is wrong with the text, or an empty string.

std::string ParseIndex(std::string_view text, const char* what,
                       uint32_t* number) {
  return ParseNumber(text, number)
             ? ""
             : absl::StrCat(Quoted(text), " is not a ", what, "'s number");
}

std::string ParseEdge(std::string_view text, EdgePoint* point) {
  std::string_view ends;
  std::string_view t;
  std::string_view from;
  std::string_view to;
  if (!Split(text, '@', &ends, &t) || !Split(ends, '-', &from, &to)) {
    return "an edge needs A-B and @T";
  }
  std::string problem = ParseIndex(from, "vertex", &point->from);
  if (problem.empty()) problem = ParseIndex(to, "vertex", &point->to);
  if (!problem.empty()) return problem;
  if (!ParseNumber(t, &point->t) || !(point->t >= 0 && point->t <= 1)) {
    return absl::StrCat("T is ", Quoted(t), ", not a number from 0 to 1");
  }
  return "";
}

// Cuts `text` at its first two commas. Returns false if there are not as many.
bool SplitThree(std::string_view text, std::array<std::string_view, 3>* parts) {
  return Split(text, ',', &(*parts)[0], &text) &&
         Split(text, ',', &(*parts)[1], &(*parts)[2]);
}

std::string ParseFace(std::string_view text, FacePoint* point) {
  std::string_view face;
  std::string_view weights;
  std::array<std::string_view, 3> w;
  if (!Split(text, '@', &face, &weights) || !SplitThree(weights, &w)) {
    return "a face needs @ and three weights";
  }
  std::string problem = ParseIndex(face, "face", &point->face);
  for (size_t i = 0; i < w.size() && problem.empty(); ++i) {
    double& weight = point->weights[i];
    if (!ParseNumber(w[i], &weight) || !std::isfinite(weight)) {
      problem = absl::StrCat("the weight ", Quoted(w[i]), " is not a number");
    } else if (weight < 0) {
      problem = absl::StrCat("the weight ", Quoted(w[i]),
                             " is below 0, outside the face");
    }
  }
  return problem;
}

std::string ParseNearest(std::string_view text, NearestPoint* point) {
  std::array<std::string_view, 3> parts;
  if (!SplitThree(text, &parts)) return "nearest needs three coordinates";
  for (size_t axis = 0; axis < parts.size(); ++axis) {
    const std::string_view number = Trimmed(parts[axis]);
    double& coordinate = point->to[axis];
    if (!ParseNumber(number, &coordinate) || !std::isfinite(coordinate)) {
      return absl::StrCat("the coordinate ", Quoted(number),
                          " is not a finite number");
    }
  }
  return "";
}

std::string ParseExtreme(std::string_view text, bool is_greatest,
                         ExtremeVertex* vertex) {
  constexpr std::string_view kAxes = "xyz";
  const size_t axis = text.size() == 1 ? kAxes.find(text) : text.npos;
  if (axis == text.npos) {
    return absl::StrCat(Quoted(text), " is not an axis: x, y or z");
  }
  *vertex = {axis, is_greatest};
  return "";
}

std::string ParsePlace(std::string_view text, WrittenPoint* point);

// Looks the name up in its file.
std::string ParseNamed(std::string_view text, WrittenPoint* point) {
  std::string_view name;
  std::string_view path;
  if (!Split(text, '@', &name, &path) || name.empty() || path.empty()) {
    return "a name needs @ and the file that lists it";
  }
  std::ifstream file{std::string(path)};
  std::string names;
  size_t name_count = 0;
  uint64_t found = 0;  // the line
  std::string problem;
  std::string line;
  for (uint64_t number = 1; std::getline(file, line); ++number) {
    const std::string_view entry = Trimmed(WithoutMark(line, number));
    if (entry.empty() || entry.starts_with('#')) continue;
    const size_t end = std::min(entry.find_first_of(" \t"), entry.size());
    const std::string_view known = entry.substr(0, end);
    const std::string_view place = Trimmed(entry.substr(end));
    if (known != name) {
      if (name_count++ < kMostNamesTold) {
        absl::StrAppend(&names, names.empty() ? "" : ", ", std::string(known));
      }
      continue;
    }
    if (found != 0) {
      return absl::StrCat(std::string(path), " lists ", Quoted(name),
                          " twice, in lines ", found, " and ", number);
    }
    found = number;
    problem = place.starts_with(kNamed)
                  ? "a name stands for a place, not a name"
                  : ParsePlace(place, point);
  }
  if (!file.eof()) {
    return absl::StrCat("cannot read ", std::string(path));
  }
  if (found != 0) {
    return problem.empty() ? ""
                           : absl::StrCat(std::string(path), " line ", found,
                                          ": ", problem);
  }
  return absl::StrCat(std::string(path), " does not list ", Quoted(name),
                      names.empty() ? "" : ", but ", names,
                      name_count > kMostNamesTold ? ", ..." : "");
}

std::string ParsePlace(std::string_view text, WrittenPoint* point) {
  if (text.starts_with(kNamed)) {
    return ParseNamed(text.substr(kNamed.size()), point);
  }
  if (text.starts_with(kEdge)) {
    return ParseEdge(text.substr(kEdge.size()), &point->emplace<EdgePoint>());
  }
  if (text.starts_with(kFace)) {
    return ParseFace(text.substr(kFace.size()), &point->emplace<FacePoint>());
  }
  if (text.starts_with(kNearest)) {
    return ParseNearest(text.substr(kNearest.size()),
                        &point->emplace<NearestPoint>());
  }
  for (const std::string_view kind : {kLeast, kGreatest}) {
    if (!text.starts_with(kind)) continue;
    return ParseExtreme(text.substr(kind.size()), kind == kGreatest,
                        &point->emplace<ExtremeVertex>());
  }
  return ParseIndex(text, "vertex", &point->emplace<VertexPoint>().vertex);
}

// Takes ":OFFSET" off the end of a place.
std::string TakeOffset(std::string_view* text, double* offset) {
  // The colon after "edge" and the like belongs to the place.
  size_t begin = 0;
  for (const std::string_view kind :
       {kEdge, kFace, kNearest, kLeast, kGreatest, kNamed}) {
    if (text->starts_with(kind)) begin = kind.size();
  }
  const size_t colon = text->find(':', begin);
  if (colon == std::string_view::npos) return "";
  const std::string_view number = text->substr(colon + 1);
  *text = text->substr(0, colon);
  return ParseNumber(number, offset) && std::isfinite(*offset) && *offset >= 0
             ? ""
             : absl::StrCat("the offset ", Quoted(number),
                            " is not a number >= 0");
}

// The results of `parse` for each line of a file.
template <typename Item, typename Parse>
absl::StatusOr<std::vector<Item>> ReadList(const std::string& path,
                                           Parse parse) {
  std::ifstream file;
  if (path != kStandardInput) file.open(path);
  std::istream& lines = path == kStandardInput ? std::cin : file;
  const auto cannot_read = [&path] {
    return absl::ErrnoToStatus(errno,
                               absl::StrCat("cannot read ", ListName(path)));
  };
  if (!lines) return cannot_read();
  std::vector<Item> items;
  std::string line;
  for (uint64_t number = 1; std::getline(lines, line); ++number) {
    const std::string_view entry = Trimmed(WithoutMark(line, number));
    if (entry.empty() || entry.starts_with('#')) continue;
    absl::StatusOr<Item> item = parse(entry);
    if (!item.ok()) {
      return absl::InvalidArgumentError(
          absl::StrCat(ListName(path), " line ", number, ": ",
                       std::string(item.status().message())));
    }
    items.push_back(*std::move(item));
  }
  if (lines.bad()) return cannot_read();
  return items;
}

}  // namespace

std::string ListName(const std::string& path) {
  return path == kStandardInput ? "standard input" : path;
}

std::string_view WithoutMark(std::string_view line, uint64_t number) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  return number == 1 && line.starts_with(kMark) ? line.substr(kMark.size())
                                                : line;
}

std::string PointText(const SurfacePoint& point) {
  return std::visit(PlaceText(), point);
}

std::string SourceText(const Source& source) {
  std::string text = std::visit(PlaceText(), source.place);
  if (source.offset != 0) {
    absl::StrAppend(&text, ":", NumberText(source.offset));
  }
  return text;
}

Json PointToJson(const SurfacePoint& point) {
  return std::visit(PlaceJson(), point);
}

Json SourceToJson(const Source& source) {
  Json json = std::visit(PlaceJson(), source.place);
  json["offset"] = source.offset;
  return json;
}

std::vector<std::string> FilesOfNames(std::string_view text) {
  std::vector<std::string> files;
  for (std::string_view rest = text; !rest.empty();) {
    const size_t end = std::min(rest.find(';'), rest.size());
    const std::string_view point = Trimmed(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    std::string_view name, path;
    if (!point.starts_with(kNamed) || !Split(point, '@', &name, &path))
      continue;
    files.emplace_back(path);
    files.emplace_back(path.substr(0, path.rfind(':')));
  }
  return files;
}

absl::StatusOr<WrittenPoint> ParsePoint(std::string_view text) {
  WrittenPoint point;
  const std::string problem = ParsePlace(text, &point);
  if (!problem.empty()) return Wrong(text, "point", problem, kPointForms);
  return point;
}

absl::StatusOr<WrittenSource> ParseSource(std::string_view text) {
  WrittenSource source = {.points = {{}}};
  std::string_view place = text;
  std::string problem = TakeOffset(&place, &source.offset);
  if (problem.empty()) problem = ParsePlace(place, &source.points[0]);
  if (!problem.empty()) {
    return Wrong(text, "source", problem,
                 absl::StrCat(std::string(kPointForms),
                              ", each also with :OFFSET >= 0"));
  }
  return source;
}

absl::StatusOr<WrittenSource> ParseCurve(std::string_view text) {
  WrittenSource source = {.is_curve = true};
  std::string_view rest = text;
  std::string_view place;
  WrittenPoint point;
  std::string problem;
  while (problem.empty() && Split(rest, ';', &place, &rest)) {
    problem = ParsePlace(place, &point);
    source.points.push_back(point);
  }
  if (problem.empty()) problem = TakeOffset(&rest, &source.offset);
  if (problem.empty()) problem = ParsePlace(rest, &point);
  if (!problem.empty()) {
    return Wrong(text, "curve", problem,
                 absl::StrCat("POINT;POINT;... or POINT;POINT;...:OFFSET, "
                              "where POINT is ",
                              std::string(kPointForms)));
  }
  source.points.push_back(point);
  return source;
}

absl::StatusOr<std::vector<WrittenSource>> ReadSources(
    const std::string& path) {
  return ReadList<WrittenSource>(path, [](std::string_view line) {
    return line.find(';') == std::string_view::npos ? ParseSource(line)
                                                    : ParseCurve(line);
  });
}

absl::StatusOr<std::vector<WrittenPoint>> ReadPoints(const std::string& path) {
  return ReadList<WrittenPoint>(path, ParsePoint);
}

}  // namespace geodesic::client
