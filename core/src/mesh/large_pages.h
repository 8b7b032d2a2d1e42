// Large arrays in large pages. Fresh memory comes a page at a time, which in
// small pages costs more than writing it.

#ifndef GEODESIC_MESH_LARGE_PAGES_H_
#define GEODESIC_MESH_LARGE_PAGES_H_

#include <cstddef>
#include <memory>
#include <vector>

namespace geodesic {

// Asks the system for large pages where the bytes span whole ones, before they
// are written. A wish: where it cannot be granted, nothing changes.
void AskForLargePages(void* begin, size_t bytes);

// Memory for `count` values that are still to be written.
template <typename T>
std::unique_ptr<T[]> MakeLargeArray(size_t count) {
  auto array = std::make_unique_for_overwrite<T[]>(count);
  AskForLargePages(array.get(), count * sizeof(T));
  return array;
}

// Room for `count` values in an empty vector.
template <typename T>
void ReserveLarge(size_t count, std::vector<T>& vector) {
  vector.reserve(count);
  AskForLargePages(vector.data(), count * sizeof(T));
}

template <typename T>
std::vector<T> MakeLargeVector(size_t count) {
  std::vector<T> vector;
  ReserveLarge(count, vector);
  vector.resize(count);
  return vector;
}

}  // namespace geodesic

#endif  // GEODESIC_MESH_LARGE_PAGES_H_
