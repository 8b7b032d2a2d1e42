// Kimmel, Sethian: Computing geodesic paths on manifolds. PNAS 95(15), 1998.
//
//   paper                     here
//   alive, close, far         accepted; in the queue; neither
//   T, the arrival time       distances_
//   u = T(B) - T(A)           `rise`, over |AB|
//   split of an obtuse angle  SplitAngle, into two Splits (section 4.2)

#include "geodesic/approximate/fast_marching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "approximate/seeds.h"
#include "mesh/file_unit.h"
#include "solver/queues/binary_heap.h"
#include "solver/queues/fwp_buckets.h"
#include "surface/plane_point.h"

namespace geodesic {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Between two polls, in faces: well below a millisecond.
constexpr uint32_t kPollPeriod = 4096;

// Through how many faces an obtuse angle is unfolded. Faces that are not
// needles need a few.
constexpr int kMostUnfolded = 64;

// Bucket widths of the untidy queue in mean edge lengths. What is accepted out
// of order is off by no more than a bucket's width, once along its way.
constexpr double kUntidyWidth = 1.0 / 16;

// Where a planar front that has these distances at (0, 0) and (length, 0)
// reaches (x, y); infinite if its ray into there does not come from between
// them.
double PlanarFront(double at_begin, double at_end, double length, double x,
                   double y) {
  const double rise = (at_end - at_begin) / length;
  if (!(std::abs(rise) < 1)) return kInfinity;
  const double climb = std::sqrt(1 - rise * rise);
  const double crossing = x * climb - y * rise;
  if (!(crossing >= 0 && crossing <= length * climb)) return kInfinity;
  return at_begin + rise * x + climb * y;
}

Tuning UntidyTuning(const Mesh& mesh) {
  const double h = mesh.mean_edge_length() > 0 ? mesh.mean_edge_length() : 1;
  // One bucket at a time, first in, first out.
  return {.bucket_width = kUntidyWidth * h,
          .max_batch = 1,
          .adaptive_batch = false};
}

}  // namespace

// One computation.
class FastMarching::March {
 public:
  explicit March(const FastMarching& marching)
      : marching_(marching),
        mesh_(marching.mesh()),
        distances_(mesh_.vertex_count(), kInfinity),
        is_accepted_(mesh_.vertex_count()) {}

  template <typename Queue>
  absl::Status Run(const std::vector<Seed>& seeds, Queue queue,
                   Checkpoint& checkpoint) {
    for (const Seed& seed : seeds) Relax(seed.vertex, seed.distance, queue);
    uint32_t accepted = 0;
    uint64_t faces = kPollPeriod;
    for (;;) {
      const uint32_t v = queue.Pop();
      const bool is_over = v == kNothing;
      if (is_over || faces >= kPollPeriod) {
        faces = 0;
        if (absl::Status status = checkpoint.Poll(
                {.vertices_reached = accepted,
                 .vertices = mesh_.vertex_count(),
                 .solver_bytes =
                     distances_.size() * (sizeof(double) + 1) + queue.bytes()});
            !status.ok() || is_over) {
          return status;
        }
      }
      ++faces;
      if (is_accepted_[v]) continue;
      is_accepted_[v] = true;
      ++accepted;
      faces += mesh_.Outgoing(v).size();
      Accept(v, queue);
    }
  }

  std::vector<double> TakeDistances() {
    for (double& d : distances_) d = ToFileUnit(mesh_, d);
    return std::move(distances_);
  }

 private:
  template <typename Queue>
  void Relax(uint32_t v, double distance, Queue& queue) {
    if (is_accepted_[v] || !(distance < distances_[v])) return;
    distances_[v] = distance;
    queue.Push(v, distance);
  }

  // Hands on the front from v, which was just accepted: across faces whose
  // other support is accepted too, then along edges. A front that comes across
  // a face is never later than along its edges, so the queue is spared those.
  template <typename Queue>
  void Accept(uint32_t v, Queue& queue) {
    for (const HalfEdge h : mesh_.Outgoing(v)) {
      const uint32_t to = mesh_.To(h), apex = mesh_.Apex(h);
      if (is_accepted_[to]) {
        CrossFace(h, v, to, apex, queue);
      } else if (is_accepted_[apex]) {
        CrossFace(Prev(h), apex, v, to, queue);
      }
    }
    if (!marching_.splits_.empty()) {
      for (uint32_t i = marching_.splits_begin_[v];
           i < marching_.splits_begin_[v + 1]; ++i) {
        FromSplit(v, marching_.splits_[marching_.splits_at_[i]], queue);
      }
    }
    for (const HalfEdge h : mesh_.Outgoing(v)) {
      Relax(mesh_.To(h), distances_[v] + mesh_.frame(h).length, queue);
      // The other edge at v leaves the face beyond it, if there is one.
      const HalfEdge back = Prev(h);
      if (mesh_.Twin(back) == kNoHalfEdge) {
        Relax(mesh_.From(back), distances_[v] + mesh_.frame(back).length,
              queue);
      }
    }
  }

  template <typename Queue>
  void CrossFace(HalfEdge h, uint32_t from, uint32_t to, uint32_t apex,
                 Queue& queue) {
    if (is_accepted_[apex] || marching_.is_split_[h]) return;
    const HalfEdgeFrame& frame = mesh_.frame(h);
    Relax(apex,
          PlanarFront(distances_[from], distances_[to], frame.length,
                      frame.apex_x, frame.apex_y),
          queue);
  }

  // From v, a support of the split, together with the other support or straight
  // to the corner.
  template <typename Queue>
  void FromSplit(uint32_t v, const Split& split, Queue& queue) {
    if (is_accepted_[split.corner]) return;
    const auto [begin, end] = split.supports;
    if (is_accepted_[v == begin ? end : begin]) {
      Relax(split.corner,
            PlanarFront(distances_[begin], distances_[end], split.length,
                        split.x, split.y),
            queue);
    }
    const double x = v == begin ? split.x : split.x - split.length;
    Relax(split.corner, distances_[v] + Norm({x, split.y}), queue);
  }

  const FastMarching& marching_;
  const Mesh& mesh_;
  std::vector<double> distances_;  // in the scaled unit
  std::vector<uint8_t> is_accepted_;
};

FastMarching::FastMarching(const Mesh& mesh, MarchingQueue queue)
    : PreparedMethod(mesh), queue_(queue), is_split_(mesh.half_edge_count()) {}

absl::StatusOr<std::shared_ptr<const FastMarching>> FastMarching::Prepare(
    const Mesh& mesh, MarchingQueue queue, Checkpoint& checkpoint) {
  std::shared_ptr<FastMarching> marching(new FastMarching(mesh, queue));
  for (HalfEdge h = 0; h < mesh.half_edge_count(); ++h) {
    if (h % kPollPeriod == 0) {
      if (absl::Status status =
              checkpoint.Poll({.vertices = mesh.vertex_count(),
                               .solver_bytes = marching->bytes()});
          !status.ok()) {
        return status;
      }
    }
    marching->SplitAngle(h);
  }
  marching->ListSplits();
  return marching;
}

// All in the frame of h. The section holds the directions from the apex C that
// make no obtuse angle with either side; a vertex D in there splits the angle
// into two that are not obtuse. If the unfolded vertex lies beside the section,
// the section goes on through one of the two sides behind.
void FastMarching::SplitAngle(HalfEdge h) {
  const HalfEdgeFrame& frame = mesh().frame(h);
  const PlanePoint c = {frame.apex_x, frame.apex_y};
  const PlanePoint a = {0, 0}, b = {frame.length, 0};
  if (!(Dot(a - c, b - c) < 0)) return;
  PlanePoint begin = a, end = b;  // of the side across which it is unfolded
  HalfEdge side = h;
  for (int i = 0; i < kMostUnfolded; ++i) {
    const HalfEdge beyond = mesh().Twin(side);
    if (beyond == kNoHalfEdge) return;
    // `beyond` runs from `end` to `begin`, and its face lies on its left.
    const HalfEdgeFrame& next = mesh().frame(beyond);
    if (!(next.length > 0)) return;
    const PlanePoint along = {(begin.x - end.x) / next.length,
                              (begin.y - end.y) / next.length};
    const PlanePoint d = {
        end.x + along.x * next.apex_x - along.y * next.apex_y,
        end.y + along.y * next.apex_x + along.x * next.apex_y};
    const bool near_a = Dot(b - c, d - c) < 0;
    const bool near_b = Dot(a - c, d - c) < 0;
    if (near_a && near_b) return;  // rounding: there is no such direction
    if (!near_a && !near_b) {
      const auto add = [&](uint32_t support, const PlanePoint& at) {
        const double length = Norm(d - at);
        if (!(length > 0)) return;
        const PlanePoint to_corner = c - at, to_d = d - at;
        splits_.push_back({.corner = mesh().Apex(h),
                           .supports = {support, mesh().Apex(beyond)},
                           .length = length,
                           .x = Dot(to_corner, to_d) / length,
                           .y = std::abs(Cross(to_corner, to_d)) / length});
      };
      add(mesh().From(h), a);
      add(mesh().To(h), b);
      is_split_[h] = true;
      return;
    }
    // Next(beyond) runs from `begin` to D, Prev(beyond) from D to `end`.
    side = near_a ? Prev(beyond) : Next(beyond);
    (near_a ? begin : end) = d;
  }
}

void FastMarching::ListSplits() {
  if (splits_.empty()) return;
  splits_begin_.assign(mesh().vertex_count() + 1, 0);
  for (const Split& split : splits_) {
    for (const uint32_t v : split.supports) ++splits_begin_[v + 1];
  }
  for (uint32_t v = 0; v < mesh().vertex_count(); ++v) {
    splits_begin_[v + 1] += splits_begin_[v];
  }
  splits_at_.resize(splits_begin_.back());
  std::vector<uint32_t> next(splits_begin_.begin(), splits_begin_.end() - 1);
  for (uint32_t i = 0; i < splits_.size(); ++i) {
    for (const uint32_t v : splits_[i].supports) splits_at_[next[v]++] = i;
  }
}

ApproximateMethod FastMarching::method() const {
  return queue_ == MarchingQueue::kHeap ? ApproximateMethod::kFmm
                                        : ApproximateMethod::kFmmUntidy;
}

absl::StatusOr<std::vector<double>> FastMarching::Compute(
    const ValidQuery& query, Checkpoint& checkpoint) const {
  const absl::StatusOr<std::vector<Seed>> seeds =
      SeedsOf(query, mesh(), method(), checkpoint);
  if (!seeds.ok()) return seeds.status();
  March march(*this);
  const Tuning tuning = UntidyTuning(mesh());
  absl::Status status = queue_ == MarchingQueue::kHeap
                            ? march.Run(*seeds, BinaryHeap(tuning), checkpoint)
                            : march.Run(*seeds, FwpBuckets(tuning), checkpoint);
  if (!status.ok()) return status;
  return march.TakeDistances();
}

uint64_t FastMarching::bytes() const {
  return sizeof(*this) + is_split_.capacity() / 8 +
         splits_.capacity() * sizeof(Split) +
         (splits_begin_.capacity() + splits_at_.capacity()) * sizeof(uint32_t);
}

}  // namespace geodesic
