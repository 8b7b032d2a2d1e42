// Ying, Wang, He: Saddle vertex graph. ACM TOG 32(6), 2013.
//
//   paper              here
//   K                  SaddleGraphOptions::neighbours
//   direct geodesic    LocalSearch::Near with is_direct: an Arc

#include "geodesic/approximate/saddle_vertex_graph.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "approximate/local_search.h"
#include "approximate/seeds.h"
#include "geodesic/solve_options.h"
#include "geodesic_types/field_path.h"
#include "mesh/file_unit.h"
#include "solver/queues/binary_heap.h"
#include "solver/queues/fwp_buckets.h"
#include "solver/rules/ch_rule.h"
#include "solver/rules/list_rule.h"
#include "solver/thread_team.h"
#include "solver/work_meter.h"
#include "surface/straight_line.h"
#include "tolerances.h"

namespace geodesic {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr uint32_t kMostNeighbours = 10000;

// Vertices that a thread takes at a time: a millisecond's work.
constexpr uint32_t kShare = 16;
// Arcs that are sorted in the time of a step of WorkMeter.
constexpr uint64_t kArcsAStep = 8;

// For searches of K vertices: buckets in mean edge lengths, and what an
// iteration takes of them. From 1/32 to 1 and from 16 to 256 they take the same
// time.
constexpr double kBucketWidth = 1.0 / 2;
constexpr uint32_t kMaxBatch = 64;

using Arc = SaddleVertexGraph::Arc;

absl::Status CheckMesh(const Mesh& mesh) {
  const auto refuse = [](const char* what) {
    return absl::InvalidArgumentError(absl::StrCat("svg: ", what));
  };
  if (mesh.HasNonManifoldEdges()) {
    return refuse(
        "the mesh has edges of three faces or more; ask fmm, heat or an exact "
        "algorithm");
  }
  if (mesh.HasCollapsedFaces()) {
    return refuse(
        "the mesh has faces without area; ask fmm, heat or an exact algorithm");
  }
  return absl::OkStatus();
}

// Finds the arcs of all vertices, in threads that take a share after the other.
template <typename Search>
class Builder {
 public:
  Builder(const Mesh& mesh, const SaddleGraphOptions& options,
          const Tuning& tuning, Checkpoint& checkpoint)
      : mesh_(mesh),
        options_(options),
        tuning_(tuning),
        checkpoint_(checkpoint),
        arcs_(mesh.vertex_count()) {}

  absl::StatusOr<std::vector<std::vector<Arc>>> Run() {
    ThreadTeam team(options_.threads);
    team.Run([this](uint32_t member) { Work(member); });
    if (!status_.ok()) return status_;
    return std::move(arcs_);
  }

 private:
  void Work(uint32_t member) {
    if (IsStopped(member, 0)) return;
    Search search(mesh_, tuning_);
    const uint32_t count = mesh_.vertex_count();
    for (;;) {
      const uint32_t first = next_.fetch_add(kShare);
      if (first >= count) return;
      const uint32_t last = std::min(first + kShare, count);
      for (uint32_t v = first; v < last; ++v) {
        const auto near = search.Around(v, options_.neighbours, [&] {
          return IsStopped(member, search.bytes());
        });
        if (is_stopped_) return;
        for (const auto& [w, distance, is_direct] : near) {
          if (is_direct) arcs_[v].push_back({w, static_cast<float>(distance)});
        }
        arcs_[v].shrink_to_fit();
        arc_bytes_ += arcs_[v].capacity() * sizeof(Arc);
      }
      done_ += last - first;
      if (IsStopped(member, search.bytes())) return;
    }
  }

  // The calling thread asks the checkpoint; the others see what it says.
  bool IsStopped(uint32_t member, uint64_t search_bytes) {
    if (member == 0) {
      status_ = checkpoint_.Poll(
          {.vertices_reached = done_,
           .vertices = mesh_.vertex_count(),
           .solver_bytes = search_bytes * options_.threads + arc_bytes_ +
                           arcs_.capacity() * sizeof(std::vector<Arc>)});
      if (!status_.ok()) is_stopped_ = true;
    }
    return is_stopped_;
  }

  const Mesh& mesh_;
  const SaddleGraphOptions& options_;
  const Tuning& tuning_;
  Checkpoint& checkpoint_;
  std::atomic<uint32_t> next_ = 0;  // vertex that nobody has taken
  std::atomic<uint32_t> done_ = 0;
  std::atomic<uint64_t> arc_bytes_ = 0;
  std::atomic<bool> is_stopped_ = false;
  absl::Status status_;                 // of the calling thread
  std::vector<std::vector<Arc>> arcs_;  // by vertex
};

absl::StatusOr<std::vector<std::vector<Arc>>> FindArcs(
    const Mesh& mesh, const SaddleGraphOptions& options,
    Checkpoint& checkpoint) {
  const double h = mesh.mean_edge_length() > 0 ? mesh.mean_edge_length() : 1;
  const Tuning tuning{.bucket_width = kBucketWidth * h, .max_batch = kMaxBatch};
  if (options.builder == SaddleGraphBuilder::kIch) {
    return Builder<LocalSearch<IchRule, BinaryHeap>>(mesh, options, tuning,
                                                     checkpoint)
        .Run();
  }
  return Builder<LocalSearch<ListRule, FwpBuckets>>(mesh, options, tuning,
                                                    checkpoint)
      .Run();
}

// How many arcs ahead of its use what they lead to is fetched into cache.
constexpr size_t kAhead = 6;

// Heaps have the least at the front.
constexpr auto kAfter = [](const auto& a, const auto& b) {
  return a.key != b.key ? a.key > b.key : a.vertex > b.vertex;
};

}  // namespace

absl::Status SaddleVertexGraph::Check(const SaddleGraphOptions& options) {
  if (options.neighbours == 0 || options.neighbours > kMostNeighbours) {
    return InvalidField("neighbours",
                        absl::StrCat("svg: K ", options.neighbours,
                                     " is not in [1, ", kMostNeighbours, "]"));
  }
  if (options.threads == 0 || options.threads > kMostSolveThreads) {
    return InvalidField(
        "threads", absl::StrCat("svg: threads ", options.threads,
                                " is not in [1, ", kMostSolveThreads, "]"));
  }
  return absl::OkStatus();
}

absl::StatusOr<std::shared_ptr<const SaddleVertexGraph>>
SaddleVertexGraph::Prepare(const Mesh& mesh, const SaddleGraphOptions& options,
                           Checkpoint& checkpoint) {
  absl::Status status = Check(options);
  if (status.ok()) status = CheckMesh(mesh);
  if (!status.ok()) return status;
  absl::StatusOr<std::vector<std::vector<Arc>>> found =
      FindArcs(mesh, options, checkpoint);
  if (!found.ok()) return found.status();
  std::shared_ptr<SaddleVertexGraph> graph(new SaddleVertexGraph(mesh));
  status = graph->Join(*found, checkpoint);
  if (!status.ok()) return status;
  return graph;
}

absl::StatusOr<std::shared_ptr<const SaddleVertexGraph>>
SaddleVertexGraph::FromArcs(const Mesh& mesh, std::vector<uint64_t> offsets,
                            std::vector<Arc> arcs) {
  const uint32_t vertices = mesh.vertex_count();
  const bool has_offsets =
      offsets.size() == uint64_t{vertices} + 1 && offsets.front() == 0 &&
      offsets.back() == arcs.size() && std::ranges::is_sorted(offsets);
  const auto is_arc = [&](const Arc& arc) {
    return arc.to < vertices && arc.length >= 0 && std::isfinite(arc.length);
  };
  if (!has_offsets || !std::ranges::all_of(arcs, is_arc)) {
    return absl::DataLossError("the arcs are no graph on this mesh");
  }
  std::shared_ptr<SaddleVertexGraph> graph(new SaddleVertexGraph(mesh));
  graph->begin_ = std::move(offsets);
  graph->arcs_ = std::move(arcs);
  return graph;
}

// Every arc at both its ends, and the edges of the mesh, which lead everywhere
// that paths lead.
absl::Status SaddleVertexGraph::Join(const std::vector<std::vector<Arc>>& found,
                                     Checkpoint& checkpoint) {
  uint64_t found_bytes = found.capacity() * sizeof(std::vector<Arc>);
  for (const std::vector<Arc>& arcs : found) {
    found_bytes += arcs.capacity() * sizeof(Arc);
  }
  const auto poll = [&] {
    return checkpoint.Poll({.vertices_reached = mesh().vertex_count(),
                            .vertices = mesh().vertex_count(),
                            .solver_bytes = found_bytes + bytes()});
  };
  WorkMeter meter(poll);
  const auto for_each = [&](auto visit) {
    for (uint32_t v = 0; v < found.size() && meter.Do(); ++v) {
      for (const Arc& arc : found[v]) visit(v, arc.to, arc.length);
    }
    for (HalfEdge h = 0; h < mesh().half_edge_count() && meter.Do(); ++h) {
      visit(mesh().From(h), mesh().To(h),
            static_cast<float>(mesh().frame(h).length));
    }
    return meter.status();
  };
  begin_.assign(mesh().vertex_count() + 1, 0);
  absl::Status status = for_each([this](uint32_t v, uint32_t w, float) {
    ++begin_[v + 1];
    ++begin_[w + 1];
  });
  if (!status.ok()) return status;
  for (size_t v = 0; v + 1 < begin_.size(); ++v) begin_[v + 1] += begin_[v];
  arcs_.resize(begin_.back());
  std::vector<uint64_t> next(begin_.begin(), begin_.end() - 1);
  status = for_each([&](uint32_t v, uint32_t w, float length) {
    arcs_[next[v]++] = {w, length};
    arcs_[next[w]++] = {v, length};
  });
  if (!status.ok()) return status;
  // Of arcs between the same two only the shortest stays.
  uint64_t kept = 0;
  for (uint32_t v = 0; v < mesh().vertex_count(); ++v) {
    const auto first = arcs_.begin() + static_cast<std::ptrdiff_t>(begin_[v]);
    const auto last =
        arcs_.begin() + static_cast<std::ptrdiff_t>(begin_[v + 1]);
    if (!meter.Do(1 + (last - first) / kArcsAStep)) return meter.status();
    std::sort(first, last, [](const Arc& a, const Arc& b) {
      return a.to != b.to ? a.to < b.to : a.length < b.length;
    });
    begin_[v] = kept;
    for (auto arc = first; arc != last; ++arc) {
      if (kept > begin_[v] && arcs_[kept - 1].to == arc->to) continue;
      arcs_[kept++] = *arc;
    }
  }
  begin_.back() = kept;
  arcs_.resize(kept);
  arcs_.shrink_to_fit();
  return poll();
}

ApproximateMethod SaddleVertexGraph::method() const {
  return ApproximateMethod::kSvg;
}

absl::StatusOr<std::vector<double>> SaddleVertexGraph::Compute(
    const ValidQuery& query, Checkpoint& checkpoint) const {
  const absl::StatusOr<std::vector<Seed>> seeds =
      SeedsOf(query, mesh(), method(), checkpoint);
  if (!seeds.ok()) return seeds.status();
  std::vector<double> distances(mesh().vertex_count(), kInfinity);
  std::vector<uint8_t> is_settled(mesh().vertex_count());
  BinaryHeap queue{Tuning()};
  for (const auto& [v, distance] : *seeds) {
    distances[v] = distance;
    queue.Push(v, distance);
  }
  uint32_t settled = 0;
  const auto poll = [&] {
    return checkpoint.Poll(
        {.vertices_reached = settled,
         .vertices = mesh().vertex_count(),
         .solver_bytes =
             mesh().vertex_count() * (sizeof(double) + 1) + queue.bytes()});
  };
  if (absl::Status status = poll(); !status.ok()) return status;
  WorkMeter meter(poll);
  for (;;) {
    const uint32_t v = queue.Pop();
    if (v == kNothing) break;
    if (!meter.Do()) return meter.status();
    if (is_settled[v]) continue;
    if (!meter.Do(ArcsOf(v).size() / kArcsAStep)) return meter.status();
    is_settled[v] = true;
    ++settled;
    for (const Arc& arc : ArcsOf(v)) {
      const double distance = distances[v] + arc.length;
      if (!(distance < distances[arc.to])) continue;
      distances[arc.to] = distance;
      queue.Push(arc.to, distance);
    }
  }
  if (absl::Status status = poll(); !status.ok()) return status;
  for (double& d : distances) d = ToFileUnit(mesh(), d);
  return distances;
}

uint64_t SaddleVertexGraph::bytes() const {
  return sizeof(*this) + begin_.capacity() * sizeof(uint64_t) +
         arcs_.capacity() * sizeof(Arc);
}

SaddleGraphSearch::SaddleGraphSearch(const SaddleVertexGraph& graph)
    : graph_(graph), states_(graph.mesh().vertex_count()) {}

absl::StatusOr<double> SaddleGraphSearch::Distance(uint32_t from, uint32_t to,
                                                   const Landmarks* landmarks,
                                                   Checkpoint& checkpoint) {
  const Mesh& mesh = graph_.mesh();
  for (const uint32_t v : reached_) states_[v] = {};
  reached_.clear();
  waiting_.clear();
  expanded_ = 0;
  const bool has_landmarks = landmarks != nullptr && landmarks->count() > 0;
  const Landmarks::Place place = has_landmarks
                                     ? landmarks->PlaceOf(VertexPoint{to}, mesh)
                                     : Landmarks::Place();
  const ScaledDifference difference(mesh.scale_exponent());
  const Point& target = mesh.positions()[to];
  const auto reach = [&](uint32_t v, double distance) {
    State& state = states_[v];
    if (!(distance < state.distance)) return;
    if (std::isinf(state.distance)) {
      reached_.push_back(v);
      state.bound = Norm(difference(mesh.positions()[v], target));
      if (has_landmarks) {
        state.bound = std::max(state.bound, landmarks->LowerBound(v, place));
      }
    }
    state.distance = distance;
    waiting_.push_back({distance + state.bound, v});
    std::push_heap(waiting_.begin(), waiting_.end(), kAfter);
  };
  const auto poll = [&] {
    return checkpoint.Poll({.vertices_reached = reached_.size(),
                            .vertices = mesh.vertex_count(),
                            .solver_bytes = bytes()});
  };
  WorkMeter meter(poll);
  reach(from, 0);
  while (!waiting_.empty()) {
    if (!meter.Do()) return meter.status();
    const auto [key, v] = waiting_.front();
    // Bounds are those of exact distances, which arcs are not shorter than but
    // for rounding.
    if (key >= states_[to].distance * (1 + kArcRounding)) break;
    std::pop_heap(waiting_.begin(), waiting_.end(), kAfter);
    waiting_.pop_back();
    const State state = states_[v];
    if (key > state.distance + state.bound) continue;
    ++expanded_;
    const std::span<const Arc> arcs = graph_.ArcsOf(v);
    if (!meter.Do(arcs.size() / kArcsAStep)) return meter.status();
    for (size_t i = 0; i < arcs.size(); ++i) {
      if (i + 2 * kAhead < arcs.size()) {
        __builtin_prefetch(&states_[arcs[i + 2 * kAhead].to]);
      }
      if (i + kAhead < arcs.size()) {
        const uint32_t next = arcs[i + kAhead].to;
        if (std::isinf(states_[next].distance)) {
          __builtin_prefetch(&mesh.positions()[next]);
          if (has_landmarks) __builtin_prefetch(&landmarks->rows()[next]);
        }
      }
      reach(arcs[i].to, state.distance + arcs[i].length);
    }
  }
  return ToFileUnit(mesh, states_[to].distance);
}

uint64_t SaddleGraphSearch::bytes() const {
  return states_.capacity() * sizeof(State) +
         reached_.capacity() * sizeof(uint32_t) +
         waiting_.capacity() * sizeof(Waiting);
}

}  // namespace geodesic
