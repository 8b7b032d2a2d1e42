// How the rows of a matrix of distances, one for each of several sources, cost
// least, and what each of them keeps.

#ifndef GEODESIC_MATRIX_ROWS_H_
#define GEODESIC_MATRIX_ROWS_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace geodesic {

// Distances from `sources` places, a row for each, to `targets` others.
struct MatrixShape {
  uint64_t sources = 0;
  uint64_t targets = 0;
  // So many targets of each row are wanted, the nearest ones; at most all.
  uint64_t wanted = 0;
  // A field costs as much as so many searches (target_search.h); 0 where
  // nothing is searched for.
  size_t field_in_searches = 0;
};

// Whether a search for each target of a row costs less than a field that stops
// when the wanted ones are final. The targets lie anywhere: such a field covers
// as large a part of a whole one as they are of all. REQUIRES: targets > 0.
bool SearchingPays(const MatrixShape& shape);

// Whether the distances from each target to all sources, which are the same,
// cost less than half of what the rows would. They are there when the last of
// them is, where rows come one by one. REQUIRES: targets > 0.
bool TransposingPays(const MatrixShape& shape);

// The numbers of the `count` least of the finite values, in their order; equal
// ones in that of their numbers. O(n log count).
std::vector<uint32_t> NearestOf(std::span<const double> values, uint64_t count);

}  // namespace geodesic

#endif  // GEODESIC_MATRIX_ROWS_H_
