// How the lines of a matrix of distances cost least.

#ifndef GEODESIC_ROWS_MATRIX_SHAPE_H_
#define GEODESIC_ROWS_MATRIX_SHAPE_H_

#include <cstddef>
#include <cstdint>

namespace geodesic {

// Distances from `sources` places, a line for each, to `targets` others.
struct MatrixShape {
  uint64_t sources = 0;
  uint64_t targets = 0;
  // So many targets of each line are wanted, the nearest ones; at most all.
  uint64_t wanted = 0;
  // A field costs as much as so many searches (target_search.h); 0 where
  // nothing is searched for.
  size_t field_in_searches = 0;
};

// Whether a search for each target of a line costs less than a field that stops
// when the wanted ones are final. The targets lie anywhere: such a field covers
// as large a part of a whole one as they are of all. REQUIRES: targets > 0.
bool SearchingPays(const MatrixShape& shape);

// Whether the distances from each target to all sources, which are the same,
// cost less than half of what the lines would. REQUIRES: targets > 0.
bool TransposingPays(const MatrixShape& shape);

}  // namespace geodesic

#endif  // GEODESIC_ROWS_MATRIX_SHAPE_H_
