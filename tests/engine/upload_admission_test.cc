// Uploads and the memory that they become meshes with: what can come free is
// waited for, what never can is refused with the figures.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "absl/strings/str_cat.h"
#include "server/engine/base/status_details.h"
#include "tests/engine/engine_fixture.h"
#include "tests/support/meshes/planar_meshes.h"

namespace geodesic::server {
namespace {

using ::testing::HasSubstr;

TriangleSoup Grid(uint32_t columns) {
  return geodesic::test::MakeGrid({.columns = columns, .rows = 12});
}

UploadHeader OffHeader(std::string_view file) {
  return {.format = MeshFormat::kOff, .size_bytes = file.size()};
}

// Two threads, and room in memory for one mesh, which is there.
class UploadAdmissionTest : public test::EngineTest {
 protected:
  using Result = std::optional<absl::StatusOr<UploadResult>>;

  explicit UploadAdmissionTest(Limits limits = RoomForOne())
      : EngineTest(limits) {}

  static Limits RoomForOne() {
    Limits limits = SmallLimits();
    limits.max_concurrent_jobs = 2;
    limits.max_queued_jobs = 10;
    limits.mesh_store_bytes = Mesh::EstimateResidentBytes(182, 312) + 4096;
    return limits;
  }

  void SetUp() override { resident_ = Upload(Grid(13)).value().mesh.digest; }

  std::unique_ptr<MeshUpload> Received(const UploadHeader& header,
                                       std::string_view bytes) {
    auto upload = engine_.meshes().StartUpload(header);
    EXPECT_TRUE(upload.ok()) << upload.status();
    const absl::Status status = (*upload)->Append(0, bytes);
    EXPECT_TRUE(status.ok()) << status;
    return *std::move(upload);
  }

  // Sends in an upload; what came of it is in `result` once it is known.
  UploadJobs::Ticket Finish(std::unique_ptr<MeshUpload> upload,
                            Result& result) {
    const auto job = engine_.meshes().FinishUpload(
        std::move(upload), [&](const auto& r) { result = r; });
    EXPECT_TRUE(job.ok()) << job.status();
    EXPECT_NE(job->entry, nullptr);
    return *job;
  }

  // Calls `act` while a field is computed, whose job pins the resident mesh.
  void Beside(const std::function<void()>& act) {
    start_ = [act](const Mesh& mesh, const ValidQuery& query,
                   const SolveOptions& options) {
      act();
      return StartComputation(mesh, query, options);
    };
    FieldRequest request{.mesh_digest = resident_};
    request.query.sources = {{VertexPoint{0}}};
    ASSERT_TRUE(
        engine_.fields()
            .Compute(request, std::make_shared<test::RecordingObserver>())
            .ok());
    executor_.RunAll();
    EXPECT_EQ(engine_.upload_memory().used(), 0);
    EXPECT_EQ(engine_.scheduler().queued(), 0);
    EXPECT_EQ(engine_.scheduler().running(), 0);
  }

  // The other thread works until it waits.
  void ExpectOneWaits() {
    while (executor_.RunOne()) {
    }
    EXPECT_EQ(engine_.scheduler().queued(), 1);
    EXPECT_EQ(engine_.scheduler().running(), 1) << "the field's";
  }

  std::string resident_;
};

// In either format: how large a mesh is, is known before a file is parsed or
// after.
class WaitingUploadTest : public UploadAdmissionTest,
                          public ::testing::WithParamInterface<UploadFormat> {
 protected:
  // Finishes an upload beside a field's job, for whose mesh it has to wait;
  // then calls `act`.
  void FinishBeside(const std::function<void(UploadJobs::Ticket)>& act) {
    const TriangleSoup soup = Grid(12);
    const std::string file = test::OffFile(soup);
    Beside([&] {
      const UploadJobs::Ticket job =
          GetParam() == kArrays
              ? Finish(
                    Received(test::ArrayHeader(soup), test::ArrayBytes(soup)),
                    result_)
              : Finish(Received(OffHeader(file), file), result_);
      ExpectOneWaits();
      EXPECT_FALSE(result_.has_value()) << result_->status();
      // It holds its triangles and nothing else.
      EXPECT_EQ(engine_.upload_memory().used(),
                soup.positions.size() * sizeof(Point) +
                    soup.triangles.size() * sizeof(Triangle));
      act(job);
    });
  }

  Result result_;
};

TEST_P(WaitingUploadTest, AnUploadWaitsForTheMemoryThatAJobHolds) {
  FinishBeside([](auto) {});
  ASSERT_TRUE(result_.has_value());
  ASSERT_TRUE(result_->ok()) << result_->status();
  EXPECT_TRUE(engine_.meshes().Get((*result_)->mesh.digest).ok());
}

TEST_P(WaitingUploadTest, WhoeverLeavesMeanwhileLeavesNothing) {
  FinishBeside([&](UploadJobs::Ticket job) {
    engine_.meshes().CancelUpload(job);
    EXPECT_EQ(engine_.upload_memory().used(), 0);
  });
  EXPECT_FALSE(result_.has_value());
  EXPECT_EQ(engine_.counters().meshes_built, 1);
}

INSTANTIATE_TEST_SUITE_P(Formats, WaitingUploadTest,
                         ::testing::Values(kArrays, MeshFormat::kOff));

class CancelledUploadTest : public test::EngineTest,
                            public ::testing::WithParamInterface<UploadFormat> {
 protected:
  // Uploads a mesh, and cancels that when its job looks at the clock for this
  // time. Whether it did. The job counts against the client's quota
  // until it has ended.
  bool CancelAtLook(int number) {
    const TriangleSoup soup = Grid(12);
    const bool is_file = GetParam() == MeshFormat::kOff;
    const std::string bytes =
        is_file ? test::OffFile(soup) : test::ArrayBytes(soup);
    auto upload = *engine_.meshes().StartUpload(
        is_file ? OffHeader(bytes) : test::ArrayHeader(soup));
    EXPECT_TRUE(upload->Append(0, bytes).ok());
    bool is_cancelled = false;
    auto quota = std::make_shared<int>();
    const std::weak_ptr<int> counted = quota;
    const auto job = engine_.meshes().FinishUpload(
        std::move(upload),
        [&](const auto& result) { EXPECT_NE(result.ok(), is_cancelled); },
        "client", [quota = std::move(quota)](const auto& /*result*/) {});
    EXPECT_TRUE(job.ok()) << job.status();
    clock_.at_look = [&] {
      if (number-- != 0) return;
      is_cancelled = true;
      engine_.meshes().CancelUpload(*job);
      EXPECT_FALSE(counted.expired());
    };
    executor_.RunAll();
    EXPECT_TRUE(counted.expired());
    clock_.at_look = nullptr;
    return is_cancelled;
  }
};

TEST_P(CancelledUploadTest, IsNotBuilt) {
  int looks = 0;
  for (; CancelAtLook(looks); ++looks) {
    EXPECT_EQ(engine_.counters().meshes_built, 0) << looks;
    EXPECT_EQ(engine_.meshes().store().used_bytes(), 0) << looks;
    EXPECT_EQ(engine_.upload_memory().used(), 0) << looks;
  }
  EXPECT_GE(looks, 8);
  EXPECT_EQ(engine_.counters().meshes_built, 1);
}

INSTANTIATE_TEST_SUITE_P(Formats, CancelledUploadTest,
                         ::testing::Values(kArrays, MeshFormat::kOff));

TEST_F(UploadAdmissionTest, AnUploadWaitsForTheMemoryThatAWaitingJobHolds) {
  FieldRequest request{.mesh_digest = resident_};
  request.query.sources = {{VertexPoint{0}}};
  const auto observer = std::make_shared<test::RecordingObserver>();
  ASSERT_TRUE(engine_.fields().Compute(request, observer).ok());
  const auto uploaded = Upload(Grid(12));
  ASSERT_TRUE(uploaded.ok()) << uploaded.status();
  EXPECT_TRUE(observer->answer->ok());
  EXPECT_TRUE(absl::IsNotFound(engine_.meshes().Get(resident_).status()));
}

TEST_F(UploadAdmissionTest, WhenNobodyGivesMemoryBackTheRefusalComesAtOnce) {
  const auto pinned = engine_.meshes().Get(resident_);
  const absl::Status status = Upload(Grid(12)).status();
  EXPECT_TRUE(absl::IsResourceExhausted(status)) << status;
  EXPECT_TRUE(RetryAfter(status).has_value());
  EXPECT_EQ(engine_.upload_memory().used(), 0);
}

TEST_F(UploadAdmissionTest, WhatCanNeverFitIsRefusedWithTheFigures) {
  const TriangleSoup large = Grid(20);
  // Arrays by their header, before a byte is sent.
  const absl::Status arrays =
      engine_.meshes().StartUpload(test::ArrayHeader(large)).status();
  // A file when it is known what it holds.
  const std::string file = test::OffFile(large);
  const absl::Status parsed = Upload(OffHeader(file), file).status();
  for (const absl::Status& status : {arrays, parsed}) {
    EXPECT_TRUE(absl::IsResourceExhausted(status)) << status;
    EXPECT_FALSE(RetryAfter(status).has_value());
    EXPECT_THAT(std::string(status.message()),
                HasSubstr(absl::StrCat(engine_.limits().mesh_store_bytes)));
    EXPECT_THAT(std::string(status.message()), HasSubstr("--limit mesh-store"));
  }
}

// Upload memory for two small meshes on their way, not for both at a time.
class UploadMemoryTest : public UploadAdmissionTest {
 protected:
  UploadMemoryTest() : UploadAdmissionTest(LittleMemory()) {}

  static Limits LittleMemory() {
    Limits limits = RoomForOne();
    limits.mesh_store_bytes = uint64_t{64} << 20;
    const TriangleSoup soup = Grid(12);
    limits.upload_memory_bytes = 4 * test::ArrayHeader(soup).size_bytes;
    return limits;
  }
};

TEST_F(UploadMemoryTest, WhatItsFileCanNeverBeParsedInIsRefusedAtItsHeader) {
  const uint64_t capacity = engine_.limits().upload_memory_bytes;
  for (const auto& [size, fits] :
       {std::pair(capacity / 4, true), std::pair(capacity / 4 + 1, false)}) {
    const absl::Status status =
        engine_.meshes()
            .StartUpload({.format = MeshFormat::kObj, .size_bytes = size})
            .status();
    EXPECT_EQ(status.ok(), fits) << status;
    if (fits) continue;
    EXPECT_TRUE(absl::IsResourceExhausted(status)) << status;
    EXPECT_FALSE(RetryAfter(status).has_value());
    EXPECT_THAT(std::string(status.message()),
                HasSubstr("--limit upload-memory"));
  }
}

TEST_F(UploadMemoryTest, OneThatComesMeanwhileIsWaitedFor) {
  const TriangleSoup soup = Grid(12);
  std::unique_ptr<MeshUpload> other =
      Received(test::ArrayHeader(soup), test::ArrayBytes(soup));
  std::unique_ptr<MeshUpload> third =
      Received(test::ArrayHeader(soup), test::ArrayBytes(soup));
  Result result;
  Beside([&] {
    Finish(Received(test::ArrayHeader(soup), test::ArrayBytes(soup)), result);
    ExpectOneWaits();
    EXPECT_FALSE(result.has_value()) << result->status();
    other.reset();
    third.reset();
  });
  ASSERT_TRUE(result.has_value());
  EXPECT_TRUE(result->ok()) << result->status();
}

// Each holds what the others need; none runs that could give it back.
TEST_F(UploadMemoryTest, UploadsThatWaitForEachOtherDoNotWaitForEver) {
  Result results[3];
  std::unique_ptr<MeshUpload> uploads[3];
  for (uint32_t i = 0; i < 3; ++i) {
    const TriangleSoup soup = Grid(10 + i);
    uploads[i] = Received(test::ArrayHeader(soup), test::ArrayBytes(soup));
  }
  for (uint32_t i = 0; i < 3; ++i) Finish(std::move(uploads[i]), results[i]);
  executor_.RunAll();
  int built = 0;
  for (const Result& result : results) {
    ASSERT_TRUE(result.has_value());
    if (result->ok()) {
      ++built;
    } else {
      EXPECT_TRUE(RetryAfter(result->status()).has_value());
    }
  }
  EXPECT_GE(built, 2);
  EXPECT_EQ(engine_.upload_memory().used(), 0);
}

}  // namespace
}  // namespace geodesic::server
