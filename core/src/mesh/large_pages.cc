#include "mesh/large_pages.h"

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>
#endif

#include <cstdint>

namespace geodesic {

void AskForLargePages([[maybe_unused]] void* begin,
                      [[maybe_unused]] size_t bytes) {
#ifdef __linux__
  // Less than this is not worth the call.
  constexpr size_t kLargePage = size_t{1} << 21;
  if (bytes < 2 * kLargePage) return;
  // The system takes whole pages only.
  const auto page = static_cast<uintptr_t>(sysconf(_SC_PAGESIZE));
  const auto address = reinterpret_cast<uintptr_t>(begin);
  const uintptr_t first = (address + page - 1) / page * page;
  madvise(reinterpret_cast<void*>(first), address + bytes - first,
          MADV_HUGEPAGE);
#endif
}

}  // namespace geodesic
