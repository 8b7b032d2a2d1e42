// How far exact distances on a polyhedron are from those on the smooth surface
// whose points its vertices are.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "bench/paper/experiments.h"
#include "bench/paper/table.h"
#include "geodesic/mesh_summary.h"
#include "geodesic/solve.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/vec.h"

namespace geodesic::paper {
namespace {

std::vector<double> Field(const Mesh& mesh, Algorithm algorithm,
                          uint32_t source) {
  NoCheckpoint checkpoint;
  return Solve(mesh,
               {.sources = {{VertexPoint{source}}}, .algorithm = algorithm},
               kPaperOptions, checkpoint)
      .value()
      .distances;
}

// 1 / the mean of 1 / g over the faces, where the summary's anisotropy is the
// mean of g = P H / (2 sqrt(3) S). The paper's figure for its sphere is this.
double HarmonicAnisotropy(const Mesh& mesh) {
  double sum = 0;
  for (uint32_t f = 0; f < mesh.face_count(); ++f) {
    const Triangle& corners = mesh.triangle(f);
    test::Vec3 at[3];
    for (int i = 0; i < 3; ++i) {
      at[i] = test::ToVec3(mesh.positions()[corners[i]]);
    }
    test::Real perimeter = 0, longest = 0;
    for (int i = 0; i < 3; ++i) {
      const test::Real side = Norm(at[(i + 1) % 3] - at[i]);
      perimeter += side;
      longest = std::max(longest, side);
    }
    const test::Real area = Norm(Cross(at[1] - at[0], at[2] - at[0])) / 2;
    sum += static_cast<double>(2 * std::sqrt(3.0L) * area /
                               (perimeter / 2 * longest));
  }
  return static_cast<double>(mesh.face_count()) / sum;
}

class ErrorTable {
 public:
  // Compares `got` with `expected(vertex)` wherever that is not 0: as they are,
  // in parts of the farthest, and relative to each other after each was divided
  // by its own farthest, as the paper's figures are.
  void Add(const Subject& subject, uint32_t source, const std::string& what,
           const std::vector<double>& got,
           const std::function<double(uint32_t)>& expected) {
    double farthest = 0, sum = 0, most = 0, sum_absolute = 0, most_absolute = 0;
    for (uint32_t v = 0; v < got.size(); ++v) {
      const double distance = expected(v);
      if (distance == 0) continue;
      const double error = std::abs(got[v] - distance);
      farthest = std::max(farthest, distance);
      sum += error / distance;
      most = std::max(most, error / distance);
      sum_absolute += error;
      most_absolute = std::max(most_absolute, error);
    }
    const double count = static_cast<double>(got.size() - 1);
    const double scale = *std::ranges::max_element(got) / farthest;
    double sum_scaled = 0, most_scaled = 0;
    for (uint32_t v = 0; v < got.size(); ++v) {
      const double distance = scale * expected(v);
      if (distance == 0) continue;
      const double error = std::abs(got[v] - distance) / distance;
      sum_scaled += error;
      most_scaled = std::max(most_scaled, error);
    }
    table_.Add(subject.name, subject.mesh->face_count(),
               Summarize(*subject.mesh).anisotropy, source, what,
               100 * sum / count, 100 * most,
               100 * sum_absolute / count / farthest,
               100 * most_absolute / farthest, 100 * sum_scaled / count,
               100 * most_scaled, HarmonicAnisotropy(*subject.mesh));
  }

 private:
  Table table_{"mesh",
               "faces",
               "g",
               "source",
               "compared",
               "mean %",
               "max %",
               "mean % of farthest",
               "max % of farthest",
               "mean % scaled",
               "max % scaled",
               "harmonic g"};
};

void CompareSphere(const Setting& setting, ErrorTable& table) {
  const uint32_t meridians = setting.quick ? 20 : 200;
  const uint32_t bands = setting.quick ? 50 : 500;
  const TriangleSoup soup = test::UvSphere(meridians, bands);
  const Subject sphere = Generated("sphere", soup);
  // The pole, and the parallels at 45 degrees and at the equator.
  for (const uint32_t parallel : {0u, bands / 4, bands / 2}) {
    const uint32_t source = parallel == 0 ? 0 : 1 + (parallel - 1) * meridians;
    const auto great_circle = [&](uint32_t v) {
      const auto p = test::ToVec3(soup.positions[source]);
      const auto q = test::ToVec3(soup.positions[v]);
      return static_cast<double>(
          std::atan2(test::Norm(test::Cross(p, q)), test::Dot(p, q)));
    };
    const std::vector<double> field =
        Field(*sphere.mesh, Algorithm::kFwpMmp, source);
    table.Add(sphere, source, "fwp-mmp to great circle", field, great_circle);
    if (parallel != bands / 4) continue;
    const std::vector<double> other =
        Field(*sphere.mesh, Algorithm::kFwpCh, source);
    table.Add(sphere, source, "fwp-ch to fwp-mmp", other,
              [&](uint32_t v) { return field[v]; });
  }
}

void CompareTorus(const Setting& setting, ErrorTable& table) {
  // 20,000 faces and radii that make the harmonic g the paper's 2.36.
  const uint32_t steps = setting.quick ? 25 : 100;
  const test::TorusOptions shape = {
      .around = steps, .across = steps, .major_radius = 2.7512};
  const Subject torus = Generated("torus", test::Torus(shape));
  const std::vector<double> exact = Field(*torus.mesh, Algorithm::kFwpMmp, 0);
  for (const AlgorithmInfo& info : kAlgorithms) {
    if (info.algorithm == Algorithm::kFwpMmp) continue;
    table.Add(torus, 0, std::string(info.name) + " to fwp-mmp",
              Field(*torus.mesh, info.algorithm, 0),
              [&](uint32_t v) { return exact[v]; });
  }
  // No closed form: a finer polyhedron through the same points stands in for
  // the smooth torus.
  constexpr uint32_t kFiner = 4;
  test::TorusOptions finer = shape;
  finer.around = finer.across = kFiner * steps;
  const auto fine = *Mesh::Build(test::Torus(finer));
  const std::vector<double> smooth = Field(*fine, Algorithm::kFwpMmp, 0);
  table.Add(torus, 0, "fwp-mmp to 16 times the faces", exact, [&](uint32_t v) {
    const uint32_t i = v / steps, j = v % steps;
    return smooth[kFiner * (i * finer.across + j)];
  });
}

}  // namespace

void RunAccuracy(const Setting& setting) {
  ErrorTable table;
  CompareSphere(setting, table);
  CompareTorus(setting, table);
}

}  // namespace geodesic::paper
