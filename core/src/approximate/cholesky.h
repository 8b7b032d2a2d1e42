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
#include "approximate/dissection.h"
#include "geodesic/checkpoint.h"

namespace geodesic {

// A factor. Const functions are thread-safe.
class Cholesky {
 public:
  // How to eliminate with little fill: for all matrices of one pattern. It is
  // cut into parts of at most `most` unknowns, each ordered by AMD: asks the
  // checkpoint every hundredth of a second or so. Errors: RESOURCE_EXHAUSTED;
  // as `checkpoint`.
  class Order;
  static constexpr size_t kMostAtOnce = size_t{1} << 15;
  static absl::StatusOr<std::shared_ptr<const Order>> Analyze(
      const SymmetricPattern& pattern, Checkpoint& checkpoint,
      const Progress& progress, size_t most = kMostAtOnce);

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
