// After Xin, Ying, He: Constant-time all-pairs geodesic distance query on
// triangle meshes. I3D 2012.
//
//   paper                              here
//   m samples, their distances         sample_count_, between_
//   geodesic triangle of a vertex      Corners: three of the nearest samples
//                                      that surround it when laid into the
//                                      plane
//   unfolding                          Unfold

#include "geodesic/approximate/triangle_unfolding.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

#include "absl/strings/str_cat.h"
#include "approximate/seeds.h"
#include "geodesic/sampling.h"
#include "geodesic/solve.h"
#include "geodesic_types/field_path.h"
#include "mesh/file_unit.h"
#include "solver/thread_team.h"
#include "solver/work_meter.h"
#include "surface/plane_point.h"

namespace geodesic {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr uint32_t kMostSamples = 20000;
// Among how many nearest samples a vertex' triangle is sought.
constexpr uint32_t kNearest = 8;
// Thin triangles do not tell on which side of them a place lies: one of a
// hundredth of its size in height counts as much as being a tenth outside.
constexpr double kThinness = 1e-3;
// Between two polls of a query, in vertices.
constexpr uint32_t kPollPeriod = 1024;

// The same place or its image below, whichever is nearer to being so far from
// `third`.
PlanePoint OnEitherSide(const PlanePoint& above, const PlanePoint& third,
                        double distance) {
  const PlanePoint below = {above.x, -above.y};
  return std::abs(Norm(third - below) - distance) <
                 std::abs(Norm(third - above) - distance)
             ? below
             : above;
}

}  // namespace

// Distances are found by several threads and kept under a lock.
class TriangleUnfolding::Builder {
 public:
  Builder(const Mesh& mesh, uint32_t threads, std::vector<uint32_t> samples,
          Checkpoint& checkpoint, TriangleUnfolding& unfolding)
      : mesh_(mesh),
        threads_(threads),
        samples_(std::move(samples)),
        checkpoint_(checkpoint),
        unfolding_(unfolding),
        nearest_(mesh.vertex_count()) {}

  absl::Status Run() {
    const auto count = static_cast<uint32_t>(samples_.size());
    unfolding_.sample_count_ = count;
    unfolding_.between_.resize(uint64_t{count} * count);
    ThreadTeam team(threads_);
    team.Run([this](uint32_t member) { Work(member); });
    if (!status_.ok()) return status_;
    unfolding_.corners_.resize(mesh_.vertex_count());
    for (uint32_t v = 0; v < mesh_.vertex_count(); ++v) {
      if (v % kPollPeriod == 0) {
        absl::Status status = Poll();
        if (!status.ok()) return status;
      }
      unfolding_.corners_[v] = TriangleAround(nearest_[v]);
    }
    return absl::OkStatus();
  }

 private:
  struct Near {
    float distance = std::numeric_limits<float>::infinity();
    uint32_t sample = kNone;

    bool operator<(const Near& other) const {
      return distance != other.distance ? distance < other.distance
                                        : sample < other.sample;
    }
  };
  using Nearest = std::array<Near, kNearest>;

  // The calling thread's solver asks the checkpoint, the others whether to
  // stop.
  class Watch final : public Checkpoint {
   public:
    Watch(Builder& builder, uint32_t member)
        : builder_(builder), is_first_(member == 0) {}
    absl::Status Poll(const Progress&) override {
      if (is_first_) {
        absl::Status status = builder_.Poll();
        if (!status.ok()) return status;
      }
      return builder_.is_stopped_ ? absl::CancelledError("stopped")
                                  : absl::OkStatus();
    }

   private:
    Builder& builder_;
    const bool is_first_;
  };

  absl::Status Poll() {
    return checkpoint_.Poll(
        {.vertices_reached =
             uint64_t{mesh_.vertex_count()} * done_ / samples_.size(),
         .vertices = mesh_.vertex_count(),
         .solver_bytes = nearest_.size() * sizeof(Nearest) +
                         unfolding_.between_.size() * sizeof(float) +
                         threads_ * mesh_.resident_bytes() / 4});
  }

  void Work(uint32_t member) {
    Watch watch(*this, member);
    for (;;) {
      const uint32_t sample = next_.fetch_add(1);
      if (sample >= samples_.size()) return;
      const absl::StatusOr<DistanceField> field =
          Solve(mesh_, Query{.sources = {{VertexPoint{samples_[sample]}}}}, {},
                watch);
      const std::lock_guard lock(mutex_);
      if (!field.ok()) {
        // That of the first who stopped, not of those it stopped.
        if (!is_stopped_) status_ = field.status();
        is_stopped_ = true;
        return;
      }
      Keep(sample, field->distances);
      ++done_;
    }
  }

  void Keep(uint32_t sample, const std::vector<double>& distances) {
    const double scale = std::ldexp(1.0, -mesh_.scale_exponent());
    for (uint32_t v = 0; v < distances.size(); ++v) {
      const Near near = {static_cast<float>(distances[v] * scale), sample};
      if (std::isinf(near.distance)) continue;
      Nearest& nearest = nearest_[v];
      if (!(near < nearest.back())) continue;
      const auto place = std::upper_bound(nearest.begin(), nearest.end(), near);
      std::move_backward(place, nearest.end() - 1, nearest.end());
      *place = near;
    }
    for (uint32_t other = 0; other < samples_.size(); ++other) {
      unfolding_.between_[uint64_t{sample} * samples_.size() + other] =
          static_cast<float>(distances[samples_[other]] * scale);
    }
  }

  // Of three corners, by how much they miss surrounding the vertex: the way
  // from where two of them put it to where the third does, and how far it lies
  // outside; in sizes of the triangle.
  double Miss(const Near& a, const Near& b, const Near& c) const {
    const double length = unfolding_.Between(a.sample, b.sample);
    const double ac = unfolding_.Between(a.sample, c.sample);
    const double bc = unfolding_.Between(b.sample, c.sample);
    const PlanePoint third = PlaceOver(length, ac, bc);
    const PlanePoint at = PlaceOver(length, a.distance, b.distance);
    const double size = length + ac + bc;
    const double inconsistent = std::abs(Norm(third - at) - c.distance);
    const PlanePoint begin = {0, 0}, end = {length, 0};
    const double area = length * third.y;
    const double outside = std::max({0.0, -Cross(third - end, at - end) / area,
                                     -Cross(begin - third, at - third) / area});
    const double miss =
        inconsistent / size + outside + kThinness * size * size / area;
    return area > 0 && std::isfinite(miss) ? miss : kInfinity;
  }

  Corners TriangleAround(const Nearest& nearest) const {
    Corners corners;
    uint32_t count = 0;
    while (count < kNearest && nearest[count].sample != kNone) ++count;
    std::array<uint32_t, 3> best = {0, 1, 2};
    double least = kInfinity;
    for (uint32_t c = 2; c < count; ++c) {
      for (uint32_t b = 1; b < c; ++b) {
        for (uint32_t a = 0; a < b; ++a) {
          const double miss = Miss(nearest[a], nearest[b], nearest[c]);
          if (miss >= least) continue;
          least = miss;
          best = {a, b, c};
        }
      }
    }
    for (uint32_t i = 0; i < 3; ++i) {
      if (best[i] >= count) continue;
      corners.samples[i] = nearest[best[i]].sample;
      corners.distances[i] = nearest[best[i]].distance;
    }
    return corners;
  }

  const Mesh& mesh_;
  const uint32_t threads_;
  const std::vector<uint32_t> samples_;
  Checkpoint& checkpoint_;
  TriangleUnfolding& unfolding_;
  std::atomic<uint32_t> next_ = 0;  // sample that nobody has taken
  std::atomic<uint32_t> done_ = 0;
  std::atomic<bool> is_stopped_ = false;

  std::mutex mutex_;
  // Guarded by mutex_ while threads run:
  absl::Status status_;
  std::vector<Nearest> nearest_;  // by vertex
};

absl::Status TriangleUnfolding::Check(const TriangleUnfoldingOptions& options) {
  if (options.samples == 0 || options.samples > kMostSamples) {
    return InvalidField("samples",
                        absl::StrCat("gtu: samples ", options.samples,
                                     " is not in [1, ", kMostSamples, "]"));
  }
  if (options.threads == 0 || options.threads > kMostSolveThreads) {
    return InvalidField(
        "threads", absl::StrCat("gtu: threads ", options.threads,
                                " is not in [1, ", kMostSolveThreads, "]"));
  }
  return absl::OkStatus();
}

absl::StatusOr<std::shared_ptr<const TriangleUnfolding>>
TriangleUnfolding::Prepare(const Mesh& mesh,
                           const TriangleUnfoldingOptions& options,
                           Checkpoint& checkpoint) {
  if (absl::Status status = Check(options); !status.ok()) return status;
  uint32_t face = 0;
  while (mesh.IsLeftOut(face)) ++face;
  const uint32_t first = mesh.triangle(face)[0];
  const absl::StatusOr<ValidQuery> query =
      ValidQuery::Make({.sources = {{VertexPoint{first}}}}, mesh);
  if (!query.ok()) return query.status();
  // Whoever watches sees no radius of this.
  class Quiet final : public Checkpoint {
   public:
    Quiet(const Mesh& mesh, Checkpoint& checkpoint)
        : mesh_(mesh), checkpoint_(checkpoint) {}
    absl::Status Poll(const Progress& progress) override {
      return checkpoint_.Poll({.vertices = mesh_.vertex_count(),
                               .solver_bytes = progress.solver_bytes});
    }

   private:
    const Mesh& mesh_;
    Checkpoint& checkpoint_;
  } quiet(mesh, checkpoint);
  const absl::StatusOr<std::vector<FarthestSample>> farthest =
      SampleFarthestPoints(mesh, *query, options.samples, {}, quiet);
  if (!farthest.ok()) return farthest.status();
  std::vector<uint32_t> samples = {first};
  for (const FarthestSample& sample : *farthest) {
    if (samples.size() == options.samples) {
      // Components without a sample come first.
      if (!std::isinf(sample.distance)) break;
      return absl::InvalidArgumentError(
          absl::StrCat("gtu: the mesh has more components than the ",
                       options.samples, " samples asked for"));
    }
    samples.push_back(sample.vertex);
  }
  std::shared_ptr<TriangleUnfolding> unfolding(new TriangleUnfolding(mesh));
  absl::Status status =
      Builder(mesh, options.threads, std::move(samples), checkpoint, *unfolding)
          .Run();
  if (!status.ok()) return status;
  return unfolding;
}

// Lays the triangle of the corners into the plane edge by edge. The vertex lies
// on the inner side; the other place on that side on which its distance from
// the third corner is nearer to what it should be.
double TriangleUnfolding::Unfold(const Corners& around,
                                 const std::array<double, 3>& to) const {
  double least = 0, most = kInfinity;
  for (int i = 0; i < 3; ++i) {
    if (around.samples[i] == kNone) continue;
    const double from = around.distances[i];
    least = std::max(least, std::abs(from - to[i]));
    most = std::min(most, from + to[i]);
  }
  if (around.samples[2] == kNone || std::isinf(most)) return most;
  double across = kInfinity, within = kInfinity;
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    const double length = Between(around.samples[a], around.samples[b]);
    if (!(length > 0)) continue;
    const PlanePoint third =
        PlaceOver(length, Between(around.samples[a], around.samples[c]),
                  Between(around.samples[b], around.samples[c]));
    const PlanePoint from = OnEitherSide(
        PlaceOver(length, around.distances[a], around.distances[b]), third,
        around.distances[c]);
    const PlanePoint place =
        OnEitherSide(PlaceOver(length, to[a], to[b]), third, to[c]);
    const double straight = Norm(place - from);
    if ((from.y > 0) == (place.y > 0)) {
      within = std::min(within, straight);
      continue;
    }
    const double crossing =
        (from.x * place.y - place.x * from.y) / (place.y - from.y);
    if (crossing >= 0 && crossing <= length) {
      across = std::min(across, straight);
    }
  }
  const double unfolded = std::isinf(across) ? within : across;
  return std::isinf(unfolded) ? most : std::clamp(unfolded, least, most);
}

double TriangleUnfolding::ScaledDistance(uint32_t from, uint32_t to) const {
  if (from == to) return 0;
  const Corners& source = corners_[from];
  const Corners& target = corners_[to];
  if (source.samples[0] == kNone || target.samples[0] == kNone) {
    return kInfinity;
  }
  // From the source to each corner of the target.
  std::array<double, 3> to_corners;
  for (int j = 0; j < 3; ++j) {
    const uint32_t sample = target.samples[j];
    to_corners[j] = kInfinity;
    if (sample == kNone) continue;
    std::array<double, 3> distances;
    bool is_shared = false;
    for (int i = 0; i < 3; ++i) {
      if (source.samples[i] == kNone) continue;
      distances[i] = Between(source.samples[i], sample);
      if (source.samples[i] == sample) {
        to_corners[j] = source.distances[i];
        is_shared = true;
      }
    }
    if (!is_shared) to_corners[j] = Unfold(source, distances);
  }
  return Unfold(target, to_corners);
}

double TriangleUnfolding::Distance(uint32_t from, uint32_t to) const {
  return ToFileUnit(mesh(), ScaledDistance(from, to));
}

ApproximateMethod TriangleUnfolding::method() const {
  return ApproximateMethod::kGtu;
}

absl::StatusOr<std::vector<double>> TriangleUnfolding::Compute(
    const ValidQuery& query, Checkpoint& checkpoint) const {
  const absl::StatusOr<std::vector<Seed>> seeds =
      SeedsOf(query, mesh(), method(), checkpoint);
  if (!seeds.ok()) return seeds.status();
  std::vector<double> distances(mesh().vertex_count(), kInfinity);
  uint32_t v = 0;
  const auto poll = [&] {
    return checkpoint.Poll({.vertices_reached = v,
                            .vertices = mesh().vertex_count(),
                            .solver_bytes = distances.size() * sizeof(double)});
  };
  if (absl::Status status = poll(); !status.ok()) return status;
  WorkMeter meter(poll);
  for (; v < distances.size(); ++v) {
    for (const auto& [seed, distance] : *seeds) {
      distances[v] = std::min(distances[v], distance + ScaledDistance(seed, v));
      if (!meter.Do()) return meter.status();
    }
    distances[v] = ToFileUnit(mesh(), distances[v]);
  }
  return distances;
}

uint64_t TriangleUnfolding::bytes() const {
  return sizeof(*this) + between_.capacity() * sizeof(float) +
         corners_.capacity() * sizeof(Corners);
}

}  // namespace geodesic
