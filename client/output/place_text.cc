#include "client/output/place_text.h"

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

}  // namespace geodesic::client
