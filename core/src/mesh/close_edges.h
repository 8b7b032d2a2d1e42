// Edges that lie close to each other, end by end.

#ifndef GEODESIC_MESH_CLOSE_EDGES_H_
#define GEODESIC_MESH_CLOSE_EDGES_H_

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/triangle_soup.h"
#include "mesh/boundary_edges.h"

namespace geodesic {

double Distance(const Point& a, const Point& b);

// How far apart the ends of two edges may be.
struct Closeness {
  double distance = 0;
  // Of the length of the shorter edge, at the most.
  double part = 0;
};

struct ClosePair {
  uint32_t first = 0;  // numbers of edges
  uint32_t second = 0;
  // Whether the low end of one is at the high end of the other.
  bool is_turned = false;
  double distance = 0;  // between the ends that are farther apart
};

// Edges in a grid of cubes by their middles.
class CloseEdges {
 public:
  // Both must outlive it. O(edges). Errors: whatever `checkpoint` returns.
  static absl::StatusOr<CloseEdges> Make(std::span<const Point> positions,
                                         std::span<const VertexPair> edges,
                                         const Closeness& closeness,
                                         Checkpoint& checkpoint);

  // Appends the pairs of `edge` and another one, among the `most` edges that
  // are looked at first. O(8 + edges in the cubes around it). Errors: whatever
  // `checkpoint` returns.
  absl::Status Find(uint32_t edge, Checkpoint& checkpoint,
                    std::vector<ClosePair>& pairs,
                    uint32_t most = std::numeric_limits<uint32_t>::max());

 private:
  CloseEdges(std::span<const Point> positions,
             std::span<const VertexPair> edges, const Closeness& closeness)
      : positions_(positions), edges_(edges), closeness_(closeness) {}

  // Finds out how large cubes are, and what lies in each.
  absl::Status Measure(Checkpoint& checkpoint);
  absl::Status Sort(Checkpoint& checkpoint);
  Point Middle(const VertexPair& edge) const;
  Point CubeOf(const Point& point) const;
  // Appends the pair, if they are close.
  void Compare(uint32_t edge, uint32_t other, std::vector<ClosePair>& pairs);

  std::span<const Point> positions_;
  std::span<const VertexPair> edges_;
  Closeness closeness_;
  double reach_ = 0;  // between middles of close edges
  double side_ = 0;   // of a cube
  // The last edge in each cube, and the one before each.
  absl::flat_hash_map<Point, uint32_t> last_;
  std::vector<uint32_t> before_;
  uint64_t compared_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_MESH_CLOSE_EDGES_H_
