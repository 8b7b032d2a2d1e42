// Polylines cut into pieces that fit a message.

#ifndef GEODESIC_SERVER_RPC_MESSAGES_POLYLINE_H_
#define GEODESIC_SERVER_RPC_MESSAGES_POLYLINE_H_

#include <cstdint>
#include <span>

#include "geodesic/surface_point.h"
#include "geodesic/v1/surface.pb.h"

namespace geodesic::server {

// Replaces `piece` by the points from `first` on, as many as a message takes;
// returns where the next piece begins. A polyline without points has one empty
// piece.
uint64_t SetPiece(std::span<const SurfacePoint> points,
                  std::span<const Point> positions, uint64_t first,
                  v1::PolylinePiece& piece);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_MESSAGES_POLYLINE_H_
