#include "server/rpc/messages/polyline.h"

#include <algorithm>

#include "server/rpc/messages/surface_translation.h"
#include "server/rpc/messages/value_bytes.h"

namespace geodesic::server {
namespace {

// A point takes about 50 bytes on the wire.
constexpr uint64_t kPointsPerMessage = 8192;

static_assert(sizeof(Point) == 3 * sizeof(double));

}  // namespace

uint64_t SetPiece(std::span<const SurfacePoint> points,
                  std::span<const Point> positions, uint64_t first,
                  v1::PolylinePiece& piece) {
  const uint64_t count =
      std::min<uint64_t>(kPointsPerMessage, points.size() - first);
  piece.set_point_count(points.size());
  piece.set_first_point(first);
  piece.clear_points();
  for (const SurfacePoint& point : points.subspan(first, count)) {
    SetSurfacePoint(point, *piece.add_points());
  }
  SetBytes(positions.subspan(first, count), *piece.mutable_positions());
  return first + count;
}

}  // namespace geodesic::server
