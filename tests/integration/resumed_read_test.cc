// A connection that is cut while an answer comes: the client reads on where it
// broke, and what it ends with is what it would have had.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <string>

#include "geodesic_client/client.h"
#include "geodesic_client/errors.h"
#include "tests/integration/meshes.h"
#include "tests/integration/running_server.h"
#include "tests/support/tcp_relay.h"

namespace geodesic::client {
namespace {

class ResumedReadTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const absl::StatusOr<UploadOutcome> upload =
        direct_.UploadArrays(HillyGrid(kSide));
    ASSERT_TRUE(upload.ok()) << upload.status();
    query_ = {.mesh_digest = upload->mesh.digest,
              .sources = {{VertexPoint{0}}},
              .targets = {VertexPoint{7}, FacePoint{3, {0.2, 0.3, 0.5}}},
              .nearest_sources = true,
              .gradients = true};
    whole_ = direct_.ComputeField(query_);
    ASSERT_TRUE(whole_.ok()) << whole_.status();
  }

  void ExpectWhole(const absl::StatusOr<Field>& field) {
    ASSERT_TRUE(field.ok()) << field.status();
    EXPECT_EQ(field->distances, whole_->distances);
    EXPECT_EQ(field->nearest_sources, whole_->nearest_sources);
    EXPECT_EQ(field->gradients, whole_->gradients);
    EXPECT_EQ(field->target_distances, whole_->target_distances);
    EXPECT_EQ(field->settled_radius, whole_->settled_radius);
  }

  std::string RelayAddress() const {
    return "127.0.0.1:" + std::to_string(relay_.port());
  }
  static int PortOf(const std::string& address) {
    return std::stoi(address.substr(address.rfind(':') + 1));
  }

  // 160,801 vertices: the field has 36 bytes a vertex, in a dozen messages.
  static constexpr uint32_t kSide = 400;
  static constexpr uint64_t kVertices = uint64_t{401} * 401;
  static constexpr uint64_t kFieldBytes = kVertices * 36;

  TemporaryFolder folder_;
  RunningServer server_{folder_};
  geodesic::test::TcpRelay relay_{PortOf(server_.address())};
  Client direct_{server_.address()};
  FieldQuery query_;
  absl::StatusOr<Field> whole_;
};

// Before the first number, in the middle and after the last.
TEST_F(ResumedReadTest, ACutIsNotNoticed) {
  for (const uint64_t bytes :
       {uint64_t{1000}, kFieldBytes / 2, kFieldBytes - 1000}) {
    Client client(RelayAddress());
    relay_.CutAfter(bytes);
    ExpectWhole(client.ComputeField(query_));
  }
  EXPECT_EQ(relay_.cuts(), 3);
}

// In the middle, whatever was asked.
TEST_F(ResumedReadTest, EveryAnswerIsReadOn) {
  const std::string& mesh = query_.mesh_digest;
  const std::vector<Source> sources = {{VertexPoint{0}}, {VertexPoint{999}}};
  std::vector<SurfacePoint> targets;
  std::vector<PointPair> pairs;
  for (uint32_t i = 1; i <= 12; ++i) {
    targets.push_back(VertexPoint{(kSide + 1) * kSide + 30 * i});
    pairs.push_back({VertexPoint{i}, targets.back()});
  }
  Client cut(RelayAddress());
  int cuts = 0;
  // `ask` returns the numbers of an answer of about so many bytes.
  const auto expect_same = [&](uint64_t bytes, const auto& ask) {
    const std::vector<double> expected = ask(direct_);
    EXPECT_FALSE(expected.empty());
    EXPECT_TRUE(cut.ListMeshes().ok());  // has a connection
    relay_.CutAfter(bytes / 2);
    EXPECT_TRUE(ask(cut) == expected) << "after " << bytes / 2;
    EXPECT_EQ(relay_.cuts(), ++cuts);
  };
  std::vector<double> numbers;
  const auto add = [&numbers](const Polyline& line) {
    for (const Point& point : line.positions) {
      numbers.insert(numbers.end(), point.begin(), point.end());
    }
  };

  for (const bool sparse : {false, true}) {
    expect_same((sparse ? 24 : 16) * kVertices, [&](Client& client) {
      numbers.clear();
      EXPECT_TRUE(
          client
              .ComputeMatrix(
                  {.mesh_digest = mesh, .sources = sources, .sparse = sparse},
                  {.on_row =
                       [&](const MatrixRow& row) {
                         numbers.insert(numbers.end(), row.values.begin(),
                                        row.values.end());
                         return absl::OkStatus();
                       }})
              .ok());
      return numbers;
    });
  }
  expect_same(2 * 12 * targets.size(), [&](Client& client) {
    const auto answer = client.FindNearest({.mesh_digest = mesh,
                                            .sources = sources,
                                            .targets = targets,
                                            .count = targets.size()});
    numbers.clear();
    for (const auto& found : answer->found) {
      for (const NearestTarget& target : found) {
        numbers.push_back(static_cast<double>(target.target));
        numbers.push_back(target.distance);
      }
    }
    return numbers;
  });
  expect_same(57 * kSide * targets.size(), [&](Client& client) {
    const auto answer = client.ComputePaths(
        {.mesh_digest = mesh, .sources = sources, .targets = targets});
    numbers.clear();
    for (const GeodesicPath& path : answer->paths) add(path.line);
    return numbers;
  });
  expect_same(57 * kSide * pairs.size(), [&](Client& client) {
    const auto answer = client.ComputePairs(
        {.mesh_digest = mesh, .pairs = pairs, .paths = true});
    numbers = answer->distances;
    for (const Polyline& path : answer->paths) add(path);
    return numbers;
  });
  expect_same(3 * 57 * kSide, [&](Client& client) {
    const auto answer = client.ComputeIsolines(
        {.mesh_digest = mesh, .sources = sources, .levels = {0.3, 0.6, 0.9}});
    numbers.clear();
    for (const Isoline& isoline : answer->isolines) add(isoline.line);
    return numbers;
  });
  expect_same(60, [&](Client& client) {
    const auto answer = client.SampleFarthestPoints(
        {.mesh_digest = mesh, .sources = sources, .count = 5});
    numbers.clear();
    for (const FarthestSample& sample : answer->samples) {
      numbers.push_back(static_cast<double>(sample.vertex));
      numbers.push_back(sample.distance);
    }
    return numbers;
  });
  expect_same(16 * kVertices, [&](Client& client) {
    const auto answer =
        client.ComputeLogMap({.mesh_digest = mesh, .source = VertexPoint{999}});
    numbers.assign(answer->zero_direction.begin(),
                   answer->zero_direction.end());
    for (const auto& [x, y] : answer->coordinates) {
      numbers.insert(numbers.end(), {x, y});
    }
    return numbers;
  });
}

TEST_F(ResumedReadTest, AFieldThatWasDroppedMeanwhileIsAskedForAgain) {
  Client client(RelayAddress());
  ASSERT_TRUE(client.ListMeshes().ok());  // has a connection
  relay_.CutAfter(kFieldBytes / 2);
  relay_.Hold();
  auto field = std::async(std::launch::async,
                          [&] { return client.ComputeField(query_); });
  while (relay_.cuts() == 0 && field.wait_for(std::chrono::milliseconds(1)) !=
                                   std::future_status::ready) {
  }
  // The mesh is there again, its fields are not.
  ASSERT_TRUE(direct_.DeleteMesh(query_.mesh_digest).ok());
  ASSERT_TRUE(direct_.UploadArrays(HillyGrid(kSide)).ok());
  relay_.Release();
  const absl::StatusOr<Field> again = field.get();
  ExpectWhole(again);
  EXPECT_EQ(again->origin, FieldOrigin::kComputed);
}

TEST_F(ResumedReadTest, WithoutRetriesTheErrorIsReported) {
  Client client(RelayAddress(), {.retry = false});
  relay_.CutAfter(kFieldBytes / 2);
  EXPECT_TRUE(absl::IsUnavailable(client.ComputeField(query_).status()));
  ExpectWhole(client.ComputeField(query_));
}

TEST_F(ResumedReadTest, AMeshThatWentMeanwhileIsReportedMissing) {
  Client client(RelayAddress());
  FieldQuery other = query_;
  other.sources = {{VertexPoint{1}}};
  bool deleted = false;
  const absl::StatusOr<Field> field =
      client.ComputeField(other, {}, [&](const SolveProgress&) {
        if (deleted) return;
        deleted = true;
        EXPECT_TRUE(direct_.DeleteMesh(other.mesh_digest).ok());
        relay_.Cut();
      });
  ASSERT_TRUE(deleted) << "the solver had ended before it reported";
  // The one error that AskAboutFile answers with an upload.
  EXPECT_EQ(ErrorReason(field.status()), "MESH_NOT_RESIDENT") << field.status();
}

}  // namespace
}  // namespace geodesic::client
