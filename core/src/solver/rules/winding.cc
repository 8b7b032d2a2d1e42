#include "solver/rules/winding.h"

namespace geodesic {
namespace {

// Of a turn. Longer ones take so many windows each that there are few of them.
constexpr int kMostTurned = 1024;

// A line that enters a face through the point `at` of a half-edge, straight
// from the origin.
struct Line {
  HalfEdge half_edge;
  Origin origin;
  double at;
};

// Where it goes on. False at a boundary and at irregular edges.
template <Side kSide>
bool Leave(const FaceSide<kSide>& side, double crossing, Line& line) {
  if (side.exit >= kIrregularExit) return false;
  const Interval hit =
      side.InExit(side.Hit(line.origin, {line.at, line.at}, crossing));
  line = {side.exit, Unfold(side, line.origin), hit.begin};
  return true;
}

bool CrossFace(const Mesh& mesh, Line& line) {
  const HalfEdge h = line.half_edge;
  const double crossing = CrossingTo(line.origin, ApexOf(mesh.frame(h)));
  return line.at < crossing ? Leave(FaceSide<kLeft>(mesh, h), crossing, line)
                            : Leave(FaceSide<kRight>(mesh, h), crossing, line);
}

}  // namespace

bool ComesBack(const Mesh& mesh, HalfEdge h, const Window& window,
               uint64_t& followed) {
  const HalfEdge back = mesh.Twin(h);
  if (back == kNoHalfEdge) return false;
  const double middle = (window.interval.begin + window.interval.end) / 2;
  // Seen from beyond h, where A and B change places, as if it came from a point
  // that is as far on this side.
  const double length = mesh.frame(h).length;
  Line line{.half_edge = back,
            .origin = Mirror(Origin{.x = 2 * middle - window.origin.x,
                                    .depth = window.origin.depth},
                             length),
            .at = length - middle};
  const double way = 2 * window.origin.DistanceTo(middle);
  for (int turned = 0; turned < kMostTurned; ++turned) {
    ++followed;
    if (!CrossFace(mesh, line)) return false;
    if (line.origin.DistanceTo(line.at) >= way) return false;
    if (line.half_edge == back) return true;
  }
  return false;
}

}  // namespace geodesic
