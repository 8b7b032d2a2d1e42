// stress_pairs: random pairs of points of mesh files. Searches without
// landmarks, with 4 and with 64, and the search back, are compared with whole
// fields of fwp-list and of another algorithm. Prints a line a mesh: the
// largest differences, and how many pairs have the same bits.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "geodesic/landmarks.h"
#include "geodesic/solve.h"
#include "geodesic/target_search.h"
#include "tests/stress/answers.h"
#include "tests/support/checkpoints.h"
#include "tests/support/queries.h"
#include "tests/support/random.h"
#include "tests/support/surface_points.h"
#include "tests/support/test_meshes.h"
#include "tests/support/vec.h"

namespace geodesic::stress {
namespace {

using test::Random;

struct Options {
  std::vector<std::string> files;
  uint32_t pairs = 1000;
  uint32_t targets = 25;
  double seconds = 300;
  uint64_t seed = 1;
  std::string algorithm{AlgorithmName(Algorithm::kFwpMmp)};
};

// Above what any mesh here takes.
constexpr uint64_t kMostWindows = 300'000'000;

// What a pair is found by, beside the search without landmarks.
enum Other { kField, kOtherField, kFewLandmarks, kMostLandmarks, kBack };
constexpr std::array<const char*, 5> kOthers = {
    "field", "other field", "4 landmarks", "64 landmarks", "back"};

// How far one of them is from the searches without landmarks.
struct Comparison {
  uint64_t same_bits = 0;
  double largest = 0;  // relative difference; of short ones only if wrong
  uint64_t wrong = 0;
};

struct Totals {
  uint64_t pairs = 0, unreachable = 0;
  std::array<Comparison, kOthers.size()> others;
};

class Subject {
 public:
  Subject(const TriangleSoup& soup, const Mesh& mesh, Algorithm other,
          Landmarks few, Landmarks most)
      : soup_(soup),
        mesh_(mesh),
        other_(other),
        rounding_(test::CoordinateRounding(soup.positions)),
        few_(std::move(few)),
        most_(std::move(most)),
        search_(mesh) {}

  absl::Status Measure(uint32_t targets, Random& random) {
    const SurfacePoint from = random.Below(2) == 0
                                  ? test::RandomVertexPoint(soup_, random)
                                  : test::RandomSurfacePoint(soup_, random);
    Query query{.sources = {{from}},
                .targets = test::RandomNeighbours(soup_, from, random)};
    while (query.targets.size() < targets) {
      query.targets.push_back(random.Below(2) == 0
                                  ? test::RandomVertexPoint(soup_, random)
                                  : test::RandomSurfacePoint(soup_, random));
    }
    const absl::StatusOr<DistanceField> field =
        Solve(mesh_, query, {}, patience_);
    if (!field.ok()) return field.status();
    query.algorithm = other_;
    const absl::StatusOr<DistanceField> other =
        Solve(mesh_, query, {}, patience_);
    if (!other.ok()) return other.status();
    for (size_t t = 0; t < query.targets.size(); ++t) {
      const SurfacePoint& to = query.targets[t];
      const double found = Find(from, to, nullptr);
      ++totals_.pairs;
      totals_.unreachable += std::isinf(found);
      Compare(kField, field->target_distances[t], found, from, to);
      Compare(kOtherField, other->target_distances[t], found, from, to);
      Compare(kFewLandmarks, Find(from, to, &few_), found, from, to);
      Compare(kMostLandmarks, Find(from, to, &most_), found, from, to);
      Compare(kBack, Find(to, from, nullptr), found, from, to);
    }
    return status_;
  }

  const Totals& totals() const { return totals_; }

 private:
  double Find(const SurfacePoint& from, const SurfacePoint& to,
              const Landmarks* landmarks) {
    const absl::StatusOr<TargetDistances> found =
        search_.Run(test::Valid(mesh_, {.sources = {{from}}, .targets = {to}}),
                    landmarks, patience_);
    if (found.ok()) return found->distances[0];
    status_.Update(found.status());
    return std::numeric_limits<double>::quiet_NaN();
  }

  void Compare(Other other, double expected, double found,
               const SurfacePoint& from, const SurfacePoint& to) {
    Comparison& comparison = totals_.others[other];
    if (expected == found) {  // infinite ones too
      ++comparison.same_bits;
      return;
    }
    const double apart = std::abs(found - expected);
    // Lengths are known no better than the rounding of coordinates.
    const bool is_near = apart <= kPairTolerance * expected + 4 * rounding_ &&
                         std::isfinite(expected);
    constexpr double kShort = 1e4;
    if (expected > kShort * rounding_ || !is_near) {
      comparison.largest = std::max(comparison.largest, apart / expected);
    }
    if (is_near) return;
    ++comparison.wrong;
    std::printf("WRONG from %s to %s: %.17g, by %s %.17g\n",
                test::Name(from).c_str(), test::Name(to).c_str(), found,
                kOthers[other], expected);
  }

  const TriangleSoup& soup_;
  const Mesh& mesh_;
  const Algorithm other_;
  const double rounding_;
  const Landmarks few_, most_;
  TargetSearch search_;
  test::WindowLimit patience_{kMostWindows};
  Totals totals_;
  absl::Status status_;
};

void Print(const std::string& name, uint32_t faces, const Totals& totals) {
  std::printf("%s, %u faces: %lu pairs, %lu unreachable", name.c_str(), faces,
              totals.pairs, totals.unreachable);
  for (size_t i = 0; i < kOthers.size(); ++i) {
    const Comparison& comparison = totals.others[i];
    std::printf("; %s: %lu same bits, largest difference %.1e, %lu wrong",
                kOthers[i], comparison.same_bits, comparison.largest,
                comparison.wrong);
  }
  std::printf("\n");
  std::fflush(stdout);
}

absl::StatusOr<Totals> MeasureFile(const std::string& file,
                                   const Options& options, Algorithm other) {
  const absl::StatusOr<TriangleSoup> soup = test::LoadTestMesh(file);
  if (!soup.ok()) return soup.status();
  const absl::StatusOr<std::shared_ptr<const Mesh>> mesh = Mesh::Build(*soup);
  if (!mesh.ok()) return mesh.status();
  test::WindowLimit patience(kMostWindows);
  absl::StatusOr<Landmarks> few = MakeLandmarks(**mesh, 4, {}, patience);
  if (!few.ok()) return few.status();
  absl::StatusOr<Landmarks> most =
      MakeLandmarks(**mesh, Landmarks::kMost, {}, patience);
  if (!most.ok()) return most.status();
  Subject subject(*soup, **mesh, other, *std::move(few), *std::move(most));
  Random random(options.seed);
  absl::Status status;
  const auto until = std::chrono::steady_clock::now() +
                     std::chrono::duration<double>(options.seconds);
  while (status.ok() && subject.totals().pairs < options.pairs &&
         std::chrono::steady_clock::now() < until) {
    status = subject.Measure(options.targets, random);
  }
  Print(file, (*mesh)->face_count(), subject.totals());
  if (!status.ok()) return status;
  return subject.totals();
}

int Run(const Options& options) {
  const absl::StatusOr<Algorithm> other = AlgorithmFromName(options.algorithm);
  Totals all;
  for (const std::string& file : options.files) {
    const absl::StatusOr<Totals> totals =
        MeasureFile(file, options, other.value());
    if (!totals.ok()) {
      std::cout << file << ": " << totals.status() << std::endl;
      continue;
    }
    all.pairs += totals->pairs;
    all.unreachable += totals->unreachable;
    for (size_t i = 0; i < kOthers.size(); ++i) {
      Comparison& sum = all.others[i];
      sum.same_bits += totals->others[i].same_bits;
      sum.wrong += totals->others[i].wrong;
      sum.largest = std::max(sum.largest, totals->others[i].largest);
    }
  }
  Print("all", 0, all);
  return std::ranges::all_of(all.others,
                             [](const Comparison& c) { return c.wrong == 0; })
             ? 0
             : 1;
}

}  // namespace
}  // namespace geodesic::stress

int main(int argc, char** argv) {
  CLI::App app{
      "Compares searches for random pairs of points with whole fields. Exits "
      "with 1 if a pair is wrong."};
  geodesic::stress::Options options;
  app.add_option("MESH_FILE", options.files, "OBJ, PLY, OFF or STL files")
      ->required();
  app.add_option("--pairs", options.pairs, "how many of each mesh")
      ->capture_default_str();
  app.add_option("--targets", options.targets, "how many from each source")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--seconds", options.seconds,
                 "go on to the next mesh after so long")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--seed", options.seed, "of the random points")
      ->capture_default_str();
  app.add_option("--algorithm", options.algorithm, "of the other field")
      ->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return geodesic::stress::Run(options);
}
