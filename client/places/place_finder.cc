#include "client/places/place_finder.h"

#include <type_traits>
#include <variant>

#include "client/places/nearest_point.h"

namespace geodesic::client {

template <typename Wanted>
absl::StatusOr<SurfacePoint> PlaceFinder::Search(const Wanted& wanted) {
  if (!mesh_.has_value()) {
    absl::StatusOr<MeshArrays> mesh = read_mesh_();
    if (!mesh.ok()) return mesh.status();
    mesh_ = *std::move(mesh);
  }
  return FindOnMesh(*mesh_, wanted);
}

absl::StatusOr<SurfacePoint> PlaceFinder::Find(const WrittenPoint& point) {
  return std::visit(
      [this](const auto& place) -> absl::StatusOr<SurfacePoint> {
        if constexpr (std::is_constructible_v<SurfacePoint, decltype(place)>) {
          return SurfacePoint(place);
        } else {
          return Search(place);
        }
      },
      point);
}

absl::StatusOr<Source> PlaceFinder::Find(const WrittenSource& source) {
  Curve curve;
  for (const WrittenPoint& written : source.points) {
    absl::StatusOr<SurfacePoint> point = Find(written);
    if (!point.ok()) return point.status();
    curve.points.push_back(*point);
  }
  Source found = {.offset = source.offset};
  if (source.is_curve) {
    found.place = std::move(curve);
  } else {
    found.place = curve.points.at(0);
  }
  return found;
}

absl::StatusOr<PointPair> PlaceFinder::Find(const WrittenPair& pair) {
  absl::StatusOr<SurfacePoint> source = Find(pair.source);
  if (!source.ok()) return source.status();
  absl::StatusOr<SurfacePoint> target = Find(pair.target);
  if (!target.ok()) return target.status();
  return PointPair{*source, *target};
}

}  // namespace geodesic::client
