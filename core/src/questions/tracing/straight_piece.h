// Following a shortest path back over its last straight piece.
//
// Xu et al. 2015, section 3.1, after Mitchell, Mount and Papadimitriou 1987: a
// shortest path crosses edges straight when the faces on both sides are laid
// into one plane, and bends at pseudo-sources only. A trace says where the
// pseudo-source lies when all faces of the piece are laid into the plane of the
// last one. So the piece is found again by laying one face after the other into
// the plane, from the last to the first.

#ifndef GEODESIC_QUESTIONS_TRACING_STRAIGHT_PIECE_H_
#define GEODESIC_QUESTIONS_TRACING_STRAIGHT_PIECE_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"
#include "questions/tracing/traced_field.h"
#include "solver/work_meter.h"
#include "surface/surface_location.h"
#include "tolerances.h"

namespace geodesic {

struct StraightPiece {
  // From the end (left out) back to the start: where edges are crossed, then
  // the start itself. Empty if end and start are one point.
  std::vector<SurfacePoint> points;
  double length = 0;  // in the scaled unit
  // Where it starts: a vertex, or an anchor if not TracedField::IsVertex. A
  // vertex need not be a pseudo-source, if the path goes straight on there.
  uint32_t start = kNoPseudoSource;
  // The direction in which it leaves the start, in the frame of that half-edge
  // of its first face; not normalized. kNoHalfEdge: along the edge from vertex
  // `start` to the end, which is a vertex too, or nowhere.
  HalfEdge frame = kNoHalfEdge;
  PlanePoint direction;
};

// The last straight piece of a shortest path to `end`. O(edges crossed + faces
// at those of several).
// Errors: INTERNAL: the trace does not lead back; the meter's.
absl::StatusOr<StraightPiece> FollowBack(const TracedField& field,
                                         const PathEnd& end, WorkMeter& meter);

// Where a walk may go on in several ways: how many there are, and which of them
// it takes.
struct Fork {
  uint32_t ways, taken;
};

// Walks from `end` towards its pseudo-source. Where the line runs into a vertex
// that it may not pass through, and where an edge has several faces beyond, it
// takes the ways that `forks` names, then the first of each, which it adds. It
// is led through vertices that it passes no farther than `nearness`, a fraction
// of its reach, if that makes it no longer. Nothing if it does not arrive, or
// the meter says stop. What is found need not be as long as the distances of
// its ends say, if this is not the way that the path came. O(edges crossed).
std::optional<StraightPiece> WalkBack(const TracedField& field,
                                      const PathEnd& end,
                                      std::vector<Fork>& forks,
                                      WorkMeter& meter,
                                      double nearness = kPassedVertex);

// Whether a point is a vertex at the place of another.
bool Coincide(const Mesh& mesh, const SurfacePoint& point, uint32_t vertex);

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_TRACING_STRAIGHT_PIECE_H_
