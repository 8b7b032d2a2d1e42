#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "geodesic/computation.h"
#include "geodesic/solve.h"
#include "tests/stress/answers.h"
#include "tests/stress/laws.h"
#include "tests/support/queries.h"

namespace geodesic::stress {
namespace {

using test::Random;

// No distance may be farther from the exact one than is certified there.
void CheckCertificate(std::string_view law, const Scene& scene,
                      const Query& query, const DistanceField& field,
                      const std::vector<double>& exact, Report& report) {
  const std::vector<double> got = AllDistances(field);
  std::vector<float> errors = field.certified_errors;
  errors.insert(errors.end(), field.target_certified_errors.begin(),
                field.target_certified_errors.end());
  // Where windows cannot be merged the answer is exact. Otherwise what would
  // have been answered may be beyond the radius, where the truth is not.
  const double settled = errors.empty()
                             ? field.settled_radius
                             : field.settled_radius / (1 + query.tolerance);
  if (errors.empty()) errors.resize(got.size(), 0);
  const double slack = 4 * scene.rounding;
  report.Check(field.certified_error <= query.tolerance,
               "no more is certified than asked for", field.certified_error,
               ", ", Name(query));
  const auto holds = [&](size_t i) {
    if (std::isinf(got[i])) {
      return std::isinf(exact[i]) ||
             exact[i] > settled * (1 - kTolerance) - slack;
    }
    const double error = errors[i];
    return error <= field.certified_error &&
           AreEqual(exact[i], got[i], slack, std::max(error, kTolerance));
  };
  report.CheckAll(got.size(), holds, law, "tolerance ", query.tolerance,
                  ", settled radius ", field.settled_radius, ", ", Name(query));
}

}  // namespace

void CheckToleranceLaws(const Scene& scene, Random& random, Report& report) {
  Query query{.targets = scene.points};
  for (uint32_t i = random.Below(3) == 0 ? 3 : 1; i > 0; --i) {
    query.sources.push_back(
        {DrawPoint(scene, random),
         random.Below(4) == 0 ? random.Uniform(0, scene.size()) : 0});
  }
  const std::vector<double> exact = AllDistances(*scene.mesh, query, report);
  if (exact.empty()) return;
  query.tolerance = std::pow(10, random.Uniform(-5, -1));
  NoCheckpoint checkpoint;
  const std::unique_ptr<Computation> computation =
      StartComputation(*scene.mesh, test::Valid(*scene.mesh, query), {})
          .value();
  const double radius = test::FarthestOf(exact) * random.Uniform(0, 1);
  absl::Status status = computation->Advance({.radius = radius}, checkpoint);
  report.Check(status.ok(), "advancing succeeds", status, ", ", Name(query));
  DistanceField field = computation->Field();
  report.Check(field.settled_radius >= radius, "a radius is reached", radius,
               " wanted, ", field.settled_radius, " got, ", Name(query));
  CheckCertificate("the truth is within the bound up to the radius", scene,
                   query, field, exact, report);
  status = computation->Advance({}, checkpoint);
  report.Check(status.ok(), "a tolerance is met", status, ", ", Name(query));
  CheckCertificate("the truth is within the bound", scene, query,
                   computation->Field(), exact, report);
}

}  // namespace geodesic::stress
