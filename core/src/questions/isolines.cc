// The isolines of exact distances. On an edge distance is the least over the
// windows on both its sides, the ways along it from its ends and those straight
// from sources in the faces around: in closed form, so crossings are exact.
// Inside a face it is the least over the ways into it, and so are the arcs.

#include "geodesic/isolines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "geodesic/mesh.h"
#include "geodesic_types/field_path.h"
#include "questions/isolines/isoline_band.h"
#include "questions/isolines/level_crossings.h"
#include "solver/accuracy.h"
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
    solver_bytes_ = progress.solver_bytes;
    if (kept_radius_.has_value() &&
        progress.settled_radius / progress.unit >= *kept_radius_) {
      kept_.assign(progress.distances.begin(), progress.distances.end());
      for (double& distance : kept_) {
        if (distance > *kept_radius_) {
          distance = std::numeric_limits<double>::infinity();
        }
      }
    }
    if (band_.size() >= next_settling_) {
      if (absl::Status status = crossings_.Settle(
              progress.distances, progress.settled_radius / progress.unit,
              [this] { return PollCaller(); });
          !status.ok()) {
        return status;
      }
      next_settling_ = std::max(2 * band_.size(), kLeastSettling);
    }
    return PollCaller();
  }

  // Keeps the distances that are final up to `radius`, in the scaled unit, once
  // they are; others are infinite.
  void KeepUpTo(double radius) { kept_radius_ = radius; }
  const std::vector<double>& kept() const { return kept_; }

  // The same progress once more, when there are no distances to show.
  absl::Status PollAgain() {
    last_.distances = {};
    return PollCaller();
  }

 private:
  absl::Status PollCaller() {
    last_.solver_bytes = solver_bytes_ + band_.bytes() + crossings_.bytes() +
                         kept_.capacity() * sizeof(double);
    return callers_.Poll(last_);
  }

  // Settling comes when the band has doubled, so each window pays for one
  // visit; below this many there is little to gain.
  static constexpr uint64_t kLeastSettling = 16384;

  Checkpoint& callers_;
  IsolineBand& band_;
  LevelCrossings& crossings_;
  uint64_t next_settling_ = kLeastSettling;
  Progress last_;
  uint64_t solver_bytes_ = 0;  // of these, the solver's own
  std::optional<double> kept_radius_;
  std::vector<double> kept_;
};

absl::Status CheckOptions(const IsolineOptions& options) {
  const std::vector<double>& levels = options.levels;
  if (levels.empty()) {
    return absl::InvalidArgumentError("levels is empty: name at least one");
  }
  for (size_t i = 0; i < levels.size(); ++i) {
    if (levels[i] > 0 && std::isfinite(levels[i])) continue;
    return absl::InvalidArgumentError(absl::StrCat(
        "levels[", i, "] ", levels[i], " is not a finite number > 0"));
  }
  if (!(options.chord_error >= 0)) {
    return InvalidField("chord_error",
                        absl::StrCat("chord_error is ", options.chord_error,
                                     "; it must be >= 0"));
  }
  return absl::OkStatus();
}

// Levels in the unit of the file, and where their lines are drawn, in the
// scaled one. Both rise.
struct Levels {
  std::vector<double> named;
  std::vector<double> drawn;
};

using Doubt = LevelCrossings::Doubt;

struct Drawing {
  std::vector<Isoline> isolines;  // level by level
  std::vector<Doubt> doubts;      // of each level
};

absl::StatusOr<Drawing> Draw(const Mesh& mesh, const ValidQuery& query,
                             const Levels& levels,
                             const LevelCrossings::Accuracy& accuracy,
                             const SolveOptions& options,
                             Checkpoint& checkpoint) {
  IsolineBand band(mesh, levels.drawn);
  LevelCrossings crossings(mesh, AnchorsOf(query), levels.drawn, accuracy,
                           band);
  SettlingCheckpoint settling(checkpoint, band, crossings);
  absl::StatusOr<std::unique_ptr<Computation>> computation =
      StartComputation(mesh, query, options, &band);
  if (!computation.ok()) return computation.status();
  // A little further, to know what is at the last level.
  const double radius =
      std::max(levels.named.back(),
               std::ldexp(levels.drawn.back(), mesh.scale_exponent())) *
      (1 + 2 * kAtLevel);
  const bool is_exact = query->tolerance == 0;
  if (!is_exact) settling.KeepUpTo(std::ldexp(radius, -mesh.scale_exponent()));
  if (absl::Status status = (*computation)->Advance({radius}, settling);
      !status.ok()) {
    return status;
  }
  std::vector<double> distances;
  if (is_exact) {
    distances = (*computation)->Field().distances;
    for (double& distance : distances) {
      distance = std::ldexp(distance, -mesh.scale_exponent());
    }
  } else {
    // The field has answers above the lower bounds, which are on the other side
    // of some levels than the windows are.
    distances = settling.kept();
  }
  const auto poll = [&] { return settling.PollAgain(); };
  if (absl::Status status = crossings.Finish(distances, poll); !status.ok()) {
    return status;
  }
  absl::StatusOr<std::vector<Isoline>> isolines =
      crossings.Isolines(levels.named, poll);
  if (!isolines.ok()) return isolines.status();
  return Drawing{*std::move(isolines), crossings.doubts()};
}

// The levels in doubt, drawn by this part beside.
Levels Beside(const Levels& levels, const std::vector<Doubt>& doubts,
              double part) {
  Levels beside;
  for (size_t i = 0; i < levels.named.size(); ++i) {
    if (doubts[i] == Doubt::kNone) continue;
    beside.named.push_back(levels.named[i]);
    beside.drawn.push_back(levels.drawn[i] * (1 + part));
  }
  return beside;
}

// Takes the isolines of those levels from `again` that are in less doubt there.
void Replace(const Levels& levels, const Levels& drawn_again, Drawing again,
             Drawing& drawing) {
  std::vector<double> better;
  for (size_t i = 0; i < drawn_again.named.size(); ++i) {
    const double level = drawn_again.named[i];
    Doubt& doubt =
        drawing.doubts[std::ranges::lower_bound(levels.named, level) -
                       levels.named.begin()];
    if (again.doubts[i] >= doubt) continue;
    doubt = again.doubts[i];
    better.push_back(level);
  }
  const auto is_better = [&](const Isoline& line) {
    return std::ranges::binary_search(better, line.level);
  };
  std::erase_if(drawing.isolines, is_better);
  std::ranges::copy_if(again.isolines, std::back_inserter(drawing.isolines),
                       is_better);
  std::ranges::stable_sort(drawing.isolines, {}, &Isoline::level);
}

}  // namespace

absl::StatusOr<std::vector<Isoline>> ComputeIsolines(
    const Mesh& mesh, const ValidQuery& query, const IsolineOptions& isolines,
    const SolveOptions& options, Checkpoint& checkpoint) {
  if (absl::Status status = CheckOptions(isolines); !status.ok()) return status;
  Levels levels{.named = isolines.levels};
  std::ranges::sort(levels.named);
  levels.named.erase(std::unique(levels.named.begin(), levels.named.end()),
                     levels.named.end());
  const ValidQuery distances_alone = query.Sorted().query.DistancesAlone();
  const double tolerance = distances_alone->tolerance;
  // Within a tolerance, windows and the distances that propagate are lower
  // bounds, and the truth is at most so much above them. The lines are drawn
  // where fields would answer the level.
  const double share = tolerance > 0 ? WithinTolerance(tolerance).share() : 0;
  for (const double level : levels.named) {
    levels.drawn.push_back(std::ldexp(level, -mesh.scale_exponent()) *
                           (1 - kAnswerInAccount * share));
  }
  const bool is_relative = isolines.chord_error == 0;
  const LevelCrossings::Accuracy accuracy{
      .chord_error = is_relative ? kChordErrorOfLevel
                                 : std::ldexp(isolines.chord_error,
                                              -mesh.scale_exponent()),
      .is_relative = is_relative,
      .share = share};
  const auto draw = [&](const Levels& of) {
    return Draw(mesh, distances_alone, of, accuracy, options, checkpoint);
  };
  absl::StatusOr<Drawing> drawing = draw(levels);
  if (!drawing.ok()) return drawing.status();
  // Windows within a tolerance leave doubts wherever they are drawn.
  for (const double part : kBesideLevel) {
    if (tolerance > 0) break;
    const Levels beside = Beside(levels, drawing->doubts, part);
    if (beside.named.empty()) break;
    absl::StatusOr<Drawing> again = draw(beside);
    if (!again.ok()) return again.status();
    Replace(levels, beside, *std::move(again), *drawing);
  }
  return std::move(drawing->isolines);
}

}  // namespace geodesic
