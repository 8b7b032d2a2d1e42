// Turns places as they are written into places that a server knows.

#ifndef GEODESIC_CLIENT_PLACES_PLACE_FINDER_H_
#define GEODESIC_CLIENT_PLACES_PLACE_FINDER_H_

#include <functional>
#include <optional>
#include <utility>

#include "absl/status/statusor.h"
#include "client/places/written_place.h"
#include "geodesic_client/mesh.h"
#include "geodesic_client/pairs.h"
#include "geodesic_types/places.h"

namespace geodesic::client {

// Finds places of one mesh. Not thread-safe.
class PlaceFinder {
 public:
  // `read_mesh` is called once, when the first place has to be looked for.
  explicit PlaceFinder(std::function<absl::StatusOr<MeshArrays>()> read_mesh)
      : read_mesh_(std::move(read_mesh)) {}

  // Errors: those of `read_mesh` and FindOnMesh.
  absl::StatusOr<SurfacePoint> Find(const WrittenPoint& point);
  absl::StatusOr<Source> Find(const WrittenSource& source);
  absl::StatusOr<PointPair> Find(const WrittenPair& pair);

 private:
  template <typename Wanted>
  absl::StatusOr<SurfacePoint> Search(const Wanted& wanted);

  std::function<absl::StatusOr<MeshArrays>()> read_mesh_;
  std::optional<MeshArrays> mesh_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PLACES_PLACE_FINDER_H_
