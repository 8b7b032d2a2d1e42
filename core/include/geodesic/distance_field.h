// What a solver returns.

#ifndef GEODESIC_DISTANCE_FIELD_H_
#define GEODESIC_DISTANCE_FIELD_H_

#include <cstdint>
#include <limits>
#include <vector>

#include "geodesic/mesh.h"
#include "geodesic_types/algorithms.h"

namespace geodesic {

// Figures of merit, as the paper reports them (Xu et al. 2015, section 7).
struct SolveStatistics {
  // Batches taken from the queue; for a heap, one per window.
  uint64_t iterations = 0;
  // Windows that entered the wavefront, and how many of them were propagated.
  uint64_t windows_created = 0;
  uint64_t windows_propagated = 0;
  // The largest number of windows waiting in the queue, and the mean over
  // iterations.
  uint64_t peak_wavefront = 0;
  double mean_wavefront = 0;
  // The largest number of windows in memory (MMP keeps propagated ones for
  // trimming).
  uint64_t peak_windows = 0;
  uint64_t pseudo_source_events = 0;
  uint64_t peak_solver_bytes = 0;
  double solve_seconds = 0;
};

// Stands for the pseudo-source of what is not reached.
inline constexpr uint32_t kNoPseudoSource = 0xffffffffu;

// How a shortest path arrives at a point: its last straight piece, which starts
// at a pseudo-source and is unfolded into the plane of the last face.
struct Arrival {
  // A number below the vertex count V is a vertex, where the path may bend. Any
  // other number p is anchor p - V, a piece of a source (anchors.h).
  // kNoPseudoSource: nothing has arrived.
  uint32_t pseudo_source = kNoPseudoSource;
  // The half-edge through which the path enters its last face; kNoHalfEdge if
  // the pseudo-source lies in a face around the point.
  HalfEdge entry = kNoHalfEdge;
  // The pseudo-source is at (x, -depth) in the frame of `entry`, in the mesh's
  // scaled unit. If it is a segment of a curve, (x, depth) is instead the unit
  // vector along which the path runs.
  double x = 0;
  double depth = 0;
};

// Distances in the unit of the mesh's file. A distance that is not certified
// (see settled_radius) is +infinity.
struct DistanceField {
  // One per vertex; +infinity where no path from any source leads.
  std::vector<double> distances;
  // One per target of the query.
  std::vector<double> target_distances;
  // One per vertex and one per target, if the query had a tolerance and windows
  // were merged: the largest relative error that each distance may have; 0
  // where it is infinite.
  std::vector<float> certified_errors;
  std::vector<float> target_certified_errors;
  // One per vertex and one per target, if the query asked for a trace.
  std::vector<Arrival> arrivals;
  std::vector<Arrival> target_arrivals;
  // Every distance up to here is present, and exact or certified. With a
  // tolerance e that is every true distance up to settled_radius / (1 + e);
  // between the two, what is answered decides. +infinity once the whole surface
  // is done.
  double settled_radius = std::numeric_limits<double>::infinity();
  // The largest of these; 0 if distances are exact (solve.h, guarantee 1).
  double certified_error = 0;
  Algorithm algorithm = kDefaultAlgorithm;
  SolveStatistics statistics;
};

}  // namespace geodesic

#endif  // GEODESIC_DISTANCE_FIELD_H_
