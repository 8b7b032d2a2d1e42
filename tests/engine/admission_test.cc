// Memory that jobs set aside before they start, and who goes before whom, in
// the engine as a whole.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "geodesic/computation.h"
#include "server/engine/base/status_details.h"
#include "tests/engine/engine_fixture.h"
#include "tests/support/meshes/curved_meshes.h"

namespace geodesic::server {
namespace {

using test::RecordingObserver;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// A computation that does all its work in one function.
using SolveFunction = std::function<absl::StatusOr<DistanceField>(
    const Mesh&, const ValidQuery&, Checkpoint&)>;

class SolvingComputation final : public Computation {
 public:
  SolvingComputation(const Mesh& mesh, ValidQuery query, SolveFunction solve)
      : mesh_(mesh), query_(std::move(query)), solve_(std::move(solve)) {}

  absl::Status Advance(const Reach&, Checkpoint& checkpoint) override {
    absl::StatusOr<DistanceField> field = solve_(mesh_, query_, checkpoint);
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
  const SolveFunction solve_;
  DistanceField field_;
};

class AdmissionTest : public test::EngineTest {
 protected:
  explicit AdmissionTest(Limits limits = RoomyQueue()) : EngineTest(limits) {}

  static Limits RoomyQueue() {
    Limits limits = SmallLimits();
    limits.max_queued_jobs = 100;
    return limits;
  }

  void SetUp() override {
    digest_ = Upload(geodesic::test::Icosphere(2)).value().mesh.digest;
    start_ = [this](const Mesh& mesh, const ValidQuery& query,
                    const SolveOptions&) {
      return std::make_unique<SolvingComputation>(mesh, query, solve_);
    };
    solve_ = [this](const Mesh& mesh, const ValidQuery& query,
                    Checkpoint& checkpoint) -> absl::StatusOr<DistanceField> {
      const auto& point = std::get<SurfacePoint>(query->sources[0].place);
      order_.push_back(std::get<VertexPoint>(point).vertex);
      if (at_poll_) at_poll_();
      absl::Status status = checkpoint.Poll({.solver_bytes = 1 << 20});
      if (!status.ok()) return status;
      return DistanceField{.distances =
                               std::vector<double>(mesh.vertex_count())};
    };
  }

  FieldRequest Field(uint32_t vertex, bool is_batch = false) {
    return {.mesh_digest = digest_,
            .query = {.sources = {{VertexPoint{vertex}, 0}}},
            .requester = {.client = "a", .is_batch = is_batch}};
  }
  absl::StatusOr<FieldCall> Ask(const FieldRequest& request) {
    return engine_.fields().Compute(request, observer_);
  }
  absl::StatusOr<MatrixCall> AskForMatrix(uint32_t first, uint32_t rows) {
    MatrixRequest request{.mesh_digest = digest_,
                          .requester = {.client = "matrix"}};
    for (uint32_t row = 0; row < rows; ++row) {
      request.query.sources.push_back({VertexPoint{first + row}, 0});
    }
    return engine_.rows().ComputeMatrix(std::move(request), [] {});
  }

  // What every outcome leaves behind.
  void ExpectNothingHeld() {
    EXPECT_EQ(engine_.solver_memory().used(), 0);
    EXPECT_EQ(engine_.upload_memory().used(), 0);
    EXPECT_EQ(engine_.scheduler().running(), 0);
    EXPECT_EQ(engine_.scheduler().queued(), 0);
    EXPECT_EQ(engine_.fields().jobs().size(), 0);
    EXPECT_EQ(engine_.fields().jobs().waiters(), 0);
  }

  std::string digest_;
  SolveFunction solve_;
  std::function<void()> at_poll_;
  std::vector<uint32_t> order_;  // of the vertices that were sources
  std::shared_ptr<RecordingObserver> observer_ =
      std::make_shared<RecordingObserver>();
};

class OutcomeTest : public AdmissionTest {
 protected:
  // Computes a field.
  void Run() {
    absl::StatusOr<FieldCall> call;
    at_poll_ = [&] {
      EXPECT_GE(engine_.solver_memory().used(),
                PlannedSolverBytes(*call->mesh->mesh, call->query));
    };
    call = Ask(Field(0));
    ASSERT_TRUE(call.ok()) << call.status();
    EXPECT_EQ(engine_.solver_memory().used(), 0);  // it only waits
    executor_.RunAll();
    call = absl::CancelledError();  // which held the mesh
    ExpectNothingHeld();
  }
};

TEST_F(OutcomeTest, AnAnswerLeavesTheFieldAlone) {
  Run();
  EXPECT_TRUE(observer_->field->ok());
  EXPECT_EQ(engine_.fields().cache().size(), 1);
}

TEST_F(OutcomeTest, ADeadlineLeavesNothing) {
  FieldRequest request = Field(0);
  request.deadline = clock_.Now() + std::chrono::seconds(1);
  at_poll_ = [&] { clock_.Advance(std::chrono::seconds(2)); };
  ASSERT_TRUE(Ask(request).ok());
  executor_.RunAll();
  EXPECT_TRUE(absl::IsDeadlineExceeded(observer_->field->status()));
  EXPECT_EQ(engine_.fields().cache().used_bytes(), 0);
  ExpectNothingHeld();
}

TEST_F(OutcomeTest, AnErrorLeavesNothing) {
  const std::pair<SolveFunction, absl::Status> cases[] = {
      {[](const auto&...) { return absl::InternalError("a bug"); },
       absl::InternalError("a bug")},
      {[](const auto&...) -> absl::StatusOr<DistanceField> {
         throw std::bad_alloc();
       },
       absl::ResourceExhaustedError(
           "the server ran out of memory while it computed a field")},
      {[](const auto&...) -> absl::StatusOr<DistanceField> {
         throw std::logic_error("a bug");
       },
       absl::InternalError(
           "exception while the server computed a field: a bug")}};
  for (const auto& [solve, error] : cases) {
    solve_ = solve;
    Run();
    EXPECT_EQ(observer_->field->status(), error);
  }
  EXPECT_EQ(engine_.counters().solves_stopped, 3);
  EXPECT_EQ(engine_.fields().cache().used_bytes(), 0);
}

TEST_F(OutcomeTest, ASettledOrderAndQuantitiesAreSetAsideToo) {
  FieldRequest request = Field(0);
  request.extras.settled_order = true;
  absl::StatusOr<FieldCall> call;
  at_poll_ = [&] {
    const Mesh& mesh = *call->mesh->mesh;
    EXPECT_GE(engine_.solver_memory().used(),
              PlannedSolverBytes(mesh, call->query) +
                  SettledLog::BytesFor(mesh.vertex_count()));
  };
  call = Ask(request);
  ASSERT_TRUE(call.ok());
  executor_.RunAll();
  EXPECT_TRUE(observer_->field->ok());
  // Readers may still want the order.
  EXPECT_GT(engine_.solver_memory().used(), 0);
  call = absl::CancelledError();
  ExpectNothingHeld();
}

TEST_F(OutcomeTest, WhatIsDerivedIsSetAsideToo) {
  // Beside what the solver needs.
  const auto set_aside = [&](const FieldRequest& request) {
    absl::StatusOr<FieldCall> call;
    uint64_t bytes = 0;
    at_poll_ = [&] {
      bytes = engine_.solver_memory().used() -
              PlannedSolverBytes(*call->mesh->mesh, call->query);
    };
    call = Ask(request);
    EXPECT_TRUE(call.ok()) << call.status();
    executor_.RunAll();
    return bytes;
  };
  const uint64_t alone = set_aside(Field(0));
  const uint64_t vertices = geodesic::test::Icosphere(2).positions.size();
  uint32_t source = 0;
  // Another source each time, since fields are kept.
  const auto expect = [&](const FieldExtras& extras, uint64_t per_vertex) {
    FieldRequest request = Field(++source);
    request.extras = extras;
    EXPECT_GE(set_aside(request),
              alone + vertices * per_vertex + sizeof(DerivedQuantities));
  };
  expect({.nearest_sources = true}, sizeof(uint32_t));
  expect({.gradients = true}, sizeof(Point));
  expect({.log_map = true}, 2 * sizeof(double));
  ExpectNothingHeld();
}

TEST_F(OutcomeTest, AMatrixGivesEachRowBack) {
  auto call = AskForMatrix(0, 4);
  ASSERT_TRUE(call.ok()) << call.status();
  executor_.RunAll();
  // One thread: two rows are there and wait to be taken.
  const uint64_t row_bytes = call->column_count * sizeof(double);
  EXPECT_EQ(engine_.solver_memory().used(), 2 * row_bytes);
  for (int row = 0; row < 4; ++row) {
    executor_.RunAll();
    EXPECT_TRUE(call->rows->Take()->ok());
  }
  executor_.RunAll();
  ExpectNothingHeld();

  call = AskForMatrix(0, 4);
  executor_.RunOne();
  call->rows->Cancel();
  executor_.RunAll();
  ExpectNothingHeld();
}

TEST_F(OutcomeTest, AQuestionGivesItsMemoryBack) {
  std::optional<JobReport> report;
  for (const bool fails : {false, true}) {
    auto call = engine_.StartQuestion(
        {.mesh_digest = digest_,
         .query = {.sources = {{VertexPoint{0}, 0}}},
         .work =
             [&](const Mesh& mesh, const ValidQuery& query, const SolveOptions&,
                 Checkpoint&, ByteReservation& answer) {
               EXPECT_EQ(engine_.solver_memory().used(),
                         PlannedSolverBytes(mesh, query));
               absl::Status status = answer.GrowTo(1000);
               return fails ? absl::InternalError("a bug") : status;
             },
         .done = [&](const JobReport& r) { report = r; }});
    ASSERT_TRUE(call.ok());
    executor_.RunAll();
    EXPECT_EQ(report->status.ok(), !fails);
    EXPECT_EQ(engine_.solver_memory().used(), 1000);
    call = absl::CancelledError();  // who streamed the answer is done
    ExpectNothingHeld();
  }
}

// A thousand bytes of a budget that every field needs.
struct TinyBudget {
  uint64_t Limits::*bytes;
  const char* flag;
};

class TinyBudgetTest : public AdmissionTest,
                       public ::testing::WithParamInterface<TinyBudget> {
 protected:
  TinyBudgetTest() : AdmissionTest(Tiny()) {}

  static Limits Tiny() {
    Limits limits = RoomyQueue();
    limits.*GetParam().bytes = 1000;
    return limits;
  }
};

TEST_P(TinyBudgetTest, WhatCanNeverFitIsRefusedAtOnceWithTheFigures) {
  const absl::Status status = Ask(Field(0)).status();
  EXPECT_TRUE(absl::IsResourceExhausted(status));
  EXPECT_EQ(ReasonOf(status), reason::kLimitExceeded);
  EXPECT_FALSE(RetryAfter(status).has_value());
  EXPECT_THAT(std::string(status.message()),
              AllOf(HasSubstr("bytes are needed"), HasSubstr("1000 bytes"),
                    HasSubstr(GetParam().flag)));
  EXPECT_EQ(observer_->calls, 0);
  ExpectNothingHeld();
  // A row takes a solver, but is not kept.
  const bool is_solver = GetParam().bytes == &Limits::solver_memory_bytes;
  EXPECT_EQ(absl::IsResourceExhausted(AskForMatrix(0, 2).status()), is_solver);
}

INSTANTIATE_TEST_SUITE_P(
    Budgets, TinyBudgetTest,
    ::testing::Values(
        TinyBudget{&Limits::solver_memory_bytes, "--limit solver-memory"},
        TinyBudget{&Limits::field_cache_bytes, "--limit field-cache"}));

class SharedQueueTest : public AdmissionTest {
 protected:
  SharedQueueTest() : AdmissionTest(Shares()) {}

  static Limits Shares() {
    Limits limits = RoomyQueue();
    limits.max_concurrent_jobs = 2;
    limits.max_queued_jobs = 6;
    limits.max_queued_jobs_per_client = 3;
    return limits;
  }
};

// Opened one after the other and not read, they hold no job; read at once, each
// has one that waits.
TEST_F(SharedQueueTest, AMatrixWhoseReaderPausesCountsForItsClient) {
  std::vector<MatrixCall> open;
  absl::StatusOr<MatrixCall> next = AskForMatrix(0, 10);
  for (; next.ok() && open.size() < 20; next = AskForMatrix(0, 10)) {
    open.push_back(*next);
    executor_.RunAll();
  }
  EXPECT_EQ(open.size(), 2 + 3);
  EXPECT_EQ(ReasonOf(next.status()), reason::kQuotaExceeded);
  EXPECT_EQ(engine_.scheduler().queued(), 0);
  // A question for which there is a thread takes no place.
  FieldRequest question = Field(0);
  question.requester.client = "matrix";
  EXPECT_TRUE(Ask(question).ok());
  executor_.RunAll();

  for (const MatrixCall& call : open) {
    while (call.rows->Take()) {
    }
  }
  EXPECT_EQ(engine_.scheduler().queued(), 2 + 3);
  EXPECT_TRUE(Ask(Field(1)).ok());  // others have room

  // A place goes with the matrix, or when its last row begins.
  EXPECT_FALSE(AskForMatrix(0, 10).ok());
  open[0].rows->Cancel();
  EXPECT_TRUE(AskForMatrix(0, 10).ok());
  for (int row = 0; row < 10; ++row) {
    executor_.RunAll();
    open[1].rows->Take();
  }
  EXPECT_TRUE(AskForMatrix(0, 10).ok());
  executor_.RunAll();
}

TEST_F(AdmissionTest, BatchesGoAfterRowsAndQuestions) {
  ASSERT_TRUE(Ask(Field(1, /*is_batch=*/true)).ok());
  const auto matrix = AskForMatrix(100, 2);
  ASSERT_TRUE(matrix.ok());
  ASSERT_TRUE(Ask(Field(2)).ok());
  executor_.RunAll();
  EXPECT_THAT(order_, ElementsAre(2, 100, 101, 1));
}

TEST_F(AdmissionTest, WhatMustBeKeptIsNotComputed) {
  FieldRequest request = Field(0);
  request.must_be_kept = true;
  const absl::Status status = Ask(request).status();
  EXPECT_TRUE(absl::IsNotFound(status));
  EXPECT_EQ(ReasonOf(status), reason::kAnswerNotKept);
  ASSERT_TRUE(Ask(Field(0)).ok());
  // Not while it is computed, either.
  EXPECT_TRUE(absl::IsNotFound(Ask(request).status()));
  executor_.RunAll();
  const auto call = Ask(request);
  ASSERT_TRUE(call.ok());
  EXPECT_TRUE(call->answer.has_value());
}

}  // namespace
}  // namespace geodesic::server
