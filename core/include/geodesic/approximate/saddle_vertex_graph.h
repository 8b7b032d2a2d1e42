// The saddle vertex graph: a graph on the vertices whose arcs are direct
// geodesics, those that pass no other vertex. Its shortest paths are nearly
// those of the surface.
//
//   auto graph = SaddleVertexGraph::Prepare(*mesh, {}, checkpoint);
//   absl::StatusOr<ApproximateField> field =
//       (*graph)->Distances(query, checkpoint);
//   SaddleGraphSearch search(**graph);
//   double distance = search.Distance(0, 99, &landmarks);
//
// Ying, Wang, He: Saddle vertex graph (SVG): a novel solution to the discrete
// geodesic problem. ACM TOG 32(6), 2013.

#ifndef GEODESIC_APPROXIMATE_SADDLE_VERTEX_GRAPH_H_
#define GEODESIC_APPROXIMATE_SADDLE_VERTEX_GRAPH_H_

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/approximate/prepared_method.h"
#include "geodesic/checkpoint.h"
#include "geodesic/landmarks.h"
#include "geodesic/mesh.h"

namespace geodesic {

// Whose windows find the arcs. The graph is the same up to rounding.
enum class SaddleGraphBuilder {
  kFwp,  // lists of windows in FWP buckets
  kIch,  // Chen-Han windows with the Xin-Wang filter in a heap: to compare
};

// Parameters of the graph.
struct SaddleGraphOptions {
  // K: how many vertices around each vertex are looked at; those among them
  // that are reached without passing another vertex become arcs. More are
  // slower to find and to ask, and nearer to exact. In [1, 10000]. DEFAULT: 50.
  uint32_t neighbours = MethodChoice().neighbours;
  // How many threads share the building, in [1, kMostSolveThreads]; the calling
  // thread is one of them. The graph is the same to the bit. DEFAULT: 1.
  uint32_t threads = 1;
  SaddleGraphBuilder builder = SaddleGraphBuilder::kFwp;
};

// Guarantees:
//   1. every distance is the length of a real path, to single precision: never
//      shorter than the exact one by more than 1e-7 of it;
//   2. none is longer than along the edges of the mesh, which are arcs too; so
//      +infinity exactly where no path leads;
//   3. distances between vertices are symmetric up to rounding.
//
// Sources are points, with offsets; one that is no vertex starts from the
// corners around it.
class SaddleVertexGraph final : public PreparedMethod {
 public:
  // The other end of an arc, and its length in the mesh's scaled unit.
  struct Arc {
    uint32_t to;
    float length;
  };

  // O(n K log K) or so; a vertex of very many faces opens all of them for each
  // of its neighbours. Progress::vertices_reached counts the vertices whose
  // arcs are found. Errors: INVALID_ARGUMENT for an option out of range, and
  // for meshes with faces without area or edges of three faces or more, which
  // lists of windows do not take; whatever `checkpoint` returns.
  static absl::StatusOr<std::shared_ptr<const SaddleVertexGraph>> Prepare(
      const Mesh& mesh, const SaddleGraphOptions& options,
      Checkpoint& checkpoint);

  // Errors: INVALID_ARGUMENT naming an option out of range (field_path.h).
  static absl::Status Check(const SaddleGraphOptions& options);

  // A graph whose offsets() and arcs() were kept, of an equal mesh.
  // Errors: DATA_LOSS if they are no graph on the mesh's vertices.
  static absl::StatusOr<std::shared_ptr<const SaddleVertexGraph>> FromArcs(
      const Mesh& mesh, std::vector<uint64_t> offsets, std::vector<Arc> arcs);

  ApproximateMethod method() const override;
  uint64_t bytes() const override;

  // Those of a vertex, in the order of their ends; each arc is there at both.
  std::span<const Arc> ArcsOf(uint32_t v) const {
    return {arcs_.data() + begin_[v], arcs_.data() + begin_[v + 1]};
  }
  uint64_t arc_count() const { return arcs_.size() / 2; }
  // All arcs, vertex by vertex, and where those of each vertex begin; the last
  // offset is their number.
  std::span<const Arc> arcs() const { return arcs_; }
  std::span<const uint64_t> offsets() const { return begin_; }

 private:
  // Dijkstra. O(arcs + n log n).
  absl::StatusOr<std::vector<double>> Compute(
      const ValidQuery& query, Checkpoint& checkpoint) const override;

  explicit SaddleVertexGraph(const Mesh& mesh) : PreparedMethod(mesh) {}
  // Errors: whatever `checkpoint` returns.
  absl::Status Join(const std::vector<std::vector<Arc>>& found,
                    Checkpoint& checkpoint);

  std::vector<uint64_t> begin_;  // V + 1
  std::vector<Arc> arcs_;
};

// Distances between two vertices, by a search that is directed at the target:
// by the straight line through space and by landmarks. Keeps its memory from
// one search to the next. Not thread-safe: one for each thread.
class SaddleGraphSearch {
 public:
  // O(V). The graph must outlive it.
  explicit SaddleGraphSearch(const SaddleVertexGraph& graph);

  // In the unit of the file; +infinity if no path leads. As far as the graph's
  // field says. `landmarks` may be null; they change the cost alone.
  // Errors: whatever `checkpoint` returns.
  // REQUIRES: the vertices are of the mesh. Cost: what the search covers.
  absl::StatusOr<double> Distance(uint32_t from, uint32_t to,
                                  const Landmarks* landmarks,
                                  Checkpoint& checkpoint);

  // How many vertices the last search has expanded.
  uint64_t expanded() const { return expanded_; }
  uint64_t bytes() const;

 private:
  struct State {
    double distance = std::numeric_limits<double>::infinity();
    double bound = 0;  // on the rest of the way; once it is reached
  };
  // A vertex that waits, by a lower bound on the ways through it.
  struct Waiting {
    double key;
    uint32_t vertex;
  };

  const SaddleVertexGraph& graph_;
  std::vector<State> states_;  // by vertex
  std::vector<uint32_t> reached_;
  std::vector<Waiting> waiting_;  // a heap
  uint64_t expanded_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_APPROXIMATE_SADDLE_VERTEX_GRAPH_H_
