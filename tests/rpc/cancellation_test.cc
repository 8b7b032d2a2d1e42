// The ends that a call may come to before its own: the client cancels, its
// deadline comes, something fails, the server stops, the client is gone. Each
// is tried with calls of each kind in each phase that they have; afterwards
// nothing is left of the call: no job, no waiter, no memory set aside, no mesh
// pinned.
//
// What is not in the table cannot be: nothing fails in a queue or in a stream.
// Jobs that wait for memory are jobs in the queue to whoever made them; what
// they hold meanwhile is tested in tests/engine.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "server/engine/jobs/scheduler.h"
#include "tests/engine/uploads.h"
#include "tests/rpc/questions_fixture.h"
#include "tests/support/http_get.h"
#include "tests/support/meshes/curved_meshes.h"
#include "tests/support/tcp_relay.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/until.h"

namespace geodesic::server {
namespace {

using geodesic::test::Until;
using std::chrono::steady_clock;

enum class Cause { kCancel, kDeadline, kError, kShutdown, kGone };
enum class Kind { kUnary, kUpload, kStream };
enum class Phase { kQueued, kComputing, kStreaming };

struct Row {
  Cause cause;
  Kind kind;
  Phase phase;
};

std::string NameOf(const Row& row) {
  constexpr const char* kCauses[] = {"Cancel", "Deadline", "Error", "Shutdown",
                                     "ClientGone"};
  constexpr const char* kKinds[] = {"Unary", "Upload", "Stream"};
  constexpr const char* kPhases[] = {"Queued", "Computing", "Streaming"};
  return absl::StrCat(kCauses[static_cast<int>(row.cause)],
                      kKinds[static_cast<int>(row.kind)],
                      kPhases[static_cast<int>(row.phase)]);
}

std::vector<Row> Table() {
  std::vector<Row> table = {{Cause::kError, Kind::kUpload, Phase::kComputing},
                            {Cause::kError, Kind::kUpload, Phase::kStreaming},
                            {Cause::kError, Kind::kStream, Phase::kComputing}};
  for (const Cause cause :
       {Cause::kCancel, Cause::kDeadline, Cause::kShutdown, Cause::kGone}) {
    table.push_back({cause, Kind::kUnary, Phase::kQueued});
    table.push_back({cause, Kind::kUpload, Phase::kStreaming});
    table.push_back({cause, Kind::kUpload, Phase::kQueued});
    table.push_back({cause, Kind::kStream, Phase::kQueued});
    table.push_back({cause, Kind::kStream, Phase::kComputing});
    table.push_back({cause, Kind::kStream, Phase::kStreaming});
  }
  return table;
}

constexpr uint32_t kNobody = 0xffffffff;

// Solvers that solve the same again and again until they are stopped, at their
// own polls.
struct EndlessSolvers {
  StartFunction Start();

  std::atomic<bool> endless = true;         // false: they end as others do
  std::atomic<uint32_t> failing = kNobody;  // who works on it fails
  std::atomic<int> starts = 0;
};

class EndlessComputation final : public test::WrappedComputation {
 public:
  EndlessComputation(EndlessSolvers& all, const Mesh& mesh, ValidQuery query,
                     const SolveOptions& options)
      : all_(all), mesh_(mesh), query_(std::move(query)), options_(options) {}

  absl::Status Advance(const Reach& reach, Checkpoint& checkpoint) override {
    ++all_.starts;
    for (;;) {
      auto started = StartComputation(mesh_, query_, options_);
      if (!started.ok()) return started.status();
      computation_ = *std::move(started);
      absl::Status status = computation_->Advance(reach, checkpoint);
      if (status.ok() &&
          query_->sources == std::vector<Source>{{VertexPoint{all_.failing}}}) {
        status = absl::InternalError("the solver failed");
      }
      if (!status.ok() || !all_.endless) return status;
    }
  }

 private:
  EndlessSolvers& all_;
  const Mesh& mesh_;
  const ValidQuery query_;
  const SolveOptions options_;
};

StartFunction EndlessSolvers::Start() {
  return [this](const Mesh& mesh, const ValidQuery& query,
                const SolveOptions& options)
             -> absl::StatusOr<std::unique_ptr<Computation>> {
    return std::make_unique<EndlessComputation>(*this, mesh, query, options);
  };
}

class CancelMatrixTest : public test::RpcTest,
                         public ::testing::WithParamInterface<Row> {
 protected:
  ~CancelMatrixTest() override {
    solvers_.endless = false;
    FreeDisk();
    if (blocker_ != nullptr) blocker_->context.TryCancel();
    if (stopped_.valid()) stopped_.get();
    server_.reset();  // its jobs use the solvers
  }

  // One thread, to be reached through a relay that can be cut.
  void SetUp() override {
    ServerOptions options = SmallServer();
    options.limits.max_concurrent_jobs = 1;
    options.limits.max_queued_jobs = 10;
    // So that deletions are jobs.
    if (GetParam().kind == Kind::kUnary) options.data_dir = folder_ / "data";
    options.limits.mesh_disk_bytes = options.limits.field_disk_bytes = 1 << 30;
    StartWith(options, solvers_.Start());
    digest_ = Upload(geodesic::test::Icosphere(6));
    relay_.emplace(server_->port());
    const auto relayed = SlowChannel(relay_->port());
    relayed_meshes_ = v1::MeshService::NewStub(relayed);
    relayed_questions_ = v1::QuestionService::NewStub(relayed);
    const auto mesh = server_->engine().meshes().Get(digest_);
    ASSERT_TRUE(mesh.ok());
    mesh_ = *mesh;
  }

  const QueryEngine& engine() { return server_->engine(); }

  // Occupies the thread.
  void Block() {
    blocker_ = Open(digest_, 0);
    ASSERT_TRUE(Until([&] { return solvers_.starts == 1; }));
  }
  // The same for the threads that wait for the disk.
  void BlockDisk() {
    for (size_t i = 0; i < kDiskThreads; ++i) {
      Job job{.waits_for_disk = [] { return true; },
              .run =
                  [this](const std::stop_token& stop) {
                    std::unique_lock lock(mutex_);
                    disk_freed_.wait(lock, stop, [this] { return is_free_; });
                  },
              .abandon = [](const absl::Status&) {}};
      ASSERT_TRUE(server_->engine().scheduler().Submit(std::move(job)).ok());
    }
    ASSERT_TRUE(
        Until([&] { return engine().scheduler().running() == kDiskThreads; }));
  }
  void FreeDisk() {
    std::lock_guard lock(mutex_);
    is_free_ = true;
    disk_freed_.notify_all();
  }
  void Unblock() {
    FreeDisk();
    if (blocker_ == nullptr) return;
    blocker_->context.TryCancel();
    blocker_->End();
    blocker_ = nullptr;
  }

  // The end comes.
  void Trigger() {
    switch (GetParam().cause) {
      case Cause::kCancel:
        context_.TryCancel();
        break;
      case Cause::kDeadline:
        break;  // it comes by itself
      case Cause::kError:
        solvers_.failing = 1;
        break;
      case Cause::kShutdown:
        stopped_ = std::async(std::launch::async, [this] {
          server_->Shutdown(std::chrono::milliseconds(0));
          return server_->Wait();
        });
        break;
      case Cause::kGone:
        relay_->Cut();
        break;
    }
  }
  // The call's context is made just before it begins.
  void SetDeadline() {
    if (GetParam().cause != Cause::kDeadline) return;
    constexpr std::chrono::seconds kTime(1);
    deadline_ = steady_clock::now() + kTime;
    context_.set_deadline(std::chrono::system_clock::now() + kTime);
  }
  // Waits for what makes the phase, or for a deadline that came before.
  template <typename Condition>
  bool Reach(Condition holds) {
    return Until([&] {
      return holds() || (GetParam().cause == Cause::kDeadline &&
                         steady_clock::now() > deadline_);
    });
  }

  void ExpectCode(const grpc::Status& status,
                  grpc::StatusCode at_error = grpc::StatusCode::OK) {
    const grpc::StatusCode code = status.error_code();
    switch (GetParam().cause) {
      case Cause::kCancel:
        EXPECT_EQ(code, grpc::StatusCode::CANCELLED);
        break;
      case Cause::kDeadline:
        EXPECT_EQ(code, grpc::StatusCode::DEADLINE_EXCEEDED);
        break;
      case Cause::kError:
        EXPECT_EQ(code, at_error) << status.error_message();
        break;
      case Cause::kShutdown:
        // A stream that is cut off may merely hear that it was cancelled.
        if (GetParam().phase == Phase::kStreaming &&
            code == grpc::StatusCode::CANCELLED) {
          break;
        }
        [[fallthrough]];
      case Cause::kGone:
        EXPECT_EQ(code, grpc::StatusCode::UNAVAILABLE);
        break;
    }
  }

  void ExpectNothingLeft() {
    // What only waits is dropped; a deletion goes on.
    if (GetParam().phase == Phase::kQueued && GetParam().kind != Kind::kUnary) {
      EXPECT_TRUE(Until([&] { return engine().scheduler().queued() == 0; }));
    }
    Unblock();
    EXPECT_TRUE(Until([&] {
      return engine().scheduler().running() == 0 &&
             engine().scheduler().queued() == 0 &&
             engine().fields().jobs().size() == 0 &&
             engine().fields().jobs().waiters() == 0 &&
             engine().meshes().loads().size() == 0 &&
             engine().solver_memory().used() == 0 &&
             engine().upload_memory().used() == 0;
    })) << engine().solver_memory().used()
        << ' ' << engine().upload_memory().used();
    // Nobody has the mesh any more but its store.
    (void)server_->engine().meshes().Delete(digest_,
                                            [](const absl::Status&) {});
    if (GetParam().kind != Kind::kUnary) {
      EXPECT_TRUE(Until([&] { return mesh_.expired(); }));
    }
    if (stopped_.valid()) stopped_.get();
  }

  void RunUnary();
  void RunUpload();
  void RunStream();

  const geodesic::test::TemporaryFolder folder_;
  EndlessSolvers solvers_;
  std::string digest_;
  std::weak_ptr<const ResidentMesh> mesh_;
  std::optional<geodesic::test::TcpRelay> relay_;
  std::unique_ptr<v1::MeshService::Stub> relayed_meshes_;
  std::unique_ptr<v1::QuestionService::Stub> relayed_questions_;

  std::unique_ptr<test::OpenCall> blocker_;
  std::mutex mutex_;
  std::condition_variable_any disk_freed_;
  bool is_free_ = false;  // guarded by mutex_

  grpc::ClientContext context_;
  steady_clock::time_point deadline_;
  std::future<Server::Ending> stopped_;
};

// Deletes a mesh, which on this server is a job. It is done though nobody waits
// for the answer, unless the server stops.
void CancelMatrixTest::RunUnary() {
  BlockDisk();
  v1::DeleteMeshRequest request;
  request.set_digest(digest_);
  v1::DeleteMeshResponse response;
  SetDeadline();
  auto answer = std::async(std::launch::async, [&] {
    return relayed_meshes_->DeleteMesh(&context_, request, &response);
  });
  ASSERT_TRUE(Reach([&] { return engine().scheduler().queued() == 1; }));
  Trigger();
  ExpectCode(answer.get());
}

void CancelMatrixTest::RunUpload() {
  const Cause cause = GetParam().cause;
  const Phase phase = GetParam().phase;
  if (phase == Phase::kQueued) Block();
  std::string bytes = test::ArrayBytes(test::Tetrahedron());
  v1::CreateMeshRequest message;
  *message.mutable_header() = test::ArraysHeader(test::Tetrahedron());
  // The last corner of the last face.
  if (phase == Phase::kComputing) bytes[bytes.size() - 4] = 77;
  v1::CreateMeshResponse response;
  SetDeadline();
  const auto writer = relayed_meshes_->CreateMesh(&context_, &response);
  writer->Write(message);
  message.mutable_chunk()->set_data(
      phase == Phase::kStreaming ? bytes.substr(0, 10) : bytes);
  writer->Write(message);
  if (phase == Phase::kStreaming) {
    ASSERT_TRUE(Reach([&] { return engine().upload_memory().used() > 0; }));
    if (cause == Cause::kError) {
      message.mutable_chunk()->set_offset(7);  // 10 was due
      writer->Write(message);
    }
  } else {
    writer->WritesDone();
  }
  if (phase == Phase::kQueued) {
    ASSERT_TRUE(Reach([&] { return engine().scheduler().queued() == 1; }));
  }
  Trigger();
  ExpectCode(writer->Finish(), grpc::StatusCode::INVALID_ARGUMENT);
}

void CancelMatrixTest::RunStream() {
  const Phase phase = GetParam().phase;
  if (phase == Phase::kQueued) Block();
  if (phase == Phase::kStreaming) solvers_.endless = false;
  SetDeadline();
  const auto reader =
      relayed_questions_->ComputeField(&context_, FieldRequest(digest_, 1));
  ASSERT_TRUE(Reach([&] {
    switch (phase) {
      case Phase::kQueued:
        return engine().scheduler().queued() == 1;
      case Phase::kComputing:
        return solvers_.starts == 1;
      case Phase::kStreaming:
        // A field of 320 KiB is more than its reader takes unread.
        return engine().fields().cache().size() == 1 &&
               engine().scheduler().running() == 0;
    }
    return false;
  }));
  Trigger();
  // The solver and whatever waits are let go though the client reads nothing.
  if (phase != Phase::kQueued) {
    EXPECT_TRUE(Until([&] {
      return engine().scheduler().running() == 0 &&
             engine().fields().jobs().size() == 0;
    }));
  } else {
    EXPECT_TRUE(Until([&] { return engine().scheduler().queued() == 0; }));
  }
  if (phase == Phase::kStreaming) {
    (void)server_->engine().meshes().Delete(digest_,
                                            [](const absl::Status&) {});
    EXPECT_TRUE(Until([&] { return mesh_.expired(); }));
  }
  const test::Reply reply = test::ReadAll(*reader);
  test::ExpectRules(reply, {});
  ExpectCode(reply.status, grpc::StatusCode::INTERNAL);
}

TEST_P(CancelMatrixTest, NothingIsLeft) {
  switch (GetParam().kind) {
    case Kind::kUnary:
      RunUnary();
      break;
    case Kind::kUpload:
      RunUpload();
      break;
    case Kind::kStream:
      RunStream();
      break;
  }
  ExpectNothingLeft();
}

INSTANTIATE_TEST_SUITE_P(All, CancelMatrixTest, ::testing::ValuesIn(Table()),
                         [](const auto& row) { return NameOf(row.param); });

// Every question's work stops when its client gives up. (Fields are above.)
class QuestionCancellationTest : public test::QuestionsTest {
 protected:
  // The solver waits, so nothing of the answer has come when the call is
  // cancelled.
  void SetUp() override {
    ServerOptions options = SmallServer();
    options.metrics_listen = "127.0.0.1:0";
    options.limits.landmark_memory_bytes = 0;  // their fields would be held too
    StartWithGrid(/*held=*/true, options);
  }

  template <typename Request>
  void ExpectCancelled(const Request& request) {
    SCOPED_TRACE(request.GetTypeName());
    const int starts = solver_.starts();
    const auto call = Open(request);
    solver_.WaitForStarts(starts + 1);
    ExpectCancelled(*call);
  }

  // The same for work that no test can hold up, on a mesh so large that it
  // takes long: it is cancelled once it tells of its progress.
  template <typename Request>
  void ExpectCancelledUnderWay(const Request& request) {
    SCOPED_TRACE(request.GetTypeName());
    const auto call = Open(request);
    do {
      ASSERT_TRUE(call->Read());
    } while (!call->message.has_progress());
    ExpectCancelled(*call);
  }

 private:
  void ExpectCancelled(test::OpenCall& call) {
    const std::string before = CancelledSeconds();
    call.context.TryCancel();
    EXPECT_EQ(call.End().error_code(), grpc::StatusCode::CANCELLED);
    EXPECT_FALSE(call.message.has_trailer());
    EXPECT_TRUE(
        server_->engine().scheduler().WaitIdle(std::chrono::seconds(120)));
    EXPECT_NE(CancelledSeconds(), before);
  }

  // The time of jobs which nobody waited for at their end.
  std::string CancelledSeconds() const {
    return Metric("geodesic_cancelled_compute_seconds_total ");
  }

 protected:
  // The line that begins so.
  std::string Metric(const std::string& name) const {
    const std::string page =
        geodesic::test::HttpGet(server_->metrics_port(), "/metrics");
    const size_t begin = page.find("\n" + name) + 1;
    return page.substr(begin, page.find('\n', begin) - begin);
  }
};

TEST_F(QuestionCancellationTest, StopsItsWork) {
  auto paths = From<v1::ComputePathsRequest>(0);
  paths.add_targets()->set_vertex(Vertex(kSide, kSide));
  paths.set_radius(kSide);  // a field, which can be held up
  ExpectCancelled(paths);
  ExpectCancelled(From<v1::ComputeLogMapRequest>(Vertex(5, 5)));
  EXPECT_EQ(Metric("geodesic_solves_ended_total{result=\"stopped\"}"),
            "geodesic_solves_ended_total{result=\"stopped\"} 2");
  // A field each, because they share their ends.
  v1::ComputePairsRequest pairs;
  pairs.set_mesh_digest(digest_);
  for (uint32_t i = 0; i < 100; ++i) {
    pairs.add_vertex_pairs(i / 20);
    pairs.add_vertex_pairs(50 + i % 20);
  }
  ExpectCancelled(pairs);
  auto matrix = From<v1::ComputeMatrixRequest>(1);
  for (uint32_t i = 2; i <= kSide; ++i) matrix.add_sources()->set_vertex(i);
  ExpectCancelled(matrix);
  auto nearest = From<v1::FindNearestRequest>(0);
  nearest.add_targets()->set_vertex(Vertex(1, 1));
  nearest.set_count(1);
  nearest.set_radius(kSide);
  ExpectCancelled(nearest);

  const TriangleSoup ball = geodesic::test::Icosphere(7);
  digest_ = Upload(ball);
  // The search for the place on the other side covers all of the ball.
  const auto other_side =
      std::ranges::max_element(ball.positions, {}, [&](const Point& place) {
        const Point& first = ball.positions[0];
        return std::hypot(place[0] - first[0], place[1] - first[1],
                          place[2] - first[2]);
      });
  auto search = From<v1::ComputePathsRequest>(0);
  search.add_targets()->set_vertex(
      static_cast<uint32_t>(other_side - ball.positions.begin()));
  ExpectCancelledUnderWay(search);
  auto samples = From<v1::SampleFarthestPointsRequest>(0);
  samples.set_count(20);
  ExpectCancelledUnderWay(samples);
  auto isolines = From<v1::ComputeIsolinesRequest>(0);
  isolines.add_levels(100);
  ExpectCancelledUnderWay(isolines);
}

}  // namespace
}  // namespace geodesic::server
