// Sparse symmetric matrices and their Cholesky factors, by SuiteSparse's
// CHOLMOD (Chen, Davis, Hager, Rajamanickam: Algorithm 887, ACM TOMS 35(3),
// 2008). Nobody else includes its header.
//
// Columns are eliminated one by one. CHOLMOD's supernodes would call a BLAS,
// whose bits differ from one to the next, and start OpenMP threads that nobody
// can forbid them; on meshes they are faster only beside a tuned BLAS.

#ifndef GEODESIC_APPROXIMATE_CHOLESKY_H_
#define GEODESIC_APPROXIMATE_CHOLESKY_H_

#include <cstdint>
#include <memory>
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

// A factor. Const functions are thread-safe.
class Cholesky {
 public:
  // How to eliminate with little fill: for all matrices of one pattern. Asks
  // the checkpoint once in between, after a tenth of a second or so for a
  // million unknowns. Errors: RESOURCE_EXHAUSTED; as `checkpoint`.
  class Order;
  static absl::StatusOr<std::shared_ptr<const Order>> Analyze(
      const SymmetricPattern& pattern, Checkpoint& checkpoint,
      const Progress& progress);

  // REQUIRES: the order is of this pattern; a value for each of its rows.
  // Tells the checkpoint of the progress with the factor's bytes, before it
  // takes them and then every few milliseconds. Errors: FAILED_PRECONDITION if
  // the matrix is not positive definite; RESOURCE_EXHAUSTED; whatever
  // `checkpoint` returns.
  static absl::StatusOr<Cholesky> Factorize(const SymmetricPattern& pattern,
                                            const Order& order,
                                            std::span<const double> values,
                                            Checkpoint& checkpoint,
                                            Progress progress);

  Cholesky(Cholesky&&) noexcept;
  Cholesky& operator=(Cholesky&&) noexcept;
  ~Cholesky();

  // By substitution. Asks the checkpoint between its parts, which take a
  // twentieth of a second for a million unknowns. Errors: RESOURCE_EXHAUSTED;
  // as `checkpoint`.
  absl::StatusOr<std::vector<double>> Solve(std::span<const double> right_side,
                                            Checkpoint& checkpoint,
                                            const Progress& progress) const;

  uint64_t bytes() const;

 private:
  class Factor;
  explicit Cholesky(std::unique_ptr<Factor> factor);

  std::unique_ptr<Factor> factor_;
};

}  // namespace geodesic

#endif  // GEODESIC_APPROXIMATE_CHOLESKY_H_
