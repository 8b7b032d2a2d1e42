#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

#include "geodesic/landmarks.h"
#include "geodesic/target_search.h"
#include "tests/stress/answers.h"
#include "tests/stress/laws.h"
#include "tests/stress/path_check.h"
#include "tests/support/queries.h"
#include "tests/support/surface_points.h"

namespace geodesic::stress {
namespace {

using test::Random;

class PairLaws {
 public:
  PairLaws(const Scene& scene, Random& random, Report& report)
      : scene_(scene),
        random_(random),
        report_(report),
        search_(*scene.mesh),
        none_(*scene.mesh),
        some_(*scene.mesh) {
    NoCheckpoint checkpoint;
    absl::StatusOr<Landmarks> made = MakeLandmarks(
        *scene.mesh, random.Below(Landmarks::kMost + 1), {}, checkpoint);
    if (report.Check(made.ok(), "landmarks are made", made.status())) {
      some_ = *std::move(made);
    }
  }

  // From one point to some, and back.
  void CheckPairs() {
    const SurfacePoint from = DrawSource(random_.Below(2) == 0);
    const Query query{.sources = {{from}}, .targets = DrawTargets(from)};
    CheckSearches(query);
    std::vector<double> to, back;
    for (const SurfacePoint& target : query.targets) {
      to.push_back(Find({.sources = {{from}}, .targets = {target}}, some_)[0]);
      back.push_back(
          Find({.sources = {{target}}, .targets = {from}}, some_)[0]);
    }
    CheckEqual("d(p, q) = d(q, p) of searches", query, to, back,
               4 * scene_.rounding, report_, kPairTolerance);
  }

  // From several points with offsets, some of them just short of dominated by
  // those before.
  void CheckSources() {
    const bool at_vertices = random_.Below(3) > 0;
    Query query{.sources = {{DrawSource(at_vertices)}}};
    query.targets = DrawTargets(test::PointOf(query.sources[0]));
    const double farthest = test::FarthestOf(Find(query, none_));
    for (uint32_t i = 1 + random_.Below(3); i > 0; --i) {
      const SurfacePoint point = DrawSource(at_vertices);
      double offset = farthest * random_.Uniform(0, 1);
      if (random_.Below(2) == 0) {
        const double there =
            Find({.sources = query.sources, .targets = {point}}, none_)[0];
        if (std::isfinite(there)) offset = there * random_.Uniform(0.8, 1.01);
      }
      query.sources.push_back({point, offset});
    }
    CheckSearches(query);
  }

 private:
  SurfacePoint DrawSource(bool at_vertex) {
    return at_vertex ? test::RandomVertexPoint(scene_.soup, random_)
                     : DrawPoint(scene_, random_);
  }

  std::vector<SurfacePoint> DrawTargets(const SurfacePoint& source) {
    std::vector<SurfacePoint> targets = scene_.points;
    targets.push_back(test::RandomVertexPoint(scene_.soup, random_));
    const std::vector<SurfacePoint> beside =
        test::RandomNeighbours(scene_.soup, source, random_);
    targets.insert(targets.end(), beside.begin(), beside.end());
    return targets;
  }

  // Searches for all targets at once, and for each alone with landmarks and
  // without, against fields.
  void CheckSearches(const Query& query) {
    const std::vector<double> field = Field(query);
    if (field.empty()) return;
    std::vector<double> alone, with_landmarks;
    for (const SurfacePoint& target : query.targets) {
      const Query one{.sources = query.sources, .targets = {target}};
      alone.push_back(Find(one, none_)[0]);
      with_landmarks.push_back(Find(one, some_)[0]);
    }
    const auto check = [&](std::string_view law,
                           const std::vector<double>& found) {
      CheckEqual(law, query, field, found, 0, report_, kPairTolerance);
    };
    check("a search says what a field says", alone);
    check("landmarks change nothing", with_landmarks);
    check("targets are found together", Find(query, none_));
    check("targets are found together with landmarks", Find(query, some_));
    Query traced = query;
    traced.trace = true;
    CheckEqual("a trace changes nothing", query, Find(query, some_),
               Find(traced, some_), 0, report_, 0);
    CheckWithin(query, field);
    Query other = query;
    other.algorithm = DrawAlgorithm(scene_, random_);
    CheckEqual("a search says what fields of others say", other, Field(other),
               alone, 4 * scene_.rounding, report_, kPairTolerance);
  }

  // Within a tolerance searches find paths that are no longer than that.
  void CheckWithin(Query query, const std::vector<double>& shortest) {
    query.tolerance = std::pow(10, random_.Uniform(-6, -1));
    for (const bool has_landmarks : {false, true}) {
      const std::vector<double> found =
          Find(query, has_landmarks ? some_ : none_);
      for (size_t t = 0; t < found.size(); ++t) {
        const double least = shortest[t] * (1 - kPairTolerance);
        const double most = shortest[t] * (1 + query.tolerance);
        report_.Check(found[t] == shortest[t] ||
                          (found[t] >= least - 4 * scene_.rounding &&
                           found[t] <= most + 4 * scene_.rounding),
                      "a search ends within its tolerance", Name(query),
                      ", target ", t, ": ", found[t], " for ", shortest[t]);
      }
    }
  }

  // The distances of the targets. Empty, and reported, if the solver fails.
  std::vector<double> Field(const Query& query) {
    std::vector<double> all = AllDistances(*scene_.mesh, query, report_);
    if (all.empty()) return all;
    all.erase(all.begin(),
              all.end() - static_cast<std::ptrdiff_t>(query.targets.size()));
    return all;
  }

  // One distance for each target, in any case. Checks the paths of a query with
  // a trace.
  std::vector<double> Find(const Query& query, const Landmarks& landmarks) {
    NoCheckpoint checkpoint;
    const absl::StatusOr<TargetDistances> found =
        search_.Run(test::Valid(*scene_.mesh, query),
                    landmarks.count() == 0 ? nullptr : &landmarks, checkpoint);
    if (!report_.Check(found.ok(), "a search ends", found.status(), ", ",
                       Name(query))) {
      return std::vector<double>(query.targets.size());
    }
    for (size_t t = 0; t < found->paths.size(); ++t) {
      CheckPath(scene_, query, found->paths[t], query.targets[t],
                found->distances[t], report_);
    }
    return found->distances;
  }

  const Scene& scene_;
  Random& random_;
  Report& report_;
  TargetSearch search_;
  const Landmarks none_;
  Landmarks some_;
};

void CheckPairsOn(const Scene& scene, Random& random, Report& report) {
  if (scene.mesh == nullptr) return;
  const std::vector<AlgorithmInfo> fit = AlgorithmsFor(scene);
  if (std::ranges::find(fit, kDefaultAlgorithm, &AlgorithmInfo::algorithm) ==
      fit.end()) {
    return;
  }
  PairLaws laws(scene, random, report);
  for (int i = 0; i < 2; ++i) {
    laws.CheckPairs();
    laws.CheckSources();
  }
}

}  // namespace

void CheckPairLaws(const Scene& scene, Random& random, Report& report) {
  CheckPairsOn(scene, random, report);
  CheckPairsOn(DrawVariation(scene, random), random, report);
}

}  // namespace geodesic::stress
