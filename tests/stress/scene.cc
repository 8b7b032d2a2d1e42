#include "tests/stress/scene.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/meshes/developable_meshes.h"
#include "tests/support/meshes/mesh_edits.h"
#include "tests/support/meshes/needle_meshes.h"
#include "tests/support/meshes/planar_meshes.h"
#include "tests/support/meshes/polyhedra.h"
#include "tests/support/surface_points.h"

namespace geodesic::stress {
namespace {

using test::Random;

bool OneIn(uint32_t n, Random& random) { return random.Below(n) == 0; }

uint64_t DrawSeed(Random& random) { return random.Below(0xffffffffu); }

// `size` goes with the square root of the number of faces.
TriangleSoup DrawShape(uint32_t size, Random& random, std::string* name) {
  const auto about = [&](uint32_t n) { return n + random.Below(n + 1); };
  test::GridOptions grid{
      .columns = 3 + about(size),
      .rows = 3 + about(size),
      .cell_width = OneIn(2, random) ? 1 : random.Uniform(0.1, 2),
      .diagonals = static_cast<test::Diagonals>(random.Below(3)),
      .jitter = OneIn(2, random) ? 0 : random.Uniform(0, 0.24),
      .seed = DrawSeed(random)};
  switch (random.Below(10)) {
    case 0:
      *name = "grid";
      return test::MakeGrid(grid);
    case 1:
      *name = "domain";
      switch (random.Below(3)) {
        case 0:
          return test::MakeGrid(test::WithHole(grid));
        case 1:
          return test::MakeGrid(test::LShape(grid));
        default:
          return test::MakeGrid(test::UShape(grid));
      }
    case 2:
      *name = "plate";
      return test::MakePlate(
          OneIn(2, random) ? test::WithHole(grid) : test::UShape(grid),
          random.Uniform(0.05, 2));
    case 3:
      *name = "terrain";
      return test::Terrain(2 + about(size), 2 + about(size),
                           random.Uniform(0.1, 3), DrawSeed(random));
    case 4:
      *name = "torus";
      return test::Torus({.around = 3 + about(size),
                          .across = 3 + about(size),
                          .noise = OneIn(2, random) ? 0 : 0.3,
                          .seed = DrawSeed(random)});
    case 5:
      *name = "icosphere";
      return test::Icosphere(size < 6 ? random.Below(2) : size < 20 ? 2 : 3);
    case 6:
      *name = "sphere";
      return test::UvSphere(3 + about(size), 3 + about(size));
    case 7:
      *name = "box";
      return test::BoxGrid(1, random.Uniform(0.5, 2), random.Uniform(0.5, 3),
                           1 + random.Below(size), 1 + random.Below(size),
                           1 + random.Below(size));
    case 8:
      *name = "fan";
      return test::Fan({.spokes = 4 + 2 * random.Below(size),
                        .rings = 1 + random.Below(size),
                        .total_angle = random.Uniform(0.2, 12),
                        .closed = OneIn(2, random)})
          .soup();
    default:
      *name = "edited";
      return test::EditedMesh(DrawSeed(random), OneIn(3, random));
  }
}

void AddNoise(TriangleSoup& soup, double size, Random& random) {
  for (Point& p : soup.positions) {
    for (double& c : p) c += random.Uniform(-size, size);
  }
}

void Stretch(TriangleSoup& soup, double factor, uint32_t axis) {
  for (Point& p : soup.positions) p[axis] *= factor;
}

void MakeHoles(TriangleSoup& soup, uint32_t count, Random& random) {
  for (uint32_t i = 0; i < count && soup.triangles.size() > 2; ++i) {
    soup.triangles.erase(
        soup.triangles.begin() +
        random.Below(static_cast<uint32_t>(soup.triangles.size())));
  }
}

// A face that stands on an edge: its edges have three faces, or two.
void AddFin(TriangleSoup& soup, Random& random) {
  const Triangle t = soup.triangles[random.Below(
      static_cast<uint32_t>(soup.triangles.size()))];
  const uint32_t side = random.Below(3);
  const uint32_t a = t[side], b = t[(side + 1) % 3];
  Point tip = soup.positions[a];
  const double size =
      static_cast<double>(test::Distance(soup.positions[a], soup.positions[b]));
  for (double& c : tip) c += size * random.Uniform(-1, 1);
  soup.positions.push_back(tip);
  soup.triangles.push_back(
      {a, b, static_cast<uint32_t>(soup.positions.size() - 1)});
}

// Two vertices become one: surfaces touch, and edges may come to lie together.
void Pinch(TriangleSoup& soup, Random& random) {
  const uint32_t count = static_cast<uint32_t>(soup.positions.size());
  const uint32_t from = random.Below(count), to = random.Below(count);
  TriangleSoup pinched = soup;
  for (Triangle& t : pinched.triangles) {
    if (std::ranges::find(t, to) != t.end()) continue;
    std::ranges::replace(t, from, to);
  }
  soup = std::move(pinched);
}

// Returns by how much it was stretched or flattened: 1 if it was not.
double Edit(TriangleSoup& soup, uint32_t size, Random& random,
            std::string* name) {
  double stretched = 1;
  const auto apply = [&](uint32_t one_in, const char* what, auto edit) {
    if (!OneIn(one_in, random)) return;
    edit();
    *name += std::string(", ") + what;
  };
  if (size < 6) {  // their time goes with the square of the size
    apply(3, "turned edges", [&] {
      soup = test::FlipEdges(soup, 1 + random.Below(20), DrawSeed(random));
    });
    apply(6, "zero-area faces", [&] {
      soup = test::InsertZeroAreaFaces(soup, 1 + random.Below(4),
                                       DrawSeed(random));
    });
    apply(8, "doubled vertices", [&] {
      soup = test::DoubleVertices(soup, 1 + random.Below(2), DrawSeed(random));
    });
  }
  apply(4, "cut faces", [&] {
    soup = test::SplitFaces(soup, 1 + random.Below(9), DrawSeed(random));
  });
  apply(6, "needles", [&] {
    soup = test::InsertNeedles(soup, 1 + random.Below(5), DrawSeed(random));
  });
  apply(5, "noise",
        [&] { AddNoise(soup, std::pow(10, random.Uniform(-12, 0)), random); });
  apply(6, "stretched", [&] {
    const double power = random.Uniform(-6, 6);
    stretched = std::pow(10, std::abs(power));
    Stretch(soup, std::pow(10, power), random.Below(3));
  });
  apply(5, "holes", [&] { MakeHoles(soup, 1 + random.Below(5), random); });
  apply(6, "another component", [&] {
    std::string other;
    soup = test::Join(soup, DrawShape(2, random, &other));
  });
  apply(8, "pinched", [&] { Pinch(soup, random); });
  apply(6, "fins", [&] {
    for (uint32_t i = random.Below(4) + 1; i > 0; --i) AddFin(soup, random);
  });
  apply(12, "a face twice", [&] {
    soup.triangles.push_back(soup.triangles[random.Below(
        static_cast<uint32_t>(soup.triangles.size()))]);
  });
  apply(6, "turned faces", [&] {
    for (Triangle& t : soup.triangles) {
      if (OneIn(2, random)) std::swap(t[0], t[1]);
    }
  });
  apply(3, "moved",
        [&] { soup = test::RotateAndShift(soup, DrawSeed(random)); });
  apply(4, "relabelled",
        [&] { soup = test::Relabel(soup, DrawSeed(random)).soup; });
  apply(8, "scaled", [&] {
    soup = test::Scale(soup, std::pow(10, random.Uniform(-150, 150)));
  });
  // Drawn aside, so that scenes without one are what they were.
  Random aside = random;
  if (OneIn(6, aside)) {
    const uint64_t seed = DrawSeed(aside);
    const double lift = OneIn(3, aside) ? 0 : aside.Uniform(0, 1);
    const uint32_t faces =
        1 + aside.Below(static_cast<uint32_t>(soup.triangles.size()));
    soup = test::AddLayer(std::move(soup), faces, lift, seed);
    *name += ", a layer";
  }
  if (OneIn(12, aside)) {
    soup = test::AddBackFaces(std::move(soup));
    *name += ", two-sided";
  }
  return stretched;
}

// Lengths near the origin shrink with this power of the distance from it, those
// at `size` from it stay.
void DrawIn(TriangleSoup& soup, double size, double power) {
  for (Point& p : soup.positions) {
    const double factor =
        std::pow(std::hypot(p[0] / size, p[1] / size, p[2] / size), power);
    for (double& c : p) c *= factor;
  }
}

TriangleSoup DrawFlatSaddles(Random& random) {
  const double excess = std::pow(10, random.Uniform(-16, -2));
  switch (random.Below(3)) {
    case 0:
      return test::SaddleRow(1 + random.Below(40), excess, random.Below(8));
    case 1:
      return test::SaddleCluster(excess, 1 + random.Below(6),
                                 random.Uniform(1.5, 10));
    default:
      return test::HyperbolicGrid(4 + random.Below(8), 4 + random.Below(8),
                                  std::sqrt(excess));
  }
}

// Builds the mesh and draws points; the rest is there.
void Finish(Scene& scene, Random& random) {
  scene.description +=
      ", " + std::to_string(scene.soup.triangles.size()) + " faces";
  absl::StatusOr<std::shared_ptr<const Mesh>> mesh = Mesh::Build(scene.soup);
  if (!mesh.ok()) return;
  scene.mesh = *std::move(mesh);
  scene.rounding = test::CoordinateRounding(scene.soup.positions);
  for (int i = 0; i < 8; ++i) {
    scene.points.push_back(test::RandomSurfacePoint(scene.soup, random));
  }
  if (const auto* point = std::get_if<FacePoint>(&scene.points[0])) {
    scene.points.push_back(FacePoint{point->face, {0.25, 0.5, 0.25}});
  }
}

}  // namespace

Scene DrawScene(Random& random) {
  // Small ones are checked more thoroughly in less time.
  const uint32_t size = OneIn(30, random) ? 24 : OneIn(4, random) ? 8 : 3;
  Scene scene;
  scene.soup = DrawShape(size, random, &scene.description);
  scene.stretched =
      Edit(scene.soup,
           scene.soup.triangles.size() <= 500 ? std::min(size, 5u) : size,
           random, &scene.description);
  // Drawn aside, so that other scenes are what they were.
  Random aside = random;
  if (OneIn(10, aside)) {
    const bool is_book = OneIn(2, aside);
    scene.description = is_book ? "book of needles" : "rows of needles";
    scene.soup = is_book ? test::NeedleBook(aside) : test::NeedleRows(aside);
    scene.stretched = 1e12;
  }
  Finish(scene, random);
  return scene;
}

Scene DrawVariation(const Scene& scene, Random& random) {
  Scene varied{.description = scene.description + "; then",
               .soup = scene.soup,
               .stretched = scene.stretched};
  switch (random.Below(5)) {
    case 0: {
      varied.description += " far from the origin";
      const double far = scene.size() * std::pow(10, random.Uniform(0, 9));
      for (Point& p : varied.soup.positions) {
        for (uint32_t axis = 0; axis < 3; ++axis) p[axis] += far * (axis + 1);
      }
      break;
    }
    case 1:
      varied.description += " much smaller or larger";
      varied.soup = test::Scale(std::move(varied.soup),
                                OneIn(2, random) ? 1e-100 : 1e100);
      break;
    case 2:
      varied.description += " drawn in towards the origin";
      DrawIn(varied.soup, scene.size(), random.Uniform(1, 20));
      break;
    case 3:
      varied.description += " a strip";
      varied.stretched = 1;
      varied.soup = test::MakeGrid(
          {.columns = 30 + random.Below(60),
           .rows = 1 + random.Below(2),
           .cell_width = std::pow(10, random.Uniform(-3, 1)),
           .diagonals = static_cast<test::Diagonals>(random.Below(3)),
           .jitter = OneIn(2, random) ? 0 : random.Uniform(0, 0.24),
           .seed = DrawSeed(random)});
      break;
    default:
      varied.description += " flat saddles";
      varied.stretched = 1;
      varied.soup = DrawFlatSaddles(random);
  }
  Finish(varied, random);
  return varied;
}

std::vector<AlgorithmInfo> AlgorithmsFor(const Scene& scene) {
  // Beyond it the Chen-Han rule may make windows by the ten million
  // (docs/algorithm.md, "Guarantees and limits").
  constexpr double kMostStretched = 1e4;
  std::vector<AlgorithmInfo> fit;
  for (const AlgorithmInfo& info : kAlgorithms) {
    if (scene.stretched > kMostStretched &&
        WithTrimming(info.algorithm) != info.algorithm) {
      continue;
    }
    if (info.algorithm == Algorithm::kCh &&
        scene.soup.triangles.size() > 1000) {
      continue;
    }
    fit.push_back(info);
  }
  return fit;
}

Algorithm DrawAlgorithm(const Scene& scene, Random& random) {
  const std::vector<AlgorithmInfo> fit = AlgorithmsFor(scene);
  return fit[random.Below(static_cast<uint32_t>(fit.size()))].algorithm;
}

SurfacePoint DrawPoint(const Scene& scene, Random& random) {
  return scene.points[random.Below(static_cast<uint32_t>(scene.points.size()))];
}

Source DrawCurve(const Scene& scene, Random& random) {
  return {
      .place = Curve{test::RandomCurve(scene.soup, 5, random)},
      .offset = OneIn(2, random) ? 0 : scene.size() * random.Uniform(0, 0.3)};
}

std::string Name(const Query& query) {
  std::ostringstream text;
  text << AlgorithmName(query.algorithm);
  for (const Source& source : query.sources) {
    text << "; source " << test::Name(source);
  }
  return text.str();
}

}  // namespace geodesic::stress
