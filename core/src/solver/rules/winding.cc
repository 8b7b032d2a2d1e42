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

// Takes a line across `side`, given in the frame that an oriented neighbour
// has. False at a boundary, and where several faces lie beyond: a window does
// not tell which of them it came through.
bool Enter(const Mesh& mesh, HalfEdge side, const Origin& origin, double at,
           Line& line) {
  int faces = 0;
  mesh.ForEachBeyond(side, [&](HalfEdge half_edge, bool is_mirrored) {
    ++faces;
    const double length = mesh.frame(side).length;
    line = is_mirrored ? Line{half_edge, Mirror(origin, length), length - at}
                       : Line{half_edge, origin, at};
  });
  return faces == 1;
}

template <Side kSide>
bool Leave(const Mesh& mesh, const FaceSide<kSide>& side, double crossing,
           Line& line) {
  const Interval hit =
      side.InExit(side.Hit(line.origin, {line.at, line.at}, crossing));
  return Enter(mesh, side.half_edge, Unfold(side, line.origin), hit.begin,
               line);
}

bool CrossFace(const Mesh& mesh, Line& line) {
  const HalfEdge h = line.half_edge;
  const double crossing = CrossingTo(line.origin, ApexOf(mesh.frame(h)));
  return line.at < crossing
             ? Leave(mesh, FaceSide<kLeft>(mesh, h), crossing, line)
             : Leave(mesh, FaceSide<kRight>(mesh, h), crossing, line);
}

}  // namespace

bool ComesBack(const Mesh& mesh, HalfEdge h, const Window& window,
               uint64_t& followed) {
  const double middle = (window.interval.begin + window.interval.end) / 2;
  // Seen from beyond h, where A and B change places, as if it came from a point
  // that is as far on this side.
  const double length = mesh.frame(h).length;
  Line line;
  if (!Enter(mesh, h,
             Mirror(Origin{.x = 2 * middle - window.origin.x,
                           .depth = window.origin.depth},
                    length),
             length - middle, line)) {
    return false;
  }
  const HalfEdge back = line.half_edge;
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
