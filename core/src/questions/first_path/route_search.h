// A route between two places that is close to a shortest path: distances from
// vertex to vertex as in triangle unfolding, in the order of A*, and the way
// back along them.
//
// Hart, Nilsson, Raphael: A formal basis for the heuristic determination of
// minimum cost paths. IEEE Trans. SSC 4(2), 1968.

#ifndef GEODESIC_QUESTIONS_FIRST_PATH_ROUTE_SEARCH_H_
#define GEODESIC_QUESTIONS_FIRST_PATH_ROUTE_SEARCH_H_

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "absl/functional/function_ref.h"
#include "absl/status/status.h"
#include "geodesic/mesh.h"
#include "questions/first_path/place.h"
#include "solver/goal.h"
#include "solver/queues/binary_heap.h"
#include "surface/plane_point.h"

namespace geodesic {

// Where a route may begin, and the length it begins with, in the scaled unit.
struct RouteStart {
  Place place;
  double offset = 0;
};

// Over vertices. The last step is to the goal, or to a corner of its face.
struct Route {
  // To a vertex through half-edges, each into its face; through none along an
  // edge or within a face.
  struct Step {
    uint32_t to;
    uint32_t first = 0, last = 0;  // of portals
  };
  // Whether any way leads to the goal. If one does, there may be no steps
  // still: distances may be too far from the truth to be followed back.
  bool exists = false;
  uint32_t start = 0;  // its number
  std::vector<Step> steps;
  std::vector<HalfEdge> portals;
};

// Keeps its memory from one search to the next. For one thread.
class RouteSearch {
  // What is known of a vertex.
  struct Known {
    double distance = std::numeric_limits<double>::infinity();
    // The vertex before, if the way comes along an edge, or the half-edge
    // through which it comes.
    uint32_t from = Place::kNoVertex;
    HalfEdge across = kNoHalfEdge;
    uint32_t start = 0;  // from which the way is likely to come
    bool is_closed = false;
  };

 public:
  static constexpr uint64_t kBytesByVertex = sizeof(Known);

  // O(V) time and memory. The mesh outlives it.
  explicit RouteSearch(const Mesh& mesh);

  // Finds a route to the place that `goal` is aimed at. Polls now and then;
  // errors: whatever that returns.
  absl::Status Find(std::span<const RouteStart> starts, const Place& end,
                    const Goal& goal, absl::FunctionRef<absl::Status()> poll,
                    Route& route);

  uint64_t bytes() const;

 private:
  void Restart();
  template <typename Visit>
  void ForEachCorner(const Place& place, Visit visit) const;
  void Relax(uint32_t v, double distance, const Known& by, const Goal& goal);
  void RelaxApex(HalfEdge h, uint32_t start, const Goal& goal);
  void Expand(uint32_t v, const Goal& goal);

  std::optional<PlanePoint> SourceBelow(HalfEdge h) const;
  uint32_t NearestBy(uint32_t a, double to_a, uint32_t b, double to_b) const;
  uint32_t TraceAcross(HalfEdge h, const Place& start, Route& route) const;
  void TraceBack(uint32_t last, std::span<const RouteStart> starts,
                 Route& route) const;

  const Mesh& mesh_;
  double greed_ = 1;          // how many times bounds count
  std::vector<Known> known_;  // by vertex
  std::vector<uint32_t> touched_;
  BinaryHeap queue_{Tuning()};
};

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_FIRST_PATH_ROUTE_SEARCH_H_
