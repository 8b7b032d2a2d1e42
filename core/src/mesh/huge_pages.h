// Large arrays in large pages.

#ifndef GEODESIC_MESH_HUGE_PAGES_H_
#define GEODESIC_MESH_HUGE_PAGES_H_

#include <cstddef>
#include <memory>

namespace geodesic {

// Asks the system for large pages where this memory spans whole ones. Fresh
// memory comes a page at a time, which in small pages costs more than writing
// it. A wish: where it cannot be granted, nothing changes.
void PreferHugePages(void* begin, size_t bytes);

// `count` values that are still to be written.
template <typename T>
std::unique_ptr<T[]> MakeLargeArray(size_t count) {
  auto array = std::make_unique_for_overwrite<T[]>(count);
  PreferHugePages(array.get(), count * sizeof(T));
  return array;
}

}  // namespace geodesic

#endif  // GEODESIC_MESH_HUGE_PAGES_H_
