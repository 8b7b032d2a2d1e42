// A route, drawn taut until it is a locally shortest path: it bends only at
// vertices around which neither side is less than half a turn.
//
// Where two straight pieces meet at a vertex with less than half a turn on one
// side, the strip of faces on that side holds a shorter path, which the funnel
// finds. FlipOut shortens at the same places, by flipping edges: Sharp, Crane:
// You can find geodesic paths in triangle meshes by just flipping edges. ACM
// TOG 39(6), 2020.

#ifndef GEODESIC_QUESTIONS_FIRST_PATH_TAUT_PATH_H_
#define GEODESIC_QUESTIONS_FIRST_PATH_TAUT_PATH_H_

#include <cstdint>
#include <span>
#include <vector>

#include "absl/functional/function_ref.h"
#include "absl/status/status.h"
#include "geodesic/mesh.h"
#include "questions/first_path/funnel.h"
#include "questions/first_path/place.h"
#include "questions/first_path/portal.h"
#include "questions/first_path/route_search.h"
#include "surface/plane_point.h"

namespace geodesic {

// For one thread; kept for its memory.
class TautPath {
 public:
  // A vertex at which the path bends, and how long it is up to there.
  struct Bend {
    uint32_t vertex;
    double before;
  };

  // The mesh outlives it.
  explicit TautPath(const Mesh& mesh) : mesh_(mesh) {}

  // Draws a route between two places taut. Polls now and then; errors: whatever
  // that returns. REQUIRES: the route has steps.
  absl::Status Draw(const Place& begin, const Route& route, const Place& end,
                    absl::FunctionRef<absl::Status()> poll);

  // Of the last Draw: the length in the scaled unit, which is that of a path on
  // the mesh but for rounding; infinite if the route cannot be followed.
  double length() const { return length_; }
  // Of the last Draw, in the order of the path.
  std::span<const Bend> bends() const { return bends_; }

  uint64_t bytes() const;

 private:
  // At a vertex: in the frame of a half-edge that leaves it, of any length.
  struct Direction {
    HalfEdge spoke = kNoHalfEdge;
    PlanePoint way;
  };
  // Straight through a strip of faces, or along an edge.
  struct Piece {
    Place begin, end;
    uint32_t first = 0, last = 0;  // of the portals
    // From its begin and from its end along it, where these are vertices.
    Direction leaves, arrives;
    double length = 0;
    // Nothing shorter leads from its begin to the end of the next piece.
    bool is_settled = false;
  };
  struct Line {
    std::vector<Piece> pieces;
    std::vector<Portal> portals;  // of all pieces

    void Clear();
    std::span<const Portal> PortalsOf(const Piece& piece) const;
    void Add(Piece piece, std::span<const Portal> through);
    double Length() const;
  };
  // What lies between two directions at a vertex: the second one as seen if the
  // first is the x axis, and the half-edges to go through.
  struct Side {
    PlanePoint turn;
    bool is_bent = false;  // by less than half a turn, not about half
    std::vector<HalfEdge> through;
  };

  // Pieces up to `last`, and whether the path bends where any two of them meet.
  struct Run {
    size_t last;
    bool is_bent = false;
  };

  bool Follow(const Place& begin, const Route& route, const Place& end);
  bool Tighten();
  Run RunFrom(size_t first);
  bool FindSmallerSide(const Piece& in, const Piece& out);
  template <bool kClockwise>
  bool Turn(const Direction& from, const Direction& to, Side& side) const;
  void Append(HalfEdge h);
  void Append(std::span<const Portal> portals);
  bool AddThroughStrip(const Place& begin, const Place& end, Line& line);
  void AddBends(const Place& begin, const Place& end, Line& line);
  bool SetWithinFace(Piece& piece) const;

  const Mesh& mesh_;
  Line line_, next_;
  double length_ = 0;
  std::vector<Bend> bends_;

  // Scratch.
  std::vector<Portal> strip_;
  Side left_, right_;
  Funnel funnel_;
};

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_FIRST_PATH_TAUT_PATH_H_
