#include "approximate/cholesky.h"

#include <cholmod.h>

#include <algorithm>
#include <numeric>
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
    // By AMD. METIS makes half the fill on large even meshes, but draws from
    // rand(), which other threads may do meanwhile.
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_GIVEN;
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

// What CHOLMOD gave, with the workspace that takes it back.
template <typename T, int (*Free)(T**, cholmod_common*)>
class Held {
 public:
  Held(T* it, cholmod_common* common) : it_(it), common_(common) {}
  ~Held() { Free(&it_, common_); }
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;

  void Take(T* other) {
    Free(&it_, common_);
    it_ = other;
  }
  T* get() const { return it_; }

 private:
  T* it_;
  cholmod_common* common_;
};
using Sparse = Held<cholmod_sparse, cholmod_free_sparse>;
using Dense = Held<cholmod_dense, cholmod_free_dense>;

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

// About a millisecond; but after rows of leaves come those of their separator,
// which take some milliseconds each.
constexpr double kFlopsBetweenPolls = 1e6;
constexpr size_t kRowsBetweenPolls = 16;

uint64_t BytesOf(const cholmod_factor& factor) {
  const std::span counts(static_cast<const int32_t*>(factor.ColCount),
                         factor.n);
  const uint64_t entries =
      std::accumulate(counts.begin(), counts.end(), uint64_t{0});
  // By column: the permutation, counts, begins and links.
  return factor.n * 6 * sizeof(int32_t) +
         entries * (sizeof(int32_t) + sizeof(double));
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

 private:
  Workspace workspace_;
  cholmod_factor* factor_ = nullptr;
};

class Cholesky::Order : public Cholesky::Factor {};

absl::StatusOr<std::shared_ptr<const Cholesky::Order>> Cholesky::Analyze(
    const SymmetricPattern& pattern, Checkpoint& checkpoint,
    const Progress& progress, size_t most) {
  auto order = std::make_shared<Order>();
  Workspace& workspace = order->workspace();
  absl::StatusOr<Dissection> dissection =
      Dissect(pattern, most, checkpoint, progress);
  if (!dissection.ok()) return dissection.status();
  std::vector<int32_t> numbers(pattern.size(), -1);
  for (const Dissection::Part& part : dissection->parts) {
    const std::span<int32_t> columns = dissection->ColumnsOf(part);
    const SymmetricPattern within = PatternOf(pattern, columns, numbers);
    cholmod_sparse matrix = MatrixOf(within, nullptr);
    std::vector<int32_t> given(columns.size());
    cholmod_amd(&matrix, nullptr, 0, given.data(), workspace.get());
    absl::Status status = workspace.status();
    if (status.ok()) status = checkpoint.Poll(progress);
    if (!status.ok()) return status;
    std::ranges::transform(given, given.begin(),
                           [&](int32_t i) { return columns[i]; });
    std::ranges::copy(given, columns.begin());
  }
  cholmod_sparse matrix = MatrixOf(pattern, nullptr);
  order->get() = cholmod_analyze_p(&matrix, dissection->order.data(), nullptr,
                                   0, workspace.get());
  if (absl::Status status = workspace.status(); !status.ok()) return status;
  return order;
}

absl::StatusOr<Cholesky> Cholesky::Factorize(const SymmetricPattern& pattern,
                                             const Order& order,
                                             std::span<const double> values,
                                             Checkpoint& checkpoint,
                                             Progress progress) {
  progress.solver_bytes += BytesOf(*order.get());
  absl::Status status = checkpoint.Poll(progress);
  if (!status.ok()) return status;
  auto factor = std::make_unique<Factor>();
  Workspace& workspace = factor->workspace();
  factor->get() = cholmod_copy_factor(order.get(), workspace.get());
  if (status = workspace.status(); !status.ok()) return status;
  if (status = checkpoint.Poll(progress); !status.ok()) return status;
  cholmod_sparse matrix = MatrixOf(pattern, values.data());
  const Sparse lower(
      cholmod_ptranspose(&matrix, 1, static_cast<int*>(order.get()->Perm),
                         nullptr, 0, workspace.get()),
      workspace.get());
  if (status = workspace.status(); !status.ok()) return status;
  if (status = checkpoint.Poll(progress); !status.ok()) return status;
  const Sparse upper(cholmod_transpose(lower.get(), 1, workspace.get()),
                     workspace.get());
  if (status = workspace.status(); !status.ok()) return status;
  size_t rows = 1;
  for (size_t begin = 0; begin < factor->get()->n;) {
    if (status = checkpoint.Poll(progress); !status.ok()) return status;
    const size_t end = std::min(begin + rows, factor->get()->n);
    double nothing_added[2] = {0, 0};
    cholmod_rowfac(upper.get(), nullptr, nothing_added, begin, end,
                   factor->get(), workspace.get());
    if (status = workspace.status(); !status.ok()) return status;
    rows = workspace.get()->rowfacfl < kFlopsBetweenPolls
               ? std::min(2 * rows, kRowsBetweenPolls)
               : (rows + 1) / 2;
    begin = end;
  }
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
    std::span<const double> right_side, Checkpoint& checkpoint,
    const Progress& progress) const {
  const Factor& factor = *factor_;
  Workspace workspace;
  cholmod_dense right{};
  right.nrow = right.nzmax = right.d = right_side.size();
  right.ncol = 1;
  right.x = Writable(right_side.data());
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  Dense solved(nullptr, workspace.get());
  for (const int system : {CHOLMOD_P, CHOLMOD_LD, CHOLMOD_Lt, CHOLMOD_Pt}) {
    if (absl::Status status = checkpoint.Poll(progress); !status.ok()) {
      return status;
    }
    solved.Take(cholmod_solve(system, factor.get(),
                              solved.get() == nullptr ? &right : solved.get(),
                              workspace.get()));
    if (absl::Status status = workspace.status(); !status.ok()) return status;
  }
  const auto* x = static_cast<const double*>(solved.get()->x);
  return std::vector<double>(x, x + right_side.size());
}

uint64_t Cholesky::bytes() const { return BytesOf(*factor_->get()); }

}  // namespace geodesic
