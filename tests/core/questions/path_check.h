// What makes a polyline on a mesh a shortest path of a known length.

#ifndef GEODESIC_TESTS_CORE_QUESTIONS_PATH_CHECK_H_
#define GEODESIC_TESTS_CORE_QUESTIONS_PATH_CHECK_H_

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <string>

#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "geodesic/path.h"
#include "geodesic/query.h"

namespace geodesic::test {

// The faces around a point, and whether two points have one in common.
std::set<uint32_t> FacesAt(const Mesh& mesh, const SurfacePoint& point);
bool ShareAFace(const Mesh& mesh, const SurfacePoint& a, const SurfacePoint& b);

// These throw, which fails the test, where the solver fails or the field does
// not answer the query with a trace.
DistanceField SolveTraced(const Mesh& mesh, const Query& query);
PathTracer TracerOf(const Mesh& mesh, const Query& query,
                    const DistanceField& field);

struct PathCheckOptions {
  // Beside kRelativeTolerance, for meshes with distances near the rounding of
  // their coordinates.
  double slack = 0;
  // Whether bends at edges and vertices are looked at. Where pieces are about
  // as short as rounding, nothing can be said about angles.
  bool check_bends = true;
};

// Whether `path` is one from `from` to `to` (canonical points) of length
// `length`:
//   1. its ends are those, and its positions are those of its points;
//   2. points that follow each other lie in a common face;
//   3. the lengths of its pieces sum to `length`, and so says the path;
//   4. it crosses edges straight, when the faces beside them are laid into one
//      plane;
//   5. at a vertex it bends only if the mesh says that shortest paths may, and
//      otherwise has an angle of pi on one side.
testing::AssertionResult IsShortestPath(const Mesh& mesh,
                                        const GeodesicPath& path,
                                        const SurfacePoint& from,
                                        const SurfacePoint& to, double length,
                                        const PathCheckOptions& options = {});

// Solves the query and checks the paths to every `stride`th vertex and to all
// targets.
void CheckAllPaths(const std::string& name, const Mesh& mesh, Query query,
                   const PathCheckOptions& options = {}, uint32_t stride = 1);

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_CORE_QUESTIONS_PATH_CHECK_H_
