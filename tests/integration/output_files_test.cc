// What `geodesic field -o` leaves on the disk.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "tests/integration/meshes.h"
#include "tests/integration/running_server.h"

namespace geodesic::client {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr uint32_t kGrid = 6;
constexpr size_t kVertices = (kGrid + 1) * (kGrid + 1);

std::vector<double> Doubles(const std::string& bytes) {
  std::vector<double> values(bytes.size() / sizeof(double));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(double));
  return values;
}

double Euclid(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

class OutputFilesTest : public IntegrationTest {
 protected:
  void SetUp() override {
    WriteFile(folder_ / "grid.off", OffText(mesh_));
    field_ = GeodesicJson({"field", folder_ / "grid.off", "--source", "0",
                           "--size", "320x240", "-o", folder_ / "d.npy", "-o",
                           folder_ / "d.csv", "-o", folder_ / "d.f64", "-o",
                           folder_ / "d.ply", "-o", folder_ / "d.vtk", "-o",
                           folder_ / "d.png"});
  }

  MeshArrays mesh_ = PlanarGrid(kGrid);
  json field_;
};

TEST_F(OutputFilesTest, SayWhatTheyAre) {
  ASSERT_EQ(field_["outputs"].size(), 6);
  for (const json& output : field_["outputs"]) {
    EXPECT_EQ(output["bytes"],
              FileBytes(output["path"].get<std::string>()).size());
  }
  EXPECT_EQ(field_["vertices"], kVertices);
  EXPECT_EQ(field_["unreachable_vertices"], 0);
  EXPECT_EQ(field_["farthest_vertex"], kVertices - 1);
  EXPECT_NEAR(field_["largest_distance"], std::sqrt(2), 1e-10);
  EXPECT_EQ(field_["mesh"], MeshDigest(mesh_));
  EXPECT_GT(field_["relative_tolerance"], 0);
  EXPECT_GT(field_["statistics"]["windows_created"], 0);
}

TEST_F(OutputFilesTest, RawIsEuclidInThePlane) {
  const std::vector<double> distances = Doubles(FileBytes(folder_ / "d.f64"));
  ASSERT_EQ(distances.size(), kVertices);
  for (size_t v = 0; v < kVertices; ++v) {
    EXPECT_NEAR(distances[v], Euclid(mesh_.positions[0], mesh_.positions[v]),
                1e-10)
        << v;
  }
}

TEST_F(OutputFilesTest, AllHoldTheSameDistances) {
  const std::string raw = FileBytes(folder_ / "d.f64");
  const std::vector<double> distances = Doubles(raw);
  EXPECT_EQ(FileBytes(folder_ / "d.npy").substr(128), raw);

  std::istringstream csv(FileBytes(folder_ / "d.csv"));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "vertex,geodesic_distance");
  for (size_t v = 0; v < kVertices; ++v) {
    ASSERT_TRUE(std::getline(csv, line));
    const size_t comma = line.find(',');
    EXPECT_EQ(std::stoul(line), v);
    EXPECT_EQ(std::stod(line.substr(comma + 1)), distances[v]);
  }

  const std::string ply = FileBytes(folder_ / "d.ply");
  const size_t body = ply.find("end_header\n") + 11;
  for (size_t v = 0; v < kVertices; ++v) {
    EXPECT_EQ(Doubles(ply.substr(body + 32 * v, 32)),
              (std::vector<double>{mesh_.positions[v][0], mesh_.positions[v][1],
                                   mesh_.positions[v][2], distances[v]}));
  }
  EXPECT_EQ(ply.size(), body + 32 * kVertices + 13 * mesh_.triangles.size());

  const std::string vtk = FileBytes(folder_ / "d.vtk");
  EXPECT_THAT(vtk, HasSubstr("SCALARS geodesic_distance double 1\n"));
  std::string values =
      vtk.substr(vtk.size() - 1 - 8 * kVertices, 8 * kVertices);
  for (size_t v = 0; v < kVertices; ++v) {
    std::reverse(values.begin() + 8 * v, values.begin() + 8 * v + 8);
  }
  EXPECT_EQ(values, raw);
}

TEST_F(OutputFilesTest, TheServerReadsThePlyBack) {
  // The file is a mesh again, and the same one.
  const json upload = GeodesicJson({"upload", folder_ / "d.ply"});
  EXPECT_EQ(upload["mesh"]["digest"], MeshDigest(mesh_));
}

TEST_F(OutputFilesTest, ThePictureIsAPngOfTheSizeAskedFor) {
  const std::string png = FileBytes(folder_ / "d.png");
  EXPECT_THAT(png, StartsWith("\x89PNG\r\n\x1a\n"));
  // IHDR: width and height, big endian.
  EXPECT_EQ(png.substr(16, 8), std::string("\0\0\x01\x40\0\0\0\xf0", 8));
}

TEST_F(OutputFilesTest, NothingElseIsLeft) {
  // The mesh, six outputs and the server's log.
  EXPECT_EQ(folder_.count(), 8);
}

class UnreachableTest : public IntegrationTest {};

TEST_F(UnreachableTest, IsInfEverywhere) {
  MeshArrays mesh = PlanarGrid(2);
  mesh.positions.push_back({5, 5, 5});
  WriteFile(folder_ / "m.off", OffText(mesh));
  const json field = GeodesicJson({"field", folder_ / "m.off", "-s", "0", "-o",
                                   folder_ / "d.csv", "-o", folder_ / "d.f64"});
  EXPECT_EQ(field["unreachable_vertices"], 1);
  EXPECT_THAT(FileBytes(folder_ / "d.csv"), HasSubstr("\n9,inf\n"));
  EXPECT_EQ(Doubles(FileBytes(folder_ / "d.f64"))[9],
            std::numeric_limits<double>::infinity());
}

TEST_F(UnreachableTest, SourcesHaveOffsets) {
  WriteFile(folder_ / "m.off", OffText(PlanarGrid(4)));
  GeodesicJson({"field", folder_ / "m.off", "-s", "0:0.5", "-s", "24:0.25",
                "-o", folder_ / "d.f64"});
  const std::vector<double> distances = Doubles(FileBytes(folder_ / "d.f64"));
  EXPECT_EQ(distances[0], 0.5);
  EXPECT_EQ(distances[24], 0.25);
  EXPECT_NEAR(distances[1], 0.75, 1e-10);
}

}  // namespace
}  // namespace geodesic::client
