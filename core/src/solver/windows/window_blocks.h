// Where lists of windows wait until their half-edge is due.

#ifndef GEODESIC_SOLVER_WINDOWS_WINDOW_BLOCKS_H_
#define GEODESIC_SOLVER_WINDOWS_WINDOW_BLOCKS_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "solver/windows/window_columns.h"

namespace geodesic {

// A list at rest, in a chain of such lists; its columns lie behind it. Its
// distances are not kept.
struct WindowBlock {
  WindowBlock* next;
  uint32_t count;
  // Const, since PrefetchRest may read it while another thread has the block.
  const uint32_t log_room;
};

// Blocks of one size that are free, chained.
struct Magazine {
  WindowBlock* first = nullptr;
  uint32_t size = 0;
};

// The memory of blocks and what is free of it, for all threads of a
// computation. Thread-safe.
class BlockPool {
 public:
  // Memory for `words` doubles, kept until the pool goes.
  double* Allocate(size_t words);

  void Give(uint32_t log_room, const Magazine& magazine);
  // Empty if there is none.
  Magazine Take(uint32_t log_room);

  uint64_t bytes() const;

 private:
  mutable std::mutex mutex_;
  std::vector<std::unique_ptr<double[]>> chunks_;
  std::array<std::vector<Magazine>, 32> free_;  // by log_room
  uint64_t bytes_ = 0;
};

// Blocks for one thread, with room for powers of two; freed ones are reused.
// A block may be taken by another thread than the one that has stored it.
// Memory goes from one to another by whole magazines (Bonwick, Adams:
// Magazines and Vmem. USENIX 2001), so the pool is rarely asked.
class WindowBlocks {
 public:
  explicit WindowBlocks(BlockPool& pool) : pool_(pool) {}

  // Copies windows to a block of their own, the last of its chain.
  WindowBlock* Store(const WindowColumns& windows);
  // Appends the windows of a block to `windows`, without their distances.
  static void Copy(const WindowBlock* block, WindowColumns& windows);
  // The same, and frees the block. Returns the next of its chain.
  WindowBlock* Take(WindowBlock* block, WindowColumns& windows);
  // Frees a chain of blocks.
  void Drop(WindowBlock* block);

  // Fetches the begin of a block into cache, then (once that has arrived) the
  // rest. Another thread may be using the block.
  static void Prefetch(const WindowBlock* block) { PrefetchLines(block, 0, 3); }
  static void PrefetchRest(const WindowBlock* block);

 private:
  static constexpr uint32_t kLogLeastRoom = 2;
  static constexpr size_t kHeaderWords = sizeof(WindowBlock) / sizeof(double);
  static constexpr size_t kChunkWords = 8192;

  // What is free of one size: blocks come from `open` and go there; `full` has
  // none or as many as a magazine holds.
  struct Free {
    Magazine open, full;
  };

  static size_t WordsOf(uint32_t log_room) {
    return kHeaderWords + (size_t{11} << log_room) / 2;
  }
  // How many free blocks make a magazine.
  static uint32_t MagazineSize(uint32_t log_room) {
    return static_cast<uint32_t>(kChunkWords / 2 / WordsOf(log_room) + 1);
  }
  static double* WindowsOf(WindowBlock* block) {
    return reinterpret_cast<double*>(block) + kHeaderWords;
  }
  static const double* WindowsOf(const WindowBlock* block) {
    return reinterpret_cast<const double*>(block) + kHeaderWords;
  }
  static void PrefetchLines(const WindowBlock* block, size_t from, size_t to) {
    for (size_t line = from; line < to; ++line) {
      __builtin_prefetch(reinterpret_cast<const double*>(block) + 8 * line);
    }
  }
  WindowBlock* New(uint32_t log_room);
  void Release(WindowBlock* block);

  BlockPool& pool_;
  double* next_ = nullptr;  // of the open chunk
  size_t words_left_ = 0;
  std::array<Free, 32> free_;  // by log_room
};

}  // namespace geodesic

#endif  // GEODESIC_SOLVER_WINDOWS_WINDOW_BLOCKS_H_
