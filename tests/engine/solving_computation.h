// A computation that does all its work in one function, for tests that hold a
// solver up.

#ifndef GEODESIC_TESTS_ENGINE_SOLVING_COMPUTATION_H_
#define GEODESIC_TESTS_ENGINE_SOLVING_COMPUTATION_H_

#include <functional>
#include <memory>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/computation.h"
#include "server/engine/query_engine.h"

namespace geodesic::server::test {

using SolveFunction = std::function<absl::StatusOr<DistanceField>(
    const Mesh&, const ValidQuery&, const SolveOptions&, Checkpoint&)>;

class SolvingComputation final : public Computation {
 public:
  SolvingComputation(const Mesh& mesh, ValidQuery query,
                     const SolveOptions& options, SolveFunction solve)
      : mesh_(mesh),
        query_(std::move(query)),
        options_(options),
        solve_(std::move(solve)) {}

  absl::Status Advance(const Reach&, Checkpoint& checkpoint) override {
    absl::StatusOr<DistanceField> field =
        solve_(mesh_, query_, options_, checkpoint);
    if (field.ok()) field_ = *std::move(field);
    return field.status();
  }
  DistanceField Field() const override { return field_; }
  absl::Status AddSource(const Source&) override {
    return absl::UnimplementedError("not for tests");
  }
  uint64_t bytes() const override { return sizeof(*this); }

 private:
  const Mesh& mesh_;
  const ValidQuery query_;
  const SolveOptions options_;
  const SolveFunction solve_;
  DistanceField field_;
};

// Starts computations that call what `solve` is at that time, which outlives
// them.
inline StartFunction StartWith(const SolveFunction& solve) {
  return [&solve](const Mesh& mesh, const ValidQuery& query,
                  const SolveOptions& options)
             -> absl::StatusOr<std::unique_ptr<Computation>> {
    return std::make_unique<SolvingComputation>(mesh, query, options, solve);
  };
}

}  // namespace geodesic::server::test

#endif  // GEODESIC_TESTS_ENGINE_SOLVING_COMPUTATION_H_
