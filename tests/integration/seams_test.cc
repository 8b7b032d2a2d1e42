// Meshes whose faces are kept apart where they belong together, through the
// server, the client library and the command.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "geodesic_client/client.h"
#include "tests/integration/meshes.h"
#include "tests/integration/running_server.h"

namespace geodesic::client {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// A cube of side 2 whose sides share no vertex, 0 to 3 at the bottom, 4 to 7
// at the top.
constexpr char kBox[] =
    "v 0 0 0\nv 0 2 0\nv 2 2 0\nv 2 0 0\n"
    "v 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\n"
    "v 0 0 0\nv 2 0 0\nv 2 0 2\nv 0 0 2\n"
    "v 2 0 0\nv 2 2 0\nv 2 2 2\nv 2 0 2\n"
    "v 2 2 0\nv 0 2 0\nv 0 2 2\nv 2 2 2\n"
    "v 0 2 0\nv 0 0 0\nv 0 0 2\nv 0 2 2\n"
    "f 1 2 3 4\nf 5 6 7 8\nf 9 10 11 12\nf 13 14 15 16\nf 17 18 19 20\n"
    "f 21 22 23 24\n";
constexpr char kJoined[] = "joined 12 seam edges";

class SeamsTest : public IntegrationTest {
 protected:
  void SetUp() override { WriteFile(box_, kBox); }

  const std::string box_ = folder_ / "box.obj";
  Client client_{server_.address()};
};

TEST_F(SeamsTest, AreJoinedAndTold) {
  const auto upload = client_.UploadFile(box_);
  ASSERT_TRUE(upload.ok()) << upload.status();
  EXPECT_EQ(upload->mesh.vertices, 24);
  EXPECT_EQ(upload->mesh.boundary_edges, 0);
  EXPECT_EQ(upload->mesh.isolated_vertices, 0);
  EXPECT_EQ(upload->mesh.seam_edges, 12);
  EXPECT_EQ(upload->mesh.joined_vertices, 16);
  EXPECT_THAT(upload->mesh.notes, ElementsAre(kJoined));
  const auto field = client_.ComputeField(
      {.mesh_digest = upload->mesh.digest, .sources = {{VertexPoint{0}}}});
  ASSERT_TRUE(field.ok()) << field.status();
  EXPECT_THAT(field->mesh_notes, ElementsAre(kJoined));
  // 4, 11 and 22 lie above 0, a side away; 6, 14 and 19 opposite.
  for (const int v : {4, 11, 22}) EXPECT_EQ(field->distances[v], 2);
  for (const int v : {6, 14, 19}) {
    EXPECT_NEAR(field->distances[v], 2 * std::sqrt(5.0), 1e-15) << v;
  }
  for (const int v : {0, 8, 21}) EXPECT_EQ(field->distances[v], 0);
  const auto mesh = client_.ReadMesh(upload->mesh.digest);
  ASSERT_TRUE(mesh.ok()) << mesh.status();
  EXPECT_EQ(mesh->joined.size(), 16);
}

TEST_F(SeamsTest, WeldingIsPartOfTheQuestionAndOfTheMesh) {
  const auto usual = client_.UploadFile(box_);
  const auto apart =
      client_.UploadFile(box_, MeshFormat::kObj, {.keep_seams = true});
  const auto within =
      client_.UploadFile(box_, MeshFormat::kObj, {.distance = 0.1});
  ASSERT_TRUE(usual.ok() && apart.ok() && within.ok());
  EXPECT_EQ(apart->mesh.components, 6);
  EXPECT_THAT(apart->mesh.notes,
              ElementsAre(HasSubstr("24 boundary edges lie within 0 of")));
  EXPECT_NE(apart->mesh.digest, usual->mesh.digest);
  // The same was joined.
  EXPECT_EQ(within->mesh.digest, usual->mesh.digest);
  EXPECT_EQ(*client_.FindFile(box_, MeshFormat::kObj), usual->mesh.digest);
  EXPECT_EQ(*client_.FindFile(box_, MeshFormat::kObj, {.keep_seams = true}),
            apart->mesh.digest);
  const auto wrong =
      client_.UploadFile(box_, MeshFormat::kObj, {.distance = -1.0});
  EXPECT_TRUE(absl::IsInvalidArgument(wrong.status())) << wrong.status();
  EXPECT_THAT(std::string(wrong.status().message()),
              HasSubstr("weld_distance"));
}

TEST_F(SeamsTest, TheCommandTellsOfThem) {
  EXPECT_THAT(Geodesic({"info", box_}).out, HasSubstr(kJoined));
  EXPECT_THAT(json::parse(Geodesic({"--json", "info", box_}).out)["notes"],
              ElementsAre(kJoined));
  const ProcessResult field = Geodesic({"field", box_, "-s", "4"});
  EXPECT_THAT(field.out, HasSubstr(kJoined));
  const json distance =
      json::parse(Geodesic({"--json", "distance", box_, "4", "0"}).out);
  EXPECT_THAT(distance["notes"], ElementsAre(kJoined));
  EXPECT_EQ(distance["distance"], 2);
  const json apart = json::parse(
      Geodesic({"--json", "distance", box_, "4", "0", "--no-weld"}).out);
  EXPECT_TRUE(apart["distance"].is_null());
  EXPECT_EQ(Geodesic({"info", box_, "--weld", "1", "--no-weld"}).exit_code, 2);
}

}  // namespace
}  // namespace geodesic::client
