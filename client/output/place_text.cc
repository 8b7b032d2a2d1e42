#include "client/output/place_text.h"

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
    "weights >= 0 that sum to 1)";

constexpr std::string_view kEdge = "edge:";
constexpr std::string_view kFace = "face:";

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

// The functions below return what is wrong with the text, or an empty string.

std::string ParseIndex(std::string_view text, const char* what,
                       uint64_t* number) {
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

std::string ParseFace(std::string_view text, FacePoint* point) {
  std::string_view face;
  std::string_view weights;
  std::array<std::string_view, 3> w;
  if (!Split(text, '@', &face, &weights) ||
      !Split(weights, ',', &w[0], &weights) ||
      !Split(weights, ',', &w[1], &w[2])) {
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

std::string ParsePlace(std::string_view text, SurfacePoint* point) {
  if (text.starts_with(kEdge)) {
    return ParseEdge(text.substr(kEdge.size()), &point->emplace<EdgePoint>());
  }
  if (text.starts_with(kFace)) {
    return ParseFace(text.substr(kFace.size()), &point->emplace<FacePoint>());
  }
  return ParseIndex(text, "vertex", &point->emplace<VertexPoint>().vertex);
}

// Takes ":OFFSET" off the end of a place.
std::string TakeOffset(std::string_view* text, double* offset) {
  // The colon after "edge" and "face" belongs to the place.
  const size_t kind =
      text->starts_with(kEdge) || text->starts_with(kFace) ? kEdge.size() : 0;
  const size_t colon = text->find(':', kind);
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
  if (!lines) {
    return absl::ErrnoToStatus(errno, absl::StrCat("cannot read ", path));
  }
  std::vector<Item> items;
  std::string line;
  for (uint64_t number = 1; std::getline(lines, line); ++number) {
    if (line.ends_with('\r')) line.pop_back();
    if (line.empty() || line.starts_with('#')) continue;
    absl::StatusOr<Item> item = parse(line);
    if (!item.ok()) {
      return absl::InvalidArgumentError(absl::StrCat(
          path, " line ", number, ": ", std::string(item.status().message())));
    }
    items.push_back(*std::move(item));
  }
  if (lines.bad()) {
    return absl::ErrnoToStatus(errno, absl::StrCat("cannot read ", path));
  }
  return items;
}

}  // namespace

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

absl::StatusOr<SurfacePoint> ParsePoint(std::string_view text) {
  SurfacePoint point;
  const std::string problem = ParsePlace(text, &point);
  if (!problem.empty()) return Wrong(text, "point", problem, kPointForms);
  return point;
}

absl::StatusOr<Source> ParseSource(std::string_view text) {
  Source source;
  std::string_view place = text;
  SurfacePoint point;
  std::string problem = TakeOffset(&place, &source.offset);
  if (problem.empty()) problem = ParsePlace(place, &point);
  if (!problem.empty()) {
    return Wrong(text, "source", problem,
                 absl::StrCat(std::string(kPointForms),
                              ", each also with :OFFSET >= 0"));
  }
  std::visit([&source](const auto& at) { source.place = at; }, point);
  return source;
}

absl::StatusOr<Source> ParseCurve(std::string_view text) {
  Source source;
  Curve curve;
  std::string_view rest = text;
  std::string_view place;
  SurfacePoint point;
  std::string problem;
  while (problem.empty() && Split(rest, ';', &place, &rest)) {
    problem = ParsePlace(place, &point);
    curve.points.push_back(point);
  }
  if (problem.empty()) problem = TakeOffset(&rest, &source.offset);
  if (problem.empty()) problem = ParsePlace(rest, &point);
  if (!problem.empty()) {
    return Wrong(text, "curve", problem,
                 absl::StrCat("POINT;POINT;... or POINT;POINT;...:OFFSET, "
                              "where POINT is ",
                              std::string(kPointForms)));
  }
  curve.points.push_back(point);
  source.place = std::move(curve);
  return source;
}

absl::StatusOr<std::vector<Source>> ReadSources(const std::string& path) {
  return ReadList<Source>(path, [](std::string_view line) {
    return line.find(';') == std::string_view::npos ? ParseSource(line)
                                                    : ParseCurve(line);
  });
}

absl::StatusOr<std::vector<SurfacePoint>> ReadPoints(const std::string& path) {
  return ReadList<SurfacePoint>(path, ParsePoint);
}

}  // namespace geodesic::client
