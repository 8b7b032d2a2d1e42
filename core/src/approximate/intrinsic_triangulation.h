// A triangulation that knows the lengths of its edges and nothing of space:
// edges may be turned inside the surface, which stays as it is.
//
// Fisher, Springborn, Schroeder, Bobenko: An algorithm for the construction of
// intrinsic Delaunay triangulations with applications to digital geometry
// processing. Computing 81, 2007.
// Sharp, Crane: A Laplacian for nonmanifold triangle meshes. Computer Graphics
// Forum 39(5), 2020: mollification, and the tufted cover.

#ifndef GEODESIC_APPROXIMATE_INTRINSIC_TRIANGULATION_H_
#define GEODESIC_APPROXIMATE_INTRINSIC_TRIANGULATION_H_

#include <array>
#include <cstdint>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/checkpoint.h"
#include "geodesic/mesh.h"

namespace geodesic {

// Half-edge 3f + i runs from corner i of face f to corner i + 1 (Next and Prev
// of mesh.h hold). All lengths are positive and all areas too.
class IntrinsicTriangulation {
 public:
  // A face laid into the plane: corner 0 at (0, 0), corner 1 at (length, 0) and
  // corner 2 at (x, y), y > 0.
  struct Face {
    std::array<uint32_t, 3> corners;
    double length, x, y;
  };

  // The faces of the mesh. Where it has irregular edges they are those of its
  // tufted cover: each face is there twice, front and back, and the 2 k sides
  // at an edge of k faces are glued in pairs, so that every edge has two faces
  // and faces agree in orientation. Where a face is degenerate all edges are
  // made a little longer (kMollified). O(F).
  explicit IntrinsicTriangulation(const Mesh& mesh);

  // Turns edges until none is left whose opposite angles sum to more than pi
  // (but for rounding). Boundary edges stay. Errors: as `checkpoint`.
  absl::Status FlipToDelaunay(const Mesh& mesh, Checkpoint& checkpoint);

  uint32_t face_count() const {
    return static_cast<uint32_t>(corners_.size() / 3);
  }
  Face FaceAt(uint32_t face) const;
  // How often each face of the mesh is there: 1, or 2 in a tufted cover.
  uint32_t sheets() const { return sheets_; }
  uint64_t flips() const { return flips_; }
  uint64_t bytes() const {
    return corners_.capacity() * (2 * sizeof(uint32_t) + sizeof(double));
  }

 private:
  void AddFaces(const Mesh& mesh);
  void AddTuftedCover(const Mesh& mesh);
  void Mollify(double mean_length);
  // Of the angle opposite to h.
  double Cotangent(HalfEdge h) const;
  // Whether the angles opposite to h and its twin sum to more than pi.
  bool IsToTurn(HalfEdge h) const;
  // REQUIRES: h has a twin, in another face.
  void Turn(HalfEdge h);

  uint32_t sheets_ = 1;
  uint64_t flips_ = 0;
  std::vector<uint32_t> corners_;  // by half-edge: where it begins
  std::vector<HalfEdge> twins_;    // kNoHalfEdge at a boundary
  std::vector<double> lengths_;
};

}  // namespace geodesic

#endif  // GEODESIC_APPROXIMATE_INTRINSIC_TRIANGULATION_H_
