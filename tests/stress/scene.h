// A mesh drawn at random, with points to ask about.

#ifndef GEODESIC_TESTS_STRESS_SCENE_H_
#define GEODESIC_TESTS_STRESS_SCENE_H_

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "geodesic/mesh.h"
#include "geodesic/query.h"
#include "geodesic/surface_point.h"
#include "geodesic/triangle_soup.h"
#include "geodesic_types/algorithms.h"
#include "tests/support/random.h"

namespace geodesic::stress {

struct Scene {
  std::string description;  // how it was made
  TriangleSoup soup;
  std::shared_ptr<const Mesh> mesh;
  // At vertices, on edges and in faces, some very near others.
  std::vector<SurfacePoint> points;
  // What the rounding of coordinates is worth: lengths are known no better.
  double rounding = 0;

  // By how much one axis was stretched or flattened; 1 if it was not.
  double stretched = 1;

  // The largest coordinate.
  double size() const { return rounding * 0x1p52; }
  // Few enough faces for brute force.
  bool is_small() const { return soup.triangles.size() <= 150; }
};

// One of the shapes of tests/support, edited at random: turned edges, cut
// faces, needles, faces without area, noise, anisotropic scaling up to 1e6,
// holes, fins, turned faces, further components, scaling up to 1e150. Or rows
// or books of needles.
// What Mesh::Build refuses comes without a mesh.
Scene DrawScene(test::Random& random);

// The scene far from the origin, much smaller, much larger, or with ever
// shorter edges towards the origin; or a strip or flat saddles in its place.
Scene DrawVariation(const Scene& scene, test::Random& random);

// Of the algorithms that are quick enough for the scene.
Algorithm DrawAlgorithm(const Scene& scene, test::Random& random);
std::vector<AlgorithmInfo> AlgorithmsFor(const Scene& scene);

// A point of the scene; its vertices and edges are drawn anew.
SurfacePoint DrawPoint(const Scene& scene, test::Random& random);

// A polyline, with an offset within the size of the scene or none.
Source DrawCurve(const Scene& scene, test::Random& random);

// In words.
std::string Name(const Query& query);

}  // namespace geodesic::stress

#endif  // GEODESIC_TESTS_STRESS_SCENE_H_
