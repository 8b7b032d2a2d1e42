#include "tests/stress/answers.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "geodesic/solve.h"
#include "tests/support/checkpoints.h"
#include "tests/support/oracles/edge_paths.h"

namespace geodesic::stress {
namespace {

// Scenes have some thousands of faces at the most.
constexpr uint64_t kMostWindows = 20'000'000;

}  // namespace

std::vector<double> AllDistances(const Mesh& mesh, const Query& query,
                                 Report& report) {
  test::WindowLimit patience(kMostWindows);
  const absl::StatusOr<DistanceField> field = Solve(mesh, query, {}, patience);
  report.Check(field.ok(), "a valid query is answered", field.status(), ", ",
               Name(query));
  if (!field.ok()) return {};
  const std::optional<std::string> breach =
      test::BreachOfEdgeLaw(mesh, field->distances, kTolerance);
  report.Check(!breach.has_value(), "no vertex is farther than by an edge",
               breach.value_or(""), ", ", Name(query));
  return AllDistances(*field);
}

bool AreEqual(double expected, double got, double slack, double tolerance) {
  if (expected == got) return true;  // infinite ones too
  return std::isfinite(expected) &&
         std::abs(expected - got) <= tolerance * std::abs(expected) + slack;
}

void CheckEqual(std::string_view law, const Query& query,
                const std::vector<double>& expected,
                const std::vector<double>& got, double slack, Report& report,
                double tolerance) {
  if (!report.Check(expected.size() == got.size(), law, "sizes ",
                    expected.size(), " and ", got.size(), ", ", Name(query))) {
    return;
  }
  size_t wrong = 0, worst = 0;
  for (size_t i = 0; i < got.size(); ++i) {
    if (AreEqual(expected[i], got[i], slack, tolerance)) continue;
    ++wrong;
    if (std::abs(got[i] - expected[i]) >
        std::abs(got[worst] - expected[worst])) {
      worst = i;
    }
    if (wrong == 1) worst = i;
  }
  report.Check(wrong == 0, law, wrong, " of ", got.size(),
               " differ, the worst at ", worst, ": expected ", expected[worst],
               ", got ", got[worst], ", ", Name(query));
}

}  // namespace geodesic::stress
