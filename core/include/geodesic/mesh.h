// An immutable triangle mesh, packed for window propagation.
//
//   absl::StatusOr<std::shared_ptr<const Mesh>> mesh =
//       Mesh::Build(std::move(soup));
//
// A face has three half-edges in a row, 3k, 3k + 1 and 3k + 2, where 3k is
// FirstSide(face). Half-edge 3k + i runs from the face's corner i to its corner
// i + 1 (mod 3) and belongs to the face on its left. The other relations are
// arithmetic on that number, so connectivity is one array of twins. Half-edges
// are numbered along a space-filling curve: whatever the order of the faces,
// neighbours lie close together in memory, which makes propagation fast.
//
// Guarantees:
//   1. vertex and face numbers are the caller's; nothing is renumbered or
//      duplicated. A face that names a vertex twice keeps its number and is
//      left out of the surface; a vertex that was joined into another one
//      (join_seams.h) has no face, and its answers are the other's;
//   2. boundaries, holes, several components, isolated vertices, vertices where
//      surfaces touch, edges of three faces or more, faces that disagree in
//      orientation, zero-area faces and coincident vertices are ordinary input;
//   3. positions() holds the caller's bits.

#ifndef GEODESIC_MESH_H_
#define GEODESIC_MESH_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/triangle_soup.h"

namespace geodesic {

// The number of a half-edge, below 2^31; kNoHalfEdge where there is none.
using HalfEdge = uint32_t;
inline constexpr HalfEdge kNoHalfEdge = 0xffffffffu;

// What lies beyond a side of a face. If one face lies there and its half-edge
// runs the other way, as on an oriented manifold, it is that half-edge. Values
// from kIrregularExit on are kNoHalfEdge at a boundary, or stand for an
// irregular edge, whose faces Mesh::ForEachBeyond visits.
using Exit = uint32_t;
inline constexpr Exit kIrregularExit = 0x80000000u;

// The half-edges of the same face after and before h.
inline HalfEdge Next(HalfEdge h) { return h % 3 == 2 ? h - 2 : h + 1; }
inline HalfEdge Prev(HalfEdge h) { return h % 3 == 0 ? h + 2 : h - 1; }

// The face on the left of half-edge A -> B, laid into the plane with A at
// (0, 0), B at (length, 0) and the apex C above; and where its other two sides
// lead. It fills one cache line. Lengths are in the mesh's scaled unit (see
// Mesh::scale_exponent).
struct alignas(64) HalfEdgeFrame {
  double length;               // |AB|
  double apex_x, apex_y;       // C; apex_y >= 0
  double left_x, left_y;       // unit vector A -> C
  double right_x, right_y;     // unit vector B -> C
  Exit left_exit, right_exit;  // beyond C -> A and beyond B -> C
};
static_assert(sizeof(HalfEdgeFrame) == 64);

class Checkpoint;
class ConeAngles;

// See the head of this file.
class Mesh {
 public:
  // Checks the soup and builds the connectivity. O(V + F log F) time.
  // Errors: INVALID_ARGUMENT naming the first offender: no face, a coordinate
  // that is not finite, an index out of range, or no face with three vertices;
  // RESOURCE_EXHAUSTED for more faces or vertices than 32-bit numbers can name.
  static absl::StatusOr<std::shared_ptr<const Mesh>> Build(TriangleSoup soup);
  // The same, but asks `checkpoint` now and then. Errors: also whatever
  // `checkpoint` returns.
  static absl::StatusOr<std::shared_ptr<const Mesh>> Build(
      TriangleSoup soup, Checkpoint& checkpoint);

  // Upper bounds on what Build needs at its peak and on what stays resident,
  // for admission before any memory is taken.
  static uint64_t EstimateBuildBytes(uint64_t vertices, uint64_t faces);
  static uint64_t EstimateResidentBytes(uint64_t vertices, uint64_t faces);

  Mesh(const Mesh&) = delete;
  Mesh& operator=(const Mesh&) = delete;

  uint32_t vertex_count() const { return positions_.size(); }
  uint32_t face_count() const { return triangles_.size(); }
  // Of the faces that are not left out.
  uint32_t half_edge_count() const { return half_edge_count_; }

  std::span<const Point> positions() const { return positions_; }
  const Triangle& triangle(uint32_t face) const {
    return triangles_[slots_[face]];
  }
  // The same as the caller named them, before any were joined.
  const Triangle& NamedTriangle(uint32_t face) const {
    return named_.empty() ? triangle(face) : named_[face];
  }

  // Whether the face names a vertex twice, and so is no part of the surface.
  bool IsLeftOut(uint32_t face) const {
    return 3 * slots_[face] >= half_edge_count_;
  }
  uint32_t left_out_face_count() const {
    return face_count() - half_edge_count_ / 3;
  }

  // What was joined before; see triangle_soup.h.
  const Reading& reading() const { return reading_; }
  // The vertex that `v` was joined into, or `v`. O(log joined vertices).
  uint32_t JoinedInto(uint32_t v) const;
  // Gives vertices that were joined the values of those they were joined into.
  template <typename T>
  void SpreadToJoined(std::vector<T>& by_vertex) const {
    for (const auto& [vertex, into] : reading_.joined) {
      by_vertex[vertex] = by_vertex[into];
    }
  }

  // REQUIRES: the face is not left out.
  HalfEdge FirstSide(uint32_t face) const { return 3 * slots_[face]; }
  // The face on the left of h, and its corners.
  uint32_t FaceOf(HalfEdge h) const { return faces_[h / 3]; }
  const Triangle& TriangleOf(HalfEdge h) const { return triangles_[h / 3]; }

  // The half-edge on the other side of h if one face lies there that runs the
  // other way; kNoHalfEdge at a boundary and at irregular edges. O(1).
  HalfEdge Twin(HalfEdge h) const {
    return Beyond(h) < kIrregularExit ? Beyond(h) : kNoHalfEdge;
  }
  bool IsBoundaryEdge(HalfEdge h) const { return Beyond(h) == kNoHalfEdge; }
  // Whether the edge of h has three faces or more, or two that run along it in
  // the same direction.
  bool IsIrregularEdge(HalfEdge h) const {
    return Beyond(h) >= kIrregularExit && Beyond(h) != kNoHalfEdge;
  }
  // All half-edges at an irregular edge, h among them, in order of their
  // numbers; none at other edges.
  std::span<const HalfEdge> HalfEdgesAt(HalfEdge h) const {
    return IsIrregularEdge(h) ? IrregularEdgeAt(Beyond(h))
                              : std::span<const HalfEdge>();
  }
  // Whether the edge of h has three faces or more.
  bool IsNonManifoldEdge(HalfEdge h) const { return HalfEdgesAt(h).size() > 2; }
  // The lowest half-edge at the edge of h.
  HalfEdge FirstOfEdge(HalfEdge h) const {
    return IsIrregularEdge(h) ? HalfEdgesAt(h)[0] : std::min(h, Beyond(h));
  }
  bool HasIrregularEdges() const { return !irregular_half_edges_.empty(); }
  bool HasNonManifoldEdges() const {
    return HasIrregularEdges() &&
           irregular_half_edges_.size() > 2 * (irregular_begin_.size() - 1);
  }

  // Two at the least. O(irregular edges).
  uint32_t MostFacesAtEdge() const;

  // Calls visit(half_edge, is_mirrored) for the half-edge of every other face
  // at the edge of h, in order of their numbers. A mirrored one runs in the
  // same direction as h: seen from h's face, its frame is turned over.
  template <typename Visit>
  void ForEachBeyond(HalfEdge h, Visit visit) const {
    if (Beyond(h) < kIrregularExit) {
      visit(Beyond(h), false);
    } else if (!IsBoundaryEdge(h)) {
      for (HalfEdge other : IrregularEdgeAt(Beyond(h))) {
        if (other != h) visit(other, From(other) == From(h));
      }
    }
  }

  // Whether a face that comes before that of h has the same corners, and so the
  // same three edges. Found only where edges are irregular.
  bool IsCopy(HalfEdge h) const { return !copies_.empty() && copies_[h / 3]; }
  bool HasCopies() const { return !copies_.empty(); }

  // The ends of h, the corner opposite, and its unfolded face.
  uint32_t From(HalfEdge h) const { return TriangleOf(h)[h % 3]; }
  uint32_t To(HalfEdge h) const { return From(Next(h)); }
  uint32_t Apex(HalfEdge h) const { return From(Prev(h)); }
  const HalfEdgeFrame& frame(HalfEdge h) const { return frames_[h]; }

  // The half-edges that leave vertex v, one per incident face, in order of
  // faces.
  std::span<const HalfEdge> Outgoing(uint32_t v) const {
    return {outgoing_.data() + outgoing_begin_[v],
            outgoing_.data() + outgoing_begin_[v + 1]};
  }

  // Whether shortest paths may bend at v: a saddle (cone angle above 2 pi), a
  // reflex corner of the boundary (angle above pi), or a vertex where the
  // surface pinches, three faces or more meet in an edge, or a face has hardly
  // any area.
  bool IsPseudoSource(uint32_t v) const { return kinds_[v] & kPseudoSource; }
  bool IsSaddle(uint32_t v) const { return kinds_[v] & kSaddle; }
  bool IsBoundary(uint32_t v) const { return kinds_[v] & kBoundary; }
  // Whether the faces around v form more than one fan, or three or more of them
  // share an edge there.
  bool IsNonManifold(uint32_t v) const { return kinds_[v] & kNonManifold; }

  // Whether the face of h has no area to speak of, and whether there is such a
  // face.
  bool IsCollapsed(HalfEdge h) const;
  bool HasCollapsedFaces() const { return has_collapsed_faces_; }
  // Whether there is a face so thin that windows may miss a vertex beside it.
  bool HasThinFaces() const { return has_thin_faces_; }
  // Of the face of h, in the scaled unit.
  double LongestSide(HalfEdge h) const {
    const HalfEdgeFrame* sides = &frames_[h - h % 3];
    return std::max({sides[0].length, sides[1].length, sides[2].length});
  }

  // Solver lengths are file lengths times 2^-scale_exponent, so that the
  // longest extent of the mesh is about 1 and no square overflows.
  int scale_exponent() const { return scale_exponent_; }

  // Mean over all edges (a boundary edge counts once), in the scaled unit.
  double mean_edge_length() const { return mean_edge_length_; }

  // Bytes held by this object.
  uint64_t resident_bytes() const;

 private:
  enum VertexKind : uint8_t {
    kPseudoSource = 1,
    kSaddle = 2,
    kBoundary = 4,
    kNonManifold = 8,
  };

  Mesh(TriangleSoup soup, std::vector<Triangle> named);
  Exit Beyond(HalfEdge h) const { return frames_[Next(h)].left_exit; }
  // The half-edges at an irregular edge, in order.
  std::span<const HalfEdge> IrregularEdgeAt(Exit exit) const {
    const uint32_t i = exit - kIrregularExit;
    return {irregular_half_edges_.data() + irregular_begin_[i],
            irregular_half_edges_.data() + irregular_begin_[i + 1]};
  }
  // Errors: whatever `checkpoint` returns.
  absl::Status BuildFrames(std::span<const Exit> exits, ConeAngles& angles,
                           Checkpoint& checkpoint);
  // Marks them. O(faces at irregular edges, times the logarithm of their
  // number).
  void FindCopies();
  void BuildOutgoing(const TriangleSoup& soup);
  // Whether the face of h is no higher than this part of its longest edge.
  bool IsThinner(HalfEdge h, double part) const;
  // Whether the faces around v form one fan, closed or open.
  bool IsDisk(uint32_t v) const;
  void ClassifyVertices(std::span<const uint8_t> is_closed_fan,
                        const ConeAngles& angles);

  Reading reading_;
  std::vector<Triangle> named_;  // by face; empty if no vertex was joined
  uint32_t half_edge_count_ = 0;
  std::vector<Point> positions_;
  std::vector<uint32_t> faces_;                 // face in each slot
  std::vector<uint32_t> slots_;                 // slot of each face
  std::vector<Triangle> triangles_;             // by slot
  std::unique_ptr<HalfEdgeFrame[]> frames_;     // one per half-edge
  std::vector<uint32_t> outgoing_begin_;        // V + 1
  std::vector<HalfEdge> outgoing_;              // 3F
  std::vector<uint8_t> kinds_;                  // V, VertexKind bits
  std::vector<uint32_t> irregular_begin_;       // irregular edges + 1, if any
  std::vector<HalfEdge> irregular_half_edges_;  // their half-edges
  std::vector<bool> copies_;                    // by slot; empty without any
  bool has_collapsed_faces_ = false;
  bool has_thin_faces_ = false;
  int scale_exponent_ = 0;
  double mean_edge_length_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_MESH_H_
