// Cuts the graph of a sparse symmetric matrix into parts that touch each other
// nowhere: an order that eliminates the parts first and what lay between them
// last leaves little fill.
//
// George, Liu: An automatic nested dissection algorithm for irregular finite
// element problems. SIAM Journal on Numerical Analysis 15(5), 1978.

#ifndef GEODESIC_APPROXIMATE_DISSECTION_H_
#define GEODESIC_APPROXIMATE_DISSECTION_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"

namespace geodesic {

// Where the entries of a symmetric matrix are: column after column those on and
// above the diagonal, rows in order, so that the diagonal is each column's
// last. Matrices of one pattern differ in their values alone.
struct SymmetricPattern {
  std::vector<int32_t> column_begin;  // size + 1
  std::vector<int32_t> rows;

  uint64_t size() const { return column_begin.size() - 1; }
};

struct Dissection {
  struct Part {
    size_t begin;  // in the order
    size_t end;
  };

  // All numbers of columns, in the order of elimination. Between two columns of
  // different parts there is no entry; columns of no part come after those of
  // the parts that they divide.
  std::vector<int32_t> order;
  std::vector<Part> parts;

  std::span<int32_t> ColumnsOf(const Part& part) {
    return std::span(order).subspan(part.begin, part.end - part.begin);
  }
};

// Cuts until no part has more than `most` columns, or none can be cut in two
// along few columns: where nearly all are neighbours of one. O(n log n) for
// matrices of meshes. Errors: whatever `checkpoint` returns, which is told of
// the progress with the bytes that are used, every few milliseconds.
absl::StatusOr<Dissection> Dissect(const SymmetricPattern& pattern, size_t most,
                                   Checkpoint& checkpoint, Progress progress);

// Where the entries between these columns are, numbered as they stand here.
// `numbers`: of as many as the pattern has columns, all -1; as it was
// afterwards. O(entries of the columns, twice).
SymmetricPattern PatternOf(const SymmetricPattern& pattern,
                           std::span<const int32_t> columns,
                           std::vector<int32_t>& numbers);

}  // namespace geodesic

#endif  // GEODESIC_APPROXIMATE_DISSECTION_H_
