#include "approximate/cholesky.h"

#include <cholmod.h>

#include <utility>

#include "absl/status/status.h"

namespace geodesic {
namespace {

// CHOLMOD's settings, errors and scratch, for one thread at a time.
class Workspace {
 public:
  Workspace() {
    cholmod_start(&common_);
    common_.print = 0;
    common_.supernodal = CHOLMOD_SIMPLICIAL;
    // METIS makes half the fill on large even meshes, but draws from rand(),
    // which other threads may do meanwhile.
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_AMD;
  }
  ~Workspace() { cholmod_finish(&common_); }
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  cholmod_common* get() { return &common_; }

  // Of what was done last.
  absl::Status status() const {
    if (common_.status == CHOLMOD_NOT_POSDEF ||
        common_.status == CHOLMOD_DSMALL) {
      return absl::FailedPreconditionError("a matrix is not positive definite");
    }
    if (common_.status == CHOLMOD_OUT_OF_MEMORY ||
        common_.status == CHOLMOD_TOO_LARGE) {
      return absl::ResourceExhaustedError(
          "the factors of a matrix do not fit into memory");
    }
    if (common_.status < CHOLMOD_OK) {
      return absl::InternalError("CHOLMOD refuses a matrix");
    }
    return absl::OkStatus();
  }

 private:
  cholmod_common common_;
};

// CHOLMOD reads it only.
template <typename T>
void* Writable(const T* values) {
  return const_cast<T*>(values);
}

cholmod_sparse MatrixOf(const SymmetricPattern& pattern, const double* values) {
  static_assert(sizeof(int) == sizeof(int32_t));
  cholmod_sparse matrix{};
  matrix.nrow = matrix.ncol = pattern.size();
  matrix.nzmax = pattern.rows.size();
  matrix.p = Writable(pattern.column_begin.data());
  matrix.i = Writable(pattern.rows.data());
  matrix.x = Writable(values);
  matrix.stype = 1;  // the upper triangle
  matrix.itype = CHOLMOD_INT;
  matrix.xtype = values == nullptr ? CHOLMOD_PATTERN : CHOLMOD_REAL;
  matrix.dtype = CHOLMOD_DOUBLE;
  matrix.sorted = 1;
  matrix.packed = 1;
  return matrix;
}

}  // namespace

class Cholesky::Factor {
 public:
  Factor() = default;
  ~Factor() { cholmod_free_factor(&factor_, workspace_.get()); }
  Factor(const Factor&) = delete;
  Factor& operator=(const Factor&) = delete;

  cholmod_factor*& get() { return factor_; }
  // Solving does not change it.
  cholmod_factor* get() const { return factor_; }
  Workspace& workspace() { return workspace_; }

  uint64_t bytes() const {
    // By column: the permutation, counts, begins and links; then the entries.
    return factor_->n * 6 * sizeof(int32_t) +
           factor_->nzmax * (sizeof(int32_t) + sizeof(double));
  }

 private:
  Workspace workspace_;
  cholmod_factor* factor_ = nullptr;
};

class Cholesky::Order : public Cholesky::Factor {};

absl::StatusOr<std::shared_ptr<const Cholesky::Order>> Cholesky::Analyze(
    const SymmetricPattern& pattern) {
  auto order = std::make_shared<Order>();
  cholmod_sparse matrix = MatrixOf(pattern, nullptr);
  order->get() = cholmod_analyze(&matrix, order->workspace().get());
  if (absl::Status status = order->workspace().status(); !status.ok()) {
    return status;
  }
  return order;
}

absl::StatusOr<Cholesky> Cholesky::Factorize(const SymmetricPattern& pattern,
                                             const Order& order,
                                             std::span<const double> values) {
  auto factor = std::make_unique<Factor>();
  Workspace& workspace = factor->workspace();
  factor->get() = cholmod_copy_factor(order.get(), workspace.get());
  if (absl::Status status = workspace.status(); !status.ok()) return status;
  cholmod_sparse matrix = MatrixOf(pattern, values.data());
  cholmod_factorize(&matrix, factor->get(), workspace.get());
  if (absl::Status status = workspace.status(); !status.ok()) return status;
  // Scratch that solving does not need.
  cholmod_free_work(workspace.get());
  return Cholesky(std::move(factor));
}

Cholesky::Cholesky(std::unique_ptr<Factor> factor)
    : factor_(std::move(factor)) {}
Cholesky::Cholesky(Cholesky&&) noexcept = default;
Cholesky& Cholesky::operator=(Cholesky&&) noexcept = default;
Cholesky::~Cholesky() = default;

absl::StatusOr<std::vector<double>> Cholesky::Solve(
    std::span<const double> right_side) const {
  Workspace workspace;
  cholmod_dense dense{};
  dense.nrow = dense.nzmax = dense.d = right_side.size();
  dense.ncol = 1;
  dense.x = Writable(right_side.data());
  dense.xtype = CHOLMOD_REAL;
  dense.dtype = CHOLMOD_DOUBLE;
  const Factor& factor = *factor_;
  cholmod_dense* solved =
      cholmod_solve(CHOLMOD_A, factor.get(), &dense, workspace.get());
  if (absl::Status status = workspace.status(); !status.ok()) {
    cholmod_free_dense(&solved, workspace.get());
    return status;
  }
  const auto* x = static_cast<const double*>(solved->x);
  std::vector<double> solution(x, x + right_side.size());
  cholmod_free_dense(&solved, workspace.get());
  return solution;
}

uint64_t Cholesky::bytes() const { return factor_->bytes(); }

}  // namespace geodesic
