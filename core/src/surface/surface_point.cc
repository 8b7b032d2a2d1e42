#include "geodesic/surface_point.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "absl/strings/str_cat.h"
#include "geodesic_types/field_path.h"
#include "surface/surface_location.h"
#include "tolerances.h"

namespace geodesic {
namespace {

absl::Status CheckNumber(uint32_t number, size_t count, const char* things,
                         const std::string& path) {
  if (number < count) return absl::OkStatus();
  return InvalidField(
      path, absl::StrCat(path, " ", number, " is out of range: the mesh has ",
                         count, " ", things, ", numbered from 0"));
}

absl::Status CheckVertex(uint32_t vertex, const Mesh& mesh,
                         const std::string& path) {
  return CheckNumber(vertex, mesh.vertex_count(), "vertices", path);
}

absl::Status CheckPoint(const VertexPoint& point, const Mesh& mesh,
                        const std::string& path) {
  return CheckVertex(point.vertex, mesh, absl::StrCat(path, ".vertex"));
}

absl::Status CheckPoint(const EdgePoint& point, const Mesh& mesh,
                        const std::string& path) {
  const std::string edge = absl::StrCat(path, ".edge");
  absl::Status status =
      CheckVertex(point.from, mesh, absl::StrCat(edge, ".from"));
  status.Update(CheckVertex(point.to, mesh, absl::StrCat(edge, ".to")));
  if (!status.ok()) return status;
  if (!(point.t >= 0 && point.t <= 1)) {
    const std::string t = absl::StrCat(edge, ".t");
    return InvalidField(t,
                        absl::StrCat(t, " ", point.t, " is not within [0, 1]"));
  }
  const auto is_there = [](HalfEdge) { return true; };
  if (!VisitSides(mesh, mesh.JoinedInto(point.from), mesh.JoinedInto(point.to),
                  is_there)) {
    return InvalidField(
        edge, absl::StrCat(edge, ": the mesh has no edge between vertices ",
                           point.from, " and ", point.to,
                           "; name two corners of one face"));
  }
  return absl::OkStatus();
}

absl::Status CheckPoint(const FacePoint& point, const Mesh& mesh,
                        const std::string& path) {
  absl::Status status = CheckNumber(point.face, mesh.face_count(), "faces",
                                    absl::StrCat(path, ".face.face"));
  if (!status.ok()) return status;
  if (mesh.IsLeftOut(point.face)) {
    const std::string face = absl::StrCat(path, ".face.face");
    return InvalidField(
        face, absl::StrCat(face, " ", point.face,
                           " names a vertex twice, so that it is no part of "
                           "the surface"));
  }
  const std::string weights = absl::StrCat(path, ".face.weights");
  double sum = 0;
  for (size_t i = 0; i < 3; ++i) {
    if (!(point.weights[i] >= 0 && std::isfinite(point.weights[i]))) {
      const std::string weight = absl::StrCat(weights, "[", i, "]");
      return InvalidField(
          weight, absl::StrCat(weight, " ", point.weights[i],
                               " is not a finite number >= 0: the point would "
                               "lie outside face ",
                               point.face));
    }
    sum += point.weights[i];
  }
  if (!(std::abs(sum - 1) <= kWeightSumTolerance)) {
    // Digits that tell it from 1.
    char text[32];
    std::snprintf(text, sizeof(text), "%.9g", sum);
    return InvalidField(weights,
                        absl::StrCat(weights, " sum to ", text,
                                     ", not to 1; divide each by their sum"));
  }
  return absl::OkStatus();
}

SurfacePoint Canonical(const VertexPoint& point, const Mesh& mesh) {
  return VertexPoint{mesh.JoinedInto(point.vertex)};
}

SurfacePoint Canonical(const EdgePoint& point, const Mesh& mesh) {
  const EdgePoint joined = {mesh.JoinedInto(point.from),
                            mesh.JoinedInto(point.to), point.t};
  // Turned round first: 1 - t may round to 1.
  const EdgePoint turned =
      joined.from < joined.to ? joined
                              : EdgePoint{joined.to, joined.from, 1 - joined.t};
  if (turned.t <= kLeastWeight) return VertexPoint{turned.from};
  if (turned.t == 1) return VertexPoint{turned.to};
  return turned;
}

SurfacePoint Canonical(const FacePoint& point, const Mesh& mesh) {
  const Triangle& corners = mesh.triangle(point.face);
  const auto& weights = point.weights;
  const double sum = weights[0] + weights[1] + weights[2];
  for (int i = 0; i < 3; ++i) {
    if (weights[i] > kLeastWeight) continue;
    // On the side opposite to corner i.
    const int from = (i + 1) % 3, to = (i + 2) % 3;
    return Canonical(
        EdgePoint{corners[from], corners[to],
                  std::min(weights[to] / (weights[from] + weights[to]), 1.0)},
        mesh);
  }
  return FacePoint{point.face,
                   {weights[0] / sum, weights[1] / sum, weights[2] / sum}};
}

}  // namespace

absl::Status Validate(const SurfacePoint& point, const Mesh& mesh,
                      const std::string& path) {
  return std::visit(
      [&](const auto& place) { return CheckPoint(place, mesh, path); }, point);
}

SurfacePoint Canonicalize(const SurfacePoint& point, const Mesh& mesh) {
  return std::visit([&](const auto& place) { return Canonical(place, mesh); },
                    point);
}

SurfacePoint NamedIn(uint32_t face, const SurfacePoint& point,
                     const Mesh& mesh) {
  const auto* on_edge = std::get_if<EdgePoint>(&point);
  if (on_edge == nullptr || mesh.reading().joined.empty()) return point;
  EdgePoint named = *on_edge;
  for (int corner = 0; corner < 3; ++corner) {
    const uint32_t vertex = mesh.triangle(face)[corner];
    const uint32_t name = mesh.NamedTriangle(face)[corner];
    if (vertex == on_edge->from) named.from = name;
    if (vertex == on_edge->to) named.to = name;
  }
  return named;
}

Point PositionOf(const SurfacePoint& point, const Mesh& mesh) {
  const auto at = [&](uint32_t v) { return mesh.positions()[v]; };
  const auto combine = [](const Point& a, double wa, const Point& b, double wb,
                          const Point& c, double wc) {
    Point sum;
    for (int i = 0; i < 3; ++i) sum[i] = wa * a[i] + wb * b[i] + wc * c[i];
    return sum;
  };
  if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
    return at(vertex->vertex);
  }
  if (const auto* edge = std::get_if<EdgePoint>(&point)) {
    return combine(at(edge->from), 1 - edge->t, at(edge->to), edge->t, {}, 0);
  }
  const auto& [face, weights] = std::get<FacePoint>(point);
  const auto& [a, b, c] = mesh.triangle(face);
  return combine(at(a), weights[0], at(b), weights[1], at(c), weights[2]);
}

}  // namespace geodesic
