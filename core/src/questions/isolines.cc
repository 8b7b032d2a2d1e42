// The isolines of exact distances. On an edge distance is the least over the
// windows on both its sides, the ways along it from its ends and those straight
// from sources in the faces around: in closed form, so crossings are exact.

#include "geodesic/isolines.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "absl/strings/str_cat.h"
#include "questions/isolines/isoline_band.h"
#include "questions/isolines/level_crossings.h"
#include "solver/start_computation.h"
#include "surface/anchors.h"
#include "tolerances.h"

namespace geodesic {
namespace {

// The caller's checkpoint, at which faces behind the wavefront are dealt with
// so that their windows need not be kept.
class SettlingCheckpoint final : public Checkpoint {
 public:
  SettlingCheckpoint(Checkpoint& callers, IsolineBand& band,
                     LevelCrossings& crossings)
      : callers_(callers), band_(band), crossings_(crossings) {}

  absl::Status Poll(const Progress& progress) override {
    last_ = progress;
    last_.solver_bytes += band_.bytes() + crossings_.bytes();
    if (band_.size() >= next_settling_) {
      if (absl::Status status = crossings_.Settle(
              progress.distances, progress.settled_radius / progress.unit,
              [this] { return callers_.Poll(last_); });
          !status.ok()) {
        return status;
      }
      next_settling_ = std::max(2 * band_.size(), kLeastSettling);
    }
    return callers_.Poll(last_);
  }

  // The same progress once more, when there are no distances to show.
  absl::Status PollAgain() {
    last_.distances = {};
    return callers_.Poll(last_);
  }

 private:
  // Settling comes when the band has doubled, so each window pays for one
  // visit; below this many there is little to gain.
  static constexpr uint64_t kLeastSettling = 16384;

  Checkpoint& callers_;
  IsolineBand& band_;
  LevelCrossings& crossings_;
  uint64_t next_settling_ = kLeastSettling;
  Progress last_;
};

absl::Status CheckLevels(const std::vector<double>& levels) {
  if (levels.empty()) {
    return absl::InvalidArgumentError("levels is empty: name at least one");
  }
  for (size_t i = 0; i < levels.size(); ++i) {
    if (levels[i] > 0 && std::isfinite(levels[i])) continue;
    return absl::InvalidArgumentError(absl::StrCat(
        "levels[", i, "] ", levels[i], " is not a finite number > 0"));
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<std::vector<Isoline>> ComputeIsolines(
    const Mesh& mesh, const ValidQuery& query, std::vector<double> levels,
    const SolveOptions& options, Checkpoint& checkpoint) {
  if (absl::Status status = CheckLevels(levels); !status.ok()) return status;
  std::ranges::sort(levels);
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  std::vector<double> scaled_levels;
  scaled_levels.reserve(levels.size());
  for (double level : levels) {
    scaled_levels.push_back(std::ldexp(level, -mesh.scale_exponent()));
  }

  const ValidQuery distances_alone = query.Sorted().query.DistancesAlone();
  IsolineBand band(mesh, scaled_levels);
  LevelCrossings crossings(mesh, AnchorsOf(distances_alone), scaled_levels,
                           band);
  SettlingCheckpoint settling(checkpoint, band, crossings);
  absl::StatusOr<std::unique_ptr<Computation>> computation =
      StartComputation(mesh, distances_alone, options, &band);
  if (!computation.ok()) return computation.status();
  // A little further, to know what is at the last level.
  const double radius = levels.back() * (1 + 2 * kAtLevel);
  if (absl::Status status = (*computation)->Advance({radius}, settling);
      !status.ok()) {
    return status;
  }
  std::vector<double> distances = (*computation)->Field().distances;
  for (double& distance : distances) {
    distance = std::ldexp(distance, -mesh.scale_exponent());
  }
  if (absl::Status status =
          crossings.Finish(distances, [&] { return settling.PollAgain(); });
      !status.ok()) {
    return status;
  }
  return crossings.Isolines(levels);
}

}  // namespace geodesic
