// Puts polylines together from the pieces they travel in.

#ifndef GEODESIC_CLIENT_POLYLINE_ASSEMBLER_H_
#define GEODESIC_CLIENT_POLYLINE_ASSEMBLER_H_

#include "absl/status/status.h"
#include "geodesic/v1/surface.pb.h"
#include "geodesic_client/polyline.h"

namespace geodesic::client {

// Takes one line after the other. Not thread-safe.
class PolylineAssembler {
 public:
  // Whether the next piece begins a line.
  bool complete() const { return due_ == 0; }

  // Appends a piece to `line`, which is empty where a line begins.
  // Errors: DATA_LOSS for a piece other than the one that is due.
  absl::Status Consume(const v1::PolylinePiece& piece, Polyline* line);

 private:
  // Points of the line that have not come.
  uint64_t due_ = 0;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_POLYLINE_ASSEMBLER_H_
