#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/computation.h"
#include "geodesic/settled_vertices.h"
#include "tests/stress/answers.h"
#include "tests/stress/laws.h"
#include "tests/support/queries.h"

namespace geodesic::stress {
namespace {

using test::Random;

// A distance that was certified may improve by roundings, no more.
constexpr double kRoundings = 1e-12;

// Collects what settles; says stop at one poll.
class Watcher final : public Checkpoint {
 public:
  Watcher(const Mesh& mesh, uint64_t stop_at)
      : stop_at_(stop_at), settled_(mesh) {}

  absl::Status Poll(const Progress& progress) override {
    is_monotone_ = is_monotone_ && progress.settled_radius >= radius_;
    radius_ = progress.settled_radius;
    for (const SettledVertex& vertex : settled_.Collect(progress)) {
      vertices_.push_back(vertex);
    }
    return polls_++ == stop_at_ ? absl::CancelledError("stop")
                                : absl::OkStatus();
  }

  const std::vector<SettledVertex>& vertices() const { return vertices_; }
  bool is_monotone() const { return is_monotone_; }
  double radius() const { return radius_; }
  uint64_t polls() const { return polls_; }

 private:
  const uint64_t stop_at_;
  uint64_t polls_ = 0;
  double radius_ = 0;
  bool is_monotone_ = true;
  SettledVertices settled_;
  std::vector<SettledVertex> vertices_;
};

std::unique_ptr<Computation> Start(const Scene& scene, const Query& query) {
  return StartComputation(*scene.mesh, test::Valid(*scene.mesh, query), {})
      .value();
}

// A limited field against the full one: present up to its radius and equal,
// absent beyond it.
void CheckLimited(std::string_view law, const Query& query,
                  const DistanceField& limited, const std::vector<double>& full,
                  Report& report) {
  const std::vector<double> got = AllDistances(limited);
  const double radius = limited.settled_radius;
  const auto holds = [&](size_t i) {
    if (got.size() != full.size()) return false;
    if (std::isinf(got[i])) {
      return std::isinf(full[i]) || full[i] >= radius * (1 - kRoundings);
    }
    return full[i] <= radius * (1 + kRoundings) &&
           std::abs(got[i] - full[i]) <= kRoundings * full[i];
  };
  report.CheckAll(full.size(), holds, law, "settled radius ", radius, ", ",
                  Name(query));
}

void CheckRadii(const Scene& scene, const Query& query,
                const std::vector<double>& full, Random& random,
                Report& report) {
  const std::unique_ptr<Computation> computation = Start(scene, query);
  std::vector<double> radii;
  radii.reserve(4);
  for (int i = 0; i < 3; ++i) {
    radii.push_back(test::FarthestOf(full) * random.Uniform(0, 1));
  }
  // A distance that occurs, so that ties lie on the radius.
  const double one = full[random.Below(static_cast<uint32_t>(full.size()))];
  if (!std::isinf(one)) radii.push_back(one);
  std::ranges::sort(radii);
  NoCheckpoint checkpoint;
  for (const double radius : radii) {
    const absl::Status status =
        computation->Advance({.radius = radius}, checkpoint);
    report.Check(status.ok(), "advancing succeeds", status);
    const DistanceField field = computation->Field();
    report.Check(field.settled_radius >= radius, "a radius is reached", radius,
                 " wanted, ", field.settled_radius, " got, ", Name(query));
    CheckLimited("limited = full up to the radius", query, field, full, report);
  }
  const absl::Status status = computation->Advance({}, checkpoint);
  report.Check(status.ok(), "advancing succeeds", status);
  const DistanceField field = computation->Field();
  report.Check(std::isinf(field.settled_radius), "done is done",
               field.settled_radius, ", ", Name(query));
  CheckLimited("step by step = one go", query, field, full, report);
}

void CheckTargets(const Scene& scene, const Query& query,
                  const std::vector<double>& full, Random& random,
                  Report& report) {
  const std::unique_ptr<Computation> computation = Start(scene, query);
  const uint64_t wanted =
      random.Below(static_cast<uint32_t>(query.targets.size() + 1));
  NoCheckpoint checkpoint;
  const absl::Status status =
      computation->Advance({.targets = wanted}, checkpoint);
  report.Check(status.ok(), "advancing succeeds", status);
  const DistanceField field = computation->Field();
  uint64_t certified = 0;
  for (const double d : field.target_distances) certified += !std::isinf(d);
  report.Check(certified >= wanted || std::isinf(field.settled_radius),
               "wanted targets are certified", certified, " of ", wanted, ", ",
               Name(query));
  CheckLimited("limited by targets = full", query, field, full, report);
}

void CheckCancelling(const Scene& scene, const Query& query,
                     const std::vector<double>& full, Random& random,
                     Report& report) {
  const std::unique_ptr<Computation> computation = Start(scene, query);
  Watcher watcher(*scene.mesh, random.Below(4));
  const absl::Status status = computation->Advance({}, watcher);
  report.Check(absl::IsCancelled(status) || status.ok(), "cancelling cancels",
               status);
  const DistanceField field = computation->Field();
  CheckLimited("cancelled = full where finite", query, field, full, report);
  report.Check(field.settled_radius >= watcher.radius(),
               "what was settled stays so after a cancel", watcher.radius(),
               " told, ", field.settled_radius, " given, ", Name(query));
  Watcher onward(*scene.mesh, std::numeric_limits<uint64_t>::max());
  const absl::Status rest = computation->Advance({}, onward);
  report.Check(rest.ok(), "a cancelled computation goes on", rest);
  CheckLimited("cancelled and gone on = full", query, computation->Field(),
               full, report);
}

void CheckSettling(const Scene& scene, const Query& query,
                   const std::vector<double>& full, Report& report) {
  const std::unique_ptr<Computation> computation = Start(scene, query);
  Watcher watcher(*scene.mesh, std::numeric_limits<uint64_t>::max());
  const absl::Status status = computation->Advance({}, watcher);
  report.Check(status.ok(), "advancing succeeds", status);
  report.Check(watcher.is_monotone(), "the settled radius grows", Name(query));
  const std::vector<SettledVertex>& settled = watcher.vertices();
  std::set<uint32_t> seen;
  for (const SettledVertex& vertex : settled) seen.insert(vertex.vertex);
  report.CheckAll(
      settled.size(),
      [&](size_t i) {
        return i == 0 || settled[i].distance >=
                             settled[i - 1].distance * (1 - kRoundings);
      },
      "vertices settle in order", Name(query));
  report.CheckAll(
      settled.size(),
      [&](size_t i) {
        const double final = full[settled[i].vertex];
        return std::abs(settled[i].distance - final) <= kRoundings * final;
      },
      "settled distances are final", Name(query));
  uint64_t reachable = 0;
  for (uint32_t v = 0; v < scene.mesh->vertex_count(); ++v) {
    reachable += !std::isinf(full[v]);
  }
  report.Check(seen.size() == settled.size() && seen.size() == reachable,
               "every vertex settles once", settled.size(), " reports of ",
               seen.size(), " vertices, ", reachable, " reachable, ",
               Name(query));
}

void CheckAdding(const Scene& scene, const Query& query, Random& random,
                 Report& report) {
  const std::unique_ptr<Computation> computation = Start(scene, query);
  NoCheckpoint checkpoint;
  absl::Status status = computation->Advance({}, checkpoint);
  Query all = query;
  for (int i = 0; status.ok() && i < 3; ++i) {
    all.sources.push_back({DrawPoint(scene, random)});
    status = computation->AddSource(all.sources.back());
    if (status.ok()) status = computation->Advance({}, checkpoint);
  }
  report.Check(status.ok(), "sources are added", status);
  CheckEqual("added sources = sources from the start", all,
             AllDistances(*scene.mesh, all, report),
             AllDistances(computation->Field()), scene.rounding, report);
}

}  // namespace

void CheckReachLaws(const Scene& scene, Random& random, Report& report) {
  Query query{.targets = scene.points,
              .algorithm = DrawAlgorithm(scene, random)};
  for (uint32_t i = random.Below(3) + 1; i > 0; --i) {
    query.sources.push_back({DrawPoint(scene, random)});
  }
  const std::vector<double> full = AllDistances(*scene.mesh, query, report);
  if (full.empty()) return;
  CheckRadii(scene, query, full, random, report);
  CheckTargets(scene, query, full, random, report);
  CheckCancelling(scene, query, full, random, report);
  CheckSettling(scene, query, full, report);
  CheckAdding(scene, query, random, report);
}

}  // namespace geodesic::stress
