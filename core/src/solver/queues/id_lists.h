// Many first-in-first-out lists of 32-bit ids that share their memory.

#ifndef GEODESIC_SOLVER_QUEUES_ID_LISTS_H_
#define GEODESIC_SOLVER_QUEUES_ID_LISTS_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace geodesic {

// Ids lie in chunks of half a cache line, recycled most recently freed first:
// memory goes with what is in the lists at once, not with what each of them has
// ever held.
class IdLists {
 public:
  explicit IdLists(size_t lists) : lists_(lists) {}

  bool IsEmpty(size_t list) const { return lists_[list].first == kNone; }

  void Append(size_t list, uint32_t id) {
    List& ids = lists_[list];
    if (ids.first == kNone) {
      ids.first = ids.last = Allocate();
    } else if (ids.in_last == kIdsPerChunk) {
      const uint32_t chunk = Allocate();
      chunks_[ids.last].next = chunk;
      ids.last = chunk;
      ids.in_last = 0;
    }
    chunks_[ids.last].ids[ids.in_last++] = id;
  }

  // Moves the ids of `list`, in order, to the end of `to`. Returns how many.
  size_t MoveTo(size_t list, std::vector<uint32_t>& to) {
    List& ids = lists_[list];
    const size_t before = to.size();
    for (uint32_t chunk = ids.first; chunk != kNone;) {
      const Chunk& from = chunks_[chunk];
      const bool is_last = chunk == ids.last;
      to.insert(to.end(), from.ids.begin(),
                from.ids.begin() + (is_last ? ids.in_last : kIdsPerChunk));
      const uint32_t next = is_last ? kNone : from.next;
      Free(chunk);
      chunk = next;
    }
    ids = {};
    return to.size() - before;
  }

  uint64_t bytes() const {
    return lists_.capacity() * sizeof(List) +
           chunks_.capacity() * sizeof(Chunk);
  }

 private:
  static constexpr uint32_t kNone = 0xffffffffu;
  static constexpr uint32_t kIdsPerChunk = 7;

  struct alignas(32) Chunk {
    std::array<uint32_t, kIdsPerChunk> ids;
    uint32_t next;  // of the list, or of those that are free
  };
  struct List {
    uint32_t first = kNone;
    uint32_t last = kNone;
    uint32_t in_last = 0;
  };

  uint32_t Allocate() {
    if (free_ == kNone) {
      chunks_.emplace_back();
      return static_cast<uint32_t>(chunks_.size() - 1);
    }
    const uint32_t chunk = free_;
    free_ = chunks_[chunk].next;
    return chunk;
  }
  void Free(uint32_t chunk) {
    chunks_[chunk].next = free_;
    free_ = chunk;
  }

  std::vector<List> lists_;
  std::vector<Chunk> chunks_;
  uint32_t free_ = kNone;  // the first chunk that is free
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_QUEUES_ID_LISTS_H_
