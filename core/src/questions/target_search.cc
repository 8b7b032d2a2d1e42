#include "geodesic/target_search.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geodesic/computation.h"
#include "mesh/file_unit.h"
#include "questions/backward_bounds.h"
#include "questions/first_path/first_path.h"
#include "questions/tracing/path_tracer.h"
#include "solver/goal.h"
#include "solver/queues/fwp_buckets.h"
#include "solver/queues/queue.h"
#include "solver/rules/anchor_seeding.h"
#include "solver/rules/edge_relaxation.h"
#include "solver/rules/front.h"
#include "solver/rules/hub.h"
#include "solver/rules/list_rule.h"
#include "solver/start_computation.h"
#include "solver/work_meter.h"
#include "surface/anchors.h"
#include "surface/surface_location.h"
#include "tolerances.h"

namespace geodesic {
namespace {

// The front of a search is narrow: it takes less at a time than a field does,
// so that it does not run past the target.
constexpr SolveOptions kSearchOptions{.bucket_width = 4, .max_batch = 64};

// Paths that may be shorter than one that is known fill an ellipse about the
// way. More windows cross each of its edges as the pieces between bends, which
// windows go along, are longer. If its half width times the mean length of a
// piece, both in edges, is no more than this, the bounds of landmarks are as
// good as better ones that have to be found.
constexpr double kFewForLandmarks = 300;

// Bounds from the target back are seldom too short by more than this part.
constexpr double kUsualSlack = 4e-4;

// Each vertex may be a pseudo-source that sees the edges around all others.
// More windows than that, and than these, come only of a search where they
// wind: the most that was seen is a tenth.
constexpr uint64_t kByVertex = 256;
constexpr uint64_t kFew = uint64_t{1} << 14;

double Square(double x) { return x * x; }

// Adds what a search holds and has done to the progress of a field.
class AfterSearch final : public Checkpoint {
 public:
  AfterSearch(uint64_t bytes, uint64_t windows, Checkpoint& checkpoint)
      : bytes_(bytes), windows_(windows), checkpoint_(checkpoint) {}

  absl::Status Poll(const Progress& progress) override {
    Progress sum = progress;
    sum.solver_bytes += bytes_;
    sum.windows_propagated += windows_;
    return checkpoint_.Poll(sum);
  }

 private:
  const uint64_t bytes_, windows_;
  Checkpoint& checkpoint_;
};

}  // namespace

class TargetSearch::Impl {
 public:
  explicit Impl(const Mesh& mesh)
      : mesh_(mesh),
        queue_(*TuningFor(mesh, kSearchOptions)),
        front_(mesh, Query{}, queue_, nullptr, Goal(mesh)),
        rule_(front_, 1),
        hubs_(front_, rule_),
        first_path_(mesh) {}

  absl::StatusOr<TargetDistances> Run(const ValidQuery& query,
                                      const Landmarks* landmarks,
                                      Checkpoint& checkpoint) {
    const auto start = std::chrono::steady_clock::now();
    statistics_ = {};
    TargetDistances found;
    // A search for several at once would cover all that lies between them.
    for (uint32_t t = 0; t < query->targets.size(); ++t) {
      absl::Status status =
          RunOne(query.OfTarget(t), landmarks, checkpoint, found);
      if (!status.ok()) return status;
    }
    found.statistics = statistics_;
    found.statistics.solve_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
            .count();
    return found;
  }

  // As a field that stops at the last target.
  absl::StatusOr<TargetDistances> RunAsField(const ValidQuery& query,
                                             Checkpoint& checkpoint) const {
    absl::StatusOr<std::unique_ptr<Computation>> computation =
        StartComputation(mesh_, query, {});
    if (!computation.ok()) return computation.status();
    absl::Status status =
        (*computation)->Advance({.targets = query->targets.size()}, checkpoint);
    if (!status.ok()) return status;
    const DistanceField field = (*computation)->Field();
    TargetDistances found{.distances = field.target_distances,
                          .certified_error = field.certified_error,
                          .statistics = field.statistics};
    if (!query->trace) return found;
    const absl::StatusOr<PathTracer> tracer =
        PathTracer::Create(mesh_, query, field);
    if (!tracer.ok()) return tracer.status();
    for (uint32_t t = 0; t < found.distances.size(); ++t) {
      absl::StatusOr<GeodesicPath> path = tracer->ToTarget(t, checkpoint);
      if (!path.ok()) return path.status();
      found.paths.push_back(*std::move(path));
    }
    return found;
  }

  uint64_t bytes() const {
    return front_.bytes() + front_.goal().bytes() + rule_.bytes() +
           hubs_.bytes() + queue_.bytes() + first_path_.bytes() +
           (backward_.has_value() ? backward_->bytes() : 0);
  }

 private:
  using DirectedFront = Front<FwpBuckets, Origin, Goal>;
  using Rule = ListRule<DirectedFront>;

  // Adds the distance of the query's only target, and the path to it.
  absl::Status RunOne(const ValidQuery& query, const Landmarks* landmarks,
                      Checkpoint& checkpoint, TargetDistances& found) {
    absl::Status status = Search(query, landmarks, checkpoint);
    if (!status.ok()) return status;
    Count();
    if (GivesWay()) {
      absl::StatusOr<TargetDistances> whole = RunAfter(query, checkpoint);
      if (!whole.ok()) return whole.status();
      found.distances.push_back(whole->distances[0]);
      found.certified_error =
          std::max(found.certified_error, whole->certified_error);
      if (query->trace) found.paths.push_back(std::move(whole->paths[0]));
      return absl::OkStatus();
    }
    found.distances.push_back(ToFileUnit(mesh_, Found()));
    if (IsWithin()) found.certified_error = query->tolerance;
    if (query->trace) {
      absl::StatusOr<GeodesicPath> path =
          Trace(query, found.distances.back(), checkpoint);
      // The way back may be lost among what a search has left out.
      if (absl::IsInternal(path.status())) {
        absl::StatusOr<TargetDistances> whole = RunAfter(query, checkpoint);
        if (!whole.ok()) return whole.status();
        path = std::move(whole->paths[0]);
        path->distance = found.distances.back();
      }
      if (!path.ok()) return path.status();
      found.paths.push_back(*std::move(path));
    }
    return absl::OkStatus();
  }

  // As RunAsField, and adds to what a search has done and holds.
  absl::StatusOr<TargetDistances> RunAfter(const ValidQuery& query,
                                           Checkpoint& checkpoint) {
    AfterSearch after(bytes(), statistics_.windows_propagated, checkpoint);
    absl::StatusOr<TargetDistances> whole = RunAsField(query, after);
    if (whole.ok()) {
      statistics_.windows_propagated += whole->statistics.windows_propagated;
    }
    return whole;
  }

  absl::Status Search(const ValidQuery& query, const Landmarks* landmarks,
                      Checkpoint& checkpoint) {
    Restart(query);
    front_.goal().Aim(query->targets[0], landmarks);
    tolerance_ = query->tolerance;
    longest_ = guess_ = std::numeric_limits<double>::infinity();
    const std::vector<Anchor> anchors = AnchorsOf(query);
    absl::Status status =
        first_path_.Find(anchors, query->targets[0], front_.goal(),
                         [&] { return Poll(checkpoint); });
    if (!status.ok()) return status;
    if (first_path_.shows_none()) return Poll(checkpoint);
    longest_ = first_path_.length();
    if (MayLookBack(query)) {
      const absl::StatusOr<double> least =
          LookBack(query, landmarks, checkpoint);
      if (!least.ok()) return least.status();
      if (IsWithin() && longest_ <= (1 + tolerance_) * *least) {
        return absl::OkStatus();
      }
    }
    status = Propagate(anchors, first_path_.bends(), checkpoint);
    if (status.ok() && !GivesWay() && Found() > Margin(guess_)) {
      Count();
      Restart(query);
      guess_ = std::numeric_limits<double>::infinity();
      status = Propagate(anchors, first_path_.bends(), checkpoint);
    }
    if (!status.ok() || GivesWay() || Found() <= Margin(longest_)) {
      return status;
    }
    // Rounding in faces that are hardly higher than it.
    Count();
    Restart(query);
    front_.goal().Aim(query->targets[0], landmarks);
    longest_ = std::numeric_limits<double>::infinity();
    return Propagate(anchors, {}, checkpoint);
  }

  // Whether bounds from the target back are likely to save more windows than
  // they cost.
  bool MayLookBack(const ValidQuery& query) const {
    if (query->sources.size() > 1 || !BackwardBounds::Serve(mesh_)) {
      return false;
    }
    if (!front_.goal().has_landmarks()) return true;
    const Source& source = query->sources[0];
    const double longest = Limit() - OffsetOf(source);
    const double shortest = BoundFrom(std::get<SurfacePoint>(source.place));
    const double width =
        std::sqrt(std::max(longest - shortest, 0.0) * (longest + shortest)) / 2;
    const double piece =
        longest / static_cast<double>(first_path_.bends().size() + 1);
    return width * piece > kFewForLandmarks * Square(mesh_.mean_edge_length());
  }

  // No path from the place to the target is shorter.
  double BoundFrom(const SurfacePoint& place) const {
    if (const auto* at = std::get_if<VertexPoint>(&place)) {
      return front_.goal().Bound(at->vertex);
    }
    const FacePoint in_face = FirstFaceAround(mesh_, place);
    double bound = 0;
    for (uint32_t corner = 0; corner < 3; ++corner) {
      const uint32_t v = mesh_.triangle(in_face.face)[corner];
      bound = std::max(bound, front_.goal().Bound(v) -
                                  DistanceToCorner(mesh_, in_face, corner));
    }
    return bound;
  }

  double OffsetOf(const Source& source) const {
    return std::ldexp(source.offset, -mesh_.scale_exponent());
  }

  // Takes such bounds for the goal's, and guesses the distance by them if that
  // is less than is known. Returns one for the source: no shortest path is
  // shorter.
  absl::StatusOr<double> LookBack(const ValidQuery& query,
                                  const Landmarks* landmarks,
                                  Checkpoint& checkpoint) {
    const Source& source = query->sources[0];
    const double offset = OffsetOf(source);
    const double limit = Limit();
    if (limit <= offset) return offset;
    if (!backward_.has_value()) backward_.emplace(mesh_);
    absl::Status status =
        backward_->Find({.source = std::get<SurfacePoint>(source.place),
                         .target = query->targets[0],
                         .longest = limit - offset},
                        landmarks, [&] { return Poll(checkpoint); });
    statistics_.windows_propagated += backward_->windows();
    if (!status.ok()) return status;
    if (!backward_->has_bounds()) return offset;
    longest_ = std::min(longest_, offset + backward_->longest());
    front_.goal().Refine([this](uint32_t v) { return backward_->Bound(v); });
    const double shortest = offset + backward_->shortest();
    const double guess = (1 + kUsualSlack) * shortest;
    if (guess < Limit()) guess_ = guess;
    return shortest;
  }

  // Adds what was done since Restart to the statistics.
  void Count() {
    statistics_.iterations += queue_.iterations();
    statistics_.windows_created += rule_.created();
    statistics_.peak_windows =
        std::max(statistics_.peak_windows, rule_.peak_windows());
  }

  void Restart(const ValidQuery& query) {
    rule_.Clear();
    hubs_.Clear();
    queue_.Clear();
    front_.Restart(*query);
  }

  static double Margin(double length) { return length * (1 + kGoalMargin); }

  // Whether an answer is wanted within a tolerance, and there is a path that
  // may be it.
  bool IsWithin() const { return tolerance_ > 0 && std::isfinite(longest_); }

  // What the search has to find if there is any: paths that are shorter than
  // those that are known, and by more than the tolerance.
  double Limit() const {
    return std::min(guess_, std::min(longest_, Distance()) / (1 + tolerance_));
  }

  // The distance to answer with.
  double Found() const {
    return IsWithin() ? std::min(longest_, Distance()) : Distance();
  }

  // Finds the distance of the target, if it is no larger than Limit(). If that
  // is known, few windows are too many, and labels are the better order.
  // `bends`: of the first path, if that is to shorten what is known.
  absl::Status Propagate(std::span<const Anchor> anchors,
                         std::span<const TautPath::Bend> bends,
                         Checkpoint& checkpoint) {
    bends_ahead_ = bends;
    front_.goal().set_limit(Margin(Limit()));
    front_.goal().set_orders_by_label(std::isfinite(longest_));
    DirectSink sink(front_, rule_);
    uint64_t entered = 0;
    for (const Anchor& anchor : anchors) {
      if (entered >= kWorkBetweenPolls) {
        entered = 0;
        if (absl::Status status = Poll(checkpoint); !status.ok()) return status;
      }
      entered += kStepsOfAnchor + AddAnchor(front_, anchor, sink);
    }
    // Vertices that windows miss beside thin faces are reached along edges, as
    // in fields; or where the target is farther than a path that is known.
    const bool may_miss = mesh_.HasThinFaces() || std::isinf(longest_);
    do {
      absl::Status status = Drain(checkpoint);
      if (!status.ok() || !may_miss || GivesWay()) return status;
      // What is left there is beyond the limit.
      statistics_.iterations += queue_.iterations();
      queue_.Clear();
    } while (RelaxAlongEdgesToGoal(front_));
    return absl::OkStatus();
  }

  // Whether a field is to answer: windows wind, or were dropped since they did.
  bool GivesWay() const {
    const uint64_t reached = front_.reached();
    return rule_.has_dropped() ||
           rule_.created() > reached * (reached + kByVertex) + kFew;
  }

  // Propagates all that is pending within the limit.
  absl::Status Drain(Checkpoint& checkpoint) {
    uint64_t steps = kWorkBetweenPolls;
    for (;;) {
      if (steps >= kWorkBetweenPolls) {
        steps = 0;
        if (absl::Status status = Poll(checkpoint); !status.ok()) return status;
      }
      if (!hubs_.empty()) {
        const uint64_t before = rule_.steps();
        const uint64_t faces = hubs_.GoOn();
        steps += std::max(faces, rule_.steps() - before);
        continue;
      }
      PassBends();
      front_.goal().set_limit(Margin(Limit()));
      if (queue_.SettledRadius() > front_.goal().limit()) break;
      if (GivesWay()) break;
      PopTogether(queue_, rule_.most_together(), together_);
      if (together_.empty()) break;
      for (const uint32_t id : together_) {
        statistics_.pseudo_source_events += (id & kVertexEvent) != 0;
      }
      std::erase_if(together_, [this](uint32_t id) { return hubs_.Take(id); });
      uint64_t events = 0;
      for (const uint32_t id : together_) events += StepsOf(mesh_, id);
      const uint64_t before = rule_.steps();
      const uint64_t windows = rule_.Propagate(together_);
      statistics_.windows_propagated += windows;
      steps += std::max({events, windows, rule_.steps() - before});
      statistics_.peak_wavefront =
          std::max(statistics_.peak_wavefront, rule_.pending());
    }
    return Poll(checkpoint);
  }

  // A shorter way to a bend of the first path, and the rest of that, are a
  // shorter path. REQUIRES: labels are the order, if there are bends.
  void PassBends() {
    for (; !bends_ahead_.empty(); bends_ahead_ = bends_ahead_.subspan(1)) {
      const TautPath::Bend& bend = bends_ahead_.front();
      const double rest = first_path_.Rest(bend);
      if (first_path_.length() - rest > queue_.SettledRadius()) return;
      longest_ = std::min(longest_, front_.distances()[bend.vertex] + rest);
    }
  }

  // `distance`: that of the target, in the unit of the file.
  absl::StatusOr<GeodesicPath> Trace(const ValidQuery& query, double distance,
                                     Checkpoint& checkpoint) {
    const Arrival arrival =
        front_.targets().ArrivalAt(0, front_.distances(), front_.arrivals());
    const double scaled = Distance();
    // Where lines fork, distances tell which way is wrong.
    if (mesh_.HasNonManifoldEdges()) front_.ForgetBeyondGoal();
    const TracedField field(mesh_, query,
                            {.vertices = front_.distances(),
                             .targets = {&scaled, 1},
                             .vertex_arrivals = front_.arrivals(),
                             .target_arrivals = {&arrival, 1}});
    const auto poll = [&] { return Poll(checkpoint); };
    WorkMeter meter(poll);
    return TracePath(field, field.Target(0), distance, meter);
  }

  absl::Status Poll(Checkpoint& checkpoint) {
    const uint64_t held = bytes();
    statistics_.peak_solver_bytes =
        std::max(statistics_.peak_solver_bytes, held);
    return checkpoint.Poll({
        .vertices_reached = front_.reached(),
        .vertices = mesh_.vertex_count(),
        .live_windows = rule_.pending(),
        .windows_propagated = statistics_.windows_propagated,
        .solver_bytes = held,
    });
  }

  // Of the target, as far as is known.
  double Distance() const {
    return front_.targets().Distance(0, front_.distances());
  }

  const Mesh& mesh_;
  FwpBuckets queue_;
  DirectedFront front_;
  Rule rule_;
  Hubs<DirectedFront, Rule> hubs_;
  FirstPath first_path_;
  std::optional<BackwardBounds> backward_;  // once it was asked for
  double tolerance_ = 0;
  // No shortest path is longer.
  double longest_ = std::numeric_limits<double>::infinity();
  // Nor is it likely to be longer than this; infinite if nothing tells.
  double guess_ = std::numeric_limits<double>::infinity();
  std::span<const TautPath::Bend> bends_ahead_;  // of the first path
  std::vector<uint32_t> together_;
  SolveStatistics statistics_;
};

TargetSearch::TargetSearch(const Mesh& mesh)
    : impl_(std::make_unique<Impl>(mesh)) {}
TargetSearch::TargetSearch(TargetSearch&&) noexcept = default;
TargetSearch& TargetSearch::operator=(TargetSearch&&) noexcept = default;
TargetSearch::~TargetSearch() = default;

absl::StatusOr<TargetDistances> TargetSearch::Run(const ValidQuery& query,
                                                  const Landmarks* landmarks,
                                                  Checkpoint& checkpoint) {
  if (query->targets.empty()) {
    return absl::InvalidArgumentError("targets is empty: name at least one");
  }
  if (IsDirected(query->algorithm)) {
    return impl_->Run(query, landmarks, checkpoint);
  }
  return impl_->RunAsField(query, checkpoint);
}

uint64_t TargetSearch::bytes() const { return impl_->bytes(); }

uint64_t TargetSearch::PlannedBytes(const Mesh& mesh, const ValidQuery& query) {
  // Distance, state, ray and bound, and what the first path takes; where lists
  // wait; the queue and the windows of a wide search.
  constexpr uint64_t kPerVertex =
      2 * sizeof(double) + 1 + sizeof(IncomingRay) + FirstPath::kBytesByVertex;
  constexpr uint64_t kBase = uint64_t{1} << 20;
  constexpr uint64_t kPerHalfEdge =
      sizeof(uint32_t) + BackwardBounds::kBytesByHalfEdge;
  const uint64_t of_search =
      (kPerVertex + BackwardBounds::kBytesByVertex) * mesh.vertex_count() +
      kPerHalfEdge * mesh.half_edge_count() + mesh.resident_bytes() / 16 +
      kBase;
  if (IsDirected(query->algorithm)) return of_search;
  // It is computed as a field, beside these arrays.
  return of_search + PlannedSolverBytes(mesh, query);
}

}  // namespace geodesic
