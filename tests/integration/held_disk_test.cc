// A disk that does not answer holds up nobody who does not need it.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "geodesic_client/client.h"
#include "tests/integration/meshes.h"
#include "tests/integration/running_server.h"
#include "tests/support/until.h"

namespace geodesic::client {
namespace {

// A server of two threads with a data folder, whose disk can be held.
class HeldDiskTest : public ::testing::Test {
 protected:
  HeldDiskTest() { Start(); }

  void Start() {
    setenv("LD_PRELOAD", GEODESIC_HELD_DISK_LIBRARY, 1);
    setenv("GEODESIC_HELD_DISK", pipe_.c_str(), 1);
    server_.emplace(folder_, std::vector<std::string>{
                                 "--data-dir", folder_ / "data", "--threads",
                                 "2", "--drain-seconds", "1"});
    unsetenv("LD_PRELOAD");
    unsetenv("GEODESIC_HELD_DISK");
  }

  // The distances from a vertex of a mesh.
  auto Ask(const std::string& digest, uint32_t source) const {
    return std::async(std::launch::async, [this, digest, source] {
      return Client(server_->address(), {.retry = false})
          .ComputeField(
              {.mesh_digest = digest, .sources = {{VertexPoint{source}}}});
    });
  }

  void Hold() const { ASSERT_EQ(mkfifo(pipe_.c_str(), 0600), 0); }

  // Lets those go who wait, and who come.
  void Release() const {
    const int writer = open(pipe_.c_str(), O_RDWR);
    ASSERT_GE(writer, 0);
    std::filesystem::remove(pipe_);
    close(writer);
  }

  // Waits until so many flushes are held.
  void AwaitHeld(uint64_t count) const {
    const std::string held = pipe_ + ".held";
    ASSERT_TRUE(test::Until([&] {
      std::error_code none_yet;
      const uint64_t size = std::filesystem::file_size(held, none_yet);
      return !none_yet && size >= count;
    }));
  }

  // Restarts the server once so many fields and graphs are kept, and has it
  // load the mesh.
  void RestartWith(uint32_t kept, const std::string& digest) {
    const std::filesystem::path fields =
        std::filesystem::path(folder_ / "data") / "fields";
    ASSERT_TRUE(test::Until([&] {
      uint32_t count = 0;
      for (const auto& file : std::filesystem::directory_iterator(fields)) {
        count += file.path().extension() == ".field";
      }
      return count == kept;
    }));
    server_->Terminate();
    ASSERT_EQ(server_->Wait(), 0);
    Start();
    ASSERT_TRUE(Ask(digest, 100).get().ok());
  }

  std::future<absl::StatusOr<UploadOutcome>> Upload(int side) const {
    return std::async(std::launch::async, [this, side] {
      return Client(server_->address(), {.retry = false})
          .UploadArrays(HillyGrid(side));
    });
  }

  TemporaryFolder folder_;
  const std::string pipe_ = folder_ / "held";
  std::optional<RunningServer> server_;
};

TEST_F(HeldDiskTest, QuestionsAboutResidentMeshesAreAnswered) {
  Client client(server_->address());
  const auto resident = client.UploadArrays(HillyGrid(40));
  ASSERT_TRUE(resident.ok()) << resident.status();
  Hold();
  std::vector<std::future<absl::StatusOr<UploadOutcome>>> uploads;
  for (const int side : {20, 21, 22, 23, 24, 25}) {
    uploads.push_back(Upload(side));
  }
  // As many as threads compute, and more.
  AwaitHeld(4);
  for (uint32_t source = 0; source < 20; ++source) {
    const auto field =
        client.ComputeField({.mesh_digest = resident->mesh.digest,
                             .sources = {{VertexPoint{source}}}});
    ASSERT_TRUE(field.ok()) << field.status();
  }
  for (auto& upload : uploads) {
    EXPECT_EQ(upload.wait_for(std::chrono::seconds(0)),
              std::future_status::timeout)
        << "acknowledged before it is on the disk";
  }
  Release();
  for (auto& upload : uploads) {
    const auto outcome = upload.get();
    EXPECT_TRUE(outcome.ok()) << outcome.status();
  }
}

TEST_F(HeldDiskTest, FieldsThatAreReadHoldUpNobodyElse) {
  const auto mesh = Upload(40).get();
  ASSERT_TRUE(mesh.ok()) << mesh.status();
  const std::string& digest = mesh->mesh.digest;
  constexpr uint32_t kKept = 3;
  for (uint32_t source = 0; source < kKept; ++source) {
    ASSERT_TRUE(Ask(digest, source).get().ok());
  }
  RestartWith(kKept, digest);
  Hold();
  std::vector<std::future<absl::StatusOr<Field>>> kept;
  for (uint32_t source = 0; source < kKept; ++source) {
    kept.push_back(Ask(digest, source));
  }
  // More than threads that compute.
  AwaitHeld(kKept);
  EXPECT_TRUE(Ask(digest, 101).get().ok());
  Release();
  for (auto& answer : kept) {
    const absl::StatusOr<Field> field = answer.get();
    ASSERT_TRUE(field.ok()) << field.status();
    EXPECT_EQ(field->origin, FieldOrigin::kCached);
  }
}

TEST_F(HeldDiskTest, GraphsThatAreReadHoldUpNobodyElse) {
  const auto mesh = Upload(40).get();
  ASSERT_TRUE(mesh.ok()) << mesh.status();
  const std::string& digest = mesh->mesh.digest;
  // As many graphs as threads that compute.
  const auto ask = [&](uint32_t neighbours, uint32_t source) {
    return std::async(std::launch::async, [this, digest, neighbours, source] {
      return Client(server_->address(), {.retry = false})
          .ComputeField({.mesh_digest = digest,
                         .sources = {{VertexPoint{source}}},
                         .algorithm = "svg",
                         .approximation = {.neighbours = neighbours}});
    });
  };
  ASSERT_TRUE(ask(10, 0).get().ok());
  ASSERT_TRUE(ask(11, 0).get().ok());
  RestartWith(4, digest);
  Hold();
  auto first = ask(10, 1), second = ask(11, 1);
  AwaitHeld(2);
  EXPECT_TRUE(Ask(digest, 101).get().ok());
  Release();
  EXPECT_TRUE(first.get().ok());
  EXPECT_TRUE(second.get().ok());
}

TEST_F(HeldDiskTest, LandmarksThatAreReadHoldUpNoPairs) {
  const auto mesh = Upload(40).get();
  ASSERT_TRUE(mesh.ok()) << mesh.status();
  // So many that landmarks are worth their time; no two share an end.
  PairQuery query{.mesh_digest = mesh->mesh.digest};
  for (uint32_t v = 0; v < 800; ++v) {
    query.pairs.push_back({VertexPoint{v}, VertexPoint{v + 800}});
  }
  const auto ask = [&] {
    return Client(server_->address(), {.retry = false}).ComputePairs(query);
  };
  const auto before = ask();
  ASSERT_TRUE(before.ok()) << before.status();
  RestartWith(1, query.mesh_digest);
  Hold();
  const auto while_held = ask();
  ASSERT_TRUE(while_held.ok()) << while_held.status();
  AwaitHeld(1);
  Release();
  ASSERT_EQ(while_held->distances.size(), before->distances.size());
  for (size_t i = 0; i < before->distances.size(); ++i) {
    ASSERT_NEAR(while_held->distances[i], before->distances[i],
                1e-10 * before->distances[i]);
  }
}

TEST_F(HeldDiskTest, TheServerEndsAllTheSame) {
  Hold();
  auto upload = Upload(20);
  AwaitHeld(1);
  server_->Terminate();
  EXPECT_EQ(server_->Wait(), 3);
  EXPECT_FALSE(upload.get().ok());
}

}  // namespace
}  // namespace geodesic::client
