// What a queue of windows is. A queue knows 32-bit numbers and labels, nothing
// of windows: rules and queues combine freely.

#ifndef GEODESIC_SOLVER_QUEUES_QUEUE_H_
#define GEODESIC_SOLVER_QUEUES_QUEUE_H_

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geodesic/solve_options.h"

namespace geodesic {

// Numbers with this bit stand for pseudo-source events (the rest is the
// vertex), the others for windows.
inline constexpr uint32_t kVertexEvent = 0x80000000u;
inline constexpr uint32_t kNothing = 0xffffffffu;

// Push(id, label): label is finite and not below the label of what was popped
//   last by more than rounding.
// Pop(): the next id, kNothing when empty.
// Upcoming(k): the id that the k-th Pop from now will give, if that is known
//   and stays likely; kNothing otherwise. A hint for prefetching.
// Restart(): labels may begin anew, from 0. REQUIRES: the queue is empty.
// SettledRadius(): a lower bound on every label pending, never decreasing.
// size(): ids in the queue. iterations(): batches begun.
// kStrict: ids leave in the order of their labels; popped_label() is that of
//   the last. Otherwise others may as well go along with the one popped.
template <typename Q>
concept WindowQueue = requires(Q queue, const Q& view, uint32_t id,
                               double label) {
  queue.Push(id, label);
  { queue.Pop() } -> std::same_as<uint32_t>;
  { view.Upcoming(1) } -> std::same_as<uint32_t>;
  queue.Restart();
  { view.SettledRadius() } -> std::same_as<double>;
  { view.size() } -> std::same_as<uint64_t>;
  { view.iterations() } -> std::same_as<uint64_t>;
  { Q::kStrict } -> std::convertible_to<bool>;
  { view.bytes() } -> std::same_as<uint64_t>;
};

// Moves to `ids` the next id and those after it whose order the queue knows
// already, `most` of them or fewer; none if the queue is empty.
template <WindowQueue Queue>
void PopTogether(Queue& queue, size_t most, std::vector<uint32_t>& ids) {
  ids.clear();
  do {
    const uint32_t id = queue.Pop();
    if (id == kNothing) return;
    ids.push_back(id);
  } while (ids.size() < most && queue.Upcoming(1) != kNothing);
}

// Steps between two polls: events and the faces around their vertices, windows
// that were propagated or that were made of these, whichever are most: one may
// lead into very many faces. A millisecond of work at the most, but where there
// are very many at one half-edge.
inline constexpr uint64_t kWorkBetweenPolls = 2048;

// What an anchor counts for beside the faces that it looks at: it may pass all
// windows of a half-edge, where a face holds very many.
inline constexpr uint64_t kStepsOfAnchor = kWorkBetweenPolls / 32;

// What queues and rules may know about the mesh and the caller's wishes
// (solve_options.h).
struct Tuning {
  double bucket_width = 1;  // in the mesh's scaled unit
  uint32_t max_batch = SolveOptions().max_batch;
  bool adaptive_batch = true;
  uint32_t threads = 1;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_QUEUES_QUEUE_H_
