#include "tests/support/surface_points.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>

namespace geodesic::test {
namespace {

Place AtCorner(uint32_t face, uint32_t corner) {
  Place place{.face = face};
  place.weights[corner] = 1;
  return place;
}

int CornerOf(const Triangle& t, uint32_t vertex) {
  const auto at = std::find(t.begin(), t.end(), vertex);
  return at == t.end() ? -1 : static_cast<int>(at - t.begin());
}

std::vector<Place> PlacesOfVertex(const TriangleSoup& soup, uint32_t vertex) {
  std::vector<Place> places;
  for (uint32_t f = 0; f < soup.triangles.size(); ++f) {
    const int corner = CornerOf(soup.triangles[f], vertex);
    if (corner >= 0) places.push_back(AtCorner(f, corner));
  }
  return places;
}

// weight_from + weight_to = 1. Both are told: 1 - t loses a small t.
std::vector<Place> PlacesOnEdge(const TriangleSoup& soup, uint32_t from,
                                Real weight_from, uint32_t to, Real weight_to) {
  if (weight_to == 0) return PlacesOfVertex(soup, from);
  if (weight_from == 0) return PlacesOfVertex(soup, to);
  std::vector<Place> places;
  for (uint32_t f = 0; f < soup.triangles.size(); ++f) {
    const int a = CornerOf(soup.triangles[f], from);
    const int b = CornerOf(soup.triangles[f], to);
    if (a < 0 || b < 0) continue;
    Place place{.face = f};
    place.weights[a] = weight_from;
    place.weights[b] = weight_to;
    places.push_back(place);
  }
  return places;
}

uint32_t RandomFace(const TriangleSoup& soup, Random& random) {
  return random.Below(static_cast<uint32_t>(soup.triangles.size()));
}

}  // namespace

std::vector<Place> PlacesOf(const TriangleSoup& soup,
                            const SurfacePoint& point) {
  if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
    return PlacesOfVertex(soup, vertex->vertex);
  }
  if (const auto* edge = std::get_if<EdgePoint>(&point)) {
    const Real t = edge->t;
    return PlacesOnEdge(soup, edge->from, 1 - t, edge->to, t);
  }
  const auto& [face, given] = std::get<FacePoint>(point);
  Place place{.face = face};
  const Real sum = Real{given[0]} + given[1] + given[2];
  for (int i = 0; i < 3; ++i) place.weights[i] = given[i] / sum;
  const Triangle& t = soup.triangles[face];
  for (int i = 0; i < 3; ++i) {
    if (place.weights[i] != 0) continue;
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    return PlacesOnEdge(soup, t[j], place.weights[j], t[k], place.weights[k]);
  }
  return {place};
}

bool HaveCommonFace(const TriangleSoup& soup, const SurfacePoint& a,
                    const SurfacePoint& b) {
  const std::vector<Place> around_b = PlacesOf(soup, b);
  return std::ranges::any_of(PlacesOf(soup, a), [&](const Place& place) {
    return std::ranges::find(around_b, place.face, &Place::face) !=
           around_b.end();
  });
}

std::string Name(const SurfacePoint& point) {
  std::ostringstream text;
  text << std::setprecision(17);
  if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
    text << "vertex " << vertex->vertex;
  } else if (const auto* edge = std::get_if<EdgePoint>(&point)) {
    text << "edge " << edge->from << "-" << edge->to << "@" << edge->t;
  } else {
    const auto& [face, weights] = std::get<FacePoint>(point);
    text << "face " << face << "(" << weights[0] << "," << weights[1] << ","
         << weights[2] << ")";
  }
  return text.str();
}

std::string Name(const Source& source) {
  std::ostringstream text;
  text << std::setprecision(17);
  if (const auto* curve = std::get_if<Curve>(&source.place)) {
    text << "curve";
    for (const SurfacePoint& point : curve->points) text << " " << Name(point);
  } else {
    text << Name(std::get<SurfacePoint>(source.place));
  }
  if (source.offset != 0) {
    text << " + " << source.offset;
  }
  return text.str();
}

Vec3 PositionIn(const TriangleSoup& soup, const SurfacePoint& point) {
  if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
    return ToVec3(soup.positions[vertex->vertex]);
  }
  const Place place = PlacesOf(soup, point)[0];
  Vec3 sum;
  for (int i = 0; i < 3; ++i) {
    const uint32_t v = soup.triangles[place.face][i];
    sum = sum + place.weights[i] * ToVec3(soup.positions[v]);
  }
  return sum;
}

Inserted InsertPoint(TriangleSoup soup, const SurfacePoint& point) {
  if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
    return {std::move(soup), vertex->vertex};
  }
  const std::vector<Place> places = PlacesOf(soup, point);
  for (int i = 0; i < 3; ++i) {
    const Real* weights = places[0].weights;
    if (weights[(i + 1) % 3] == 0 && weights[(i + 2) % 3] == 0) {
      const uint32_t vertex = soup.triangles[places[0].face][i];
      return {std::move(soup), vertex};
    }
  }
  const Vec3 at = PositionIn(soup, point);
  const uint32_t added = static_cast<uint32_t>(soup.positions.size());
  soup.positions.push_back({static_cast<double>(at.x),
                            static_cast<double>(at.y),
                            static_cast<double>(at.z)});
  for (const Place& place : places) {
    // One face for every side that does not hold the point.
    const Triangle old = soup.triangles[place.face];
    bool is_first = true;
    for (int i = 0; i < 3; ++i) {
      if (place.weights[i] == 0) continue;
      Triangle part = old;
      part[i] = added;
      if (is_first) {
        soup.triangles[place.face] = part;
      } else {
        soup.triangles.push_back(part);
      }
      is_first = false;
    }
  }
  return {std::move(soup), added};
}

SurfacePoint RandomFacePoint(const TriangleSoup& soup, Random& random) {
  const double u = random.Uniform(0.02, 0.48), v = random.Uniform(0.02, 0.48);
  return FacePoint{RandomFace(soup, random), {u, v, 1 - u - v}};
}

SurfacePoint RandomEdgePoint(const TriangleSoup& soup, Random& random) {
  const Triangle& t = soup.triangles[RandomFace(soup, random)];
  const uint32_t side = random.Below(3);
  return EdgePoint{t[side], t[(side + 1) % 3], random.Uniform(0.02, 0.98)};
}

SurfacePoint RandomVertexPoint(const TriangleSoup& soup, Random& random) {
  return VertexPoint{soup.triangles[RandomFace(soup, random)][random.Below(3)]};
}

SurfacePoint RandomPointNearby(const TriangleSoup& soup, double distance,
                               Random& random) {
  const uint32_t face = RandomFace(soup, random);
  const uint32_t i = random.Below(3), j = (i + 1) % 3, k = (i + 2) % 3;
  const Triangle& t = soup.triangles[face];
  FacePoint point{.face = face};
  switch (random.Below(3)) {
    case 0:
      return EdgePoint{t[i], t[j], distance};
    case 1:  // a corner
      point.weights[i] = distance * random.Uniform(0.2, 1);
      point.weights[j] = distance * random.Uniform(0.2, 1);
      break;
    default:  // an edge
      point.weights[i] = distance;
      point.weights[j] = random.Uniform(0.1, 0.9);
  }
  point.weights[k] = 1 - point.weights[i] - point.weights[j];
  return point;
}

std::vector<SurfacePoint> PointsBeside(const TriangleSoup& soup,
                                       const std::vector<uint32_t>& vertices,
                                       double weight) {
  std::vector<SurfacePoint> points;
  for (const uint32_t vertex : vertices) {
    for (const Place& place : PlacesOfVertex(soup, vertex)) {
      FacePoint point{place.face, {weight, weight, weight}};
      point.weights[CornerOf(soup.triangles[place.face], vertex)] =
          1 - 2 * weight;
      points.push_back(point);
    }
  }
  return points;
}

SurfacePoint RandomSurfacePoint(const TriangleSoup& soup, Random& random) {
  constexpr double kDistances[] = {1e-3, 1e-9, 1e-15, 1e-200};
  switch (random.Below(6)) {
    case 0:
      return RandomVertexPoint(soup, random);
    case 1:
      return RandomEdgePoint(soup, random);
    case 2:
      return RandomPointNearby(soup, kDistances[random.Below(4)], random);
    default:
      return RandomFacePoint(soup, random);
  }
}

std::vector<SurfacePoint> RandomNeighbours(const TriangleSoup& soup,
                                           const SurfacePoint& point,
                                           Random& random) {
  const std::vector<Place> places = PlacesOf(soup, point);
  const Place& place =
      places[random.Below(static_cast<uint32_t>(places.size()))];
  const Real step = std::pow(10, random.Uniform(-16, 0));
  FacePoint near{.face = place.face};
  for (int i = 0; i < 3; ++i) {
    near.weights[i] =
        static_cast<double>((1 - step) * place.weights[i] + step / 3);
  }
  std::vector<SurfacePoint> neighbours = {point, near};
  for (const uint32_t v : soup.triangles[place.face]) {
    neighbours.push_back(VertexPoint{v});
  }
  return neighbours;
}

std::vector<SurfacePoint> RandomCurve(const TriangleSoup& soup, uint32_t most,
                                      Random& random) {
  std::vector<SurfacePoint> points = {RandomSurfacePoint(soup, random)};
  const uint32_t count = 1 + random.Below(most);
  while (points.size() < count) {
    const std::vector<Place> places = PlacesOf(soup, points.back());
    const uint32_t face =
        places[random.Below(static_cast<uint32_t>(places.size()))].face;
    const Triangle& t = soup.triangles[face];
    const uint32_t side = random.Below(3), next = (side + 1) % 3;
    switch (random.Below(6)) {
      case 0:
        points.push_back(VertexPoint{t[side]});
        break;
      case 1:
        points.push_back(points[random.Below(
            static_cast<uint32_t>(points.size()))]);  // closed, or standing
        if (!HaveCommonFace(soup, points[points.size() - 2], points.back())) {
          points.pop_back();
        }
        break;
      case 2: {
        const double u = random.Uniform(0.02, 0.48);
        const double v = random.Uniform(0.02, 0.48);
        points.push_back(FacePoint{face, {u, v, 1 - u - v}});
        break;
      }
      default:
        points.push_back(
            EdgePoint{t[side], t[next], random.Uniform(0.02, 0.98)});
    }
  }
  return points;
}

}  // namespace geodesic::test
