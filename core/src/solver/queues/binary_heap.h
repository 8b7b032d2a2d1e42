// The priority queue of MMP and ICH: always the least label next.

#ifndef GEODESIC_SOLVER_QUEUES_BINARY_HEAP_H_
#define GEODESIC_SOLVER_QUEUES_BINARY_HEAP_H_

#include <algorithm>
#include <cstdint>
#include <vector>

#include "solver/queues/queue.h"

namespace geodesic {

// A contiguous binary heap of 16-byte entries (the standard library's sifts,
// which move a hole instead of swapping). Ties pop in order of id. O(log n).
class BinaryHeap {
 public:
  static constexpr bool kStrict = true;

  explicit BinaryHeap(const Tuning&) {}

  void Push(uint32_t id, double label) {
    heap_.push_back({label, id});
    std::push_heap(heap_.begin(), heap_.end(), After());
  }

  uint32_t Pop() {
    if (heap_.empty()) return kNothing;
    std::pop_heap(heap_.begin(), heap_.end(), After());
    const Entry top = heap_.back();
    heap_.pop_back();
    settled_ = std::max(settled_, top.label);
    ++iterations_;
    return top.id;
  }

  uint32_t Upcoming(uint32_t k) const {
    return k == 1 && !heap_.empty() ? heap_.front().id : kNothing;
  }

  void Restart() { settled_ = 0; }
  // Forgets all ids, and restarts. O(1).
  void Clear() {
    heap_.clear();
    iterations_ = 0;
    Restart();
  }

  double popped_label() const { return settled_; }

  double SettledRadius() const {
    return heap_.empty() ? settled_ : std::max(settled_, heap_.front().label);
  }
  uint64_t size() const { return heap_.size(); }
  uint64_t iterations() const { return iterations_; }
  uint64_t bytes() const { return heap_.capacity() * sizeof(Entry); }

 private:
  struct Entry {
    double label;
    uint32_t id;
  };

  struct After {
    bool operator()(const Entry& a, const Entry& b) const {
      return a.label != b.label ? a.label > b.label : a.id > b.id;
    }
  };

  std::vector<Entry> heap_;
  double settled_ = 0;
  uint64_t iterations_ = 0;
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_QUEUES_BINARY_HEAP_H_
