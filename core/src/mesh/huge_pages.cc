#include "mesh/huge_pages.h"

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#endif

namespace geodesic {

#ifdef __linux__

void PreferHugePages(void* begin, size_t bytes) {
  // Less than this is not worth the call.
  constexpr size_t kHugePage = size_t{1} << 21;
  if (bytes < 2 * kHugePage) return;
  // The system takes whole pages only.
  const auto page = static_cast<uintptr_t>(sysconf(_SC_PAGESIZE));
  const uintptr_t address = reinterpret_cast<uintptr_t>(begin);
  const uintptr_t first = (address + page - 1) / page * page;
  madvise(reinterpret_cast<void*>(first), address + bytes - first,
          MADV_HUGEPAGE);
}

#else

void PreferHugePages(void*, size_t) {}

#endif

}  // namespace geodesic
