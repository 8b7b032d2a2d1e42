// What `geodesic field -o` leaves on the disk.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>

#include "tests/integration/planar_grid_test.h"

namespace geodesic::client {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

std::vector<double> Doubles(const std::string& bytes) {
  std::vector<double> values(bytes.size() / sizeof(double));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(double));
  return values;
}

class OutputFilesTest : public PlanarGridTest {
 protected:
  void SetUp() override {
    PlanarGridTest::SetUp();
    std::vector<std::string> words = {"field", grid_,    "--source",
                                      "0",     "--size", "320x240"};
    for (const char* name :
         {"d.npy", "d.csv", "d.f64", "d.ply", "d.vtk", "d.png"}) {
      words.insert(words.end(), {"-o", folder_ / name});
    }
    field_ = GeodesicJson(words);
  }

  json field_;
};

TEST_F(OutputFilesTest, SayWhatTheyAre) {
  ASSERT_EQ(field_["outputs"].size(), 6);
  for (const json& output : field_["outputs"]) {
    EXPECT_EQ(output["bytes"],
              FileBytes(output["path"].get<std::string>()).size());
  }
  EXPECT_EQ(field_["vertices"], vertex_count_);
  EXPECT_EQ(field_["unreachable_vertices"], 0);
  EXPECT_EQ(field_["farthest_vertex"], vertex_count_ - 1);
  EXPECT_NEAR(field_["largest_distance"], std::sqrt(2), kTolerance);
  EXPECT_EQ(field_["mesh"], digest_);
  EXPECT_GT(field_["relative_tolerance"], 0);
  EXPECT_GT(field_["statistics"]["windows_created"], 0);
}

TEST_F(OutputFilesTest, AllHoldTheSameDistances) {
  const std::string raw = FileBytes(folder_ / "d.f64");
  const std::vector<double> distances = Doubles(raw);
  ASSERT_EQ(distances.size(), vertex_count_);
  EXPECT_EQ(FileBytes(folder_ / "d.npy").substr(128), raw);

  const std::string csv = FileBytes(folder_ / "d.csv");
  EXPECT_THAT(csv, StartsWith("vertex,geodesic_distance\n"));
  const std::vector<std::vector<double>> rows = Rows(csv);
  ASSERT_EQ(rows.size(), vertex_count_);
  for (size_t v = 0; v < vertex_count_; ++v) {
    EXPECT_NEAR(distances[v], Euclid(At(0), At(v)), 1e-10) << v;
    EXPECT_EQ(rows[v],
              (std::vector<double>{static_cast<double>(v), distances[v]}));
  }

  // The mesh, with the distances beside it.
  EXPECT_THAT(FileBytes(folder_ / "d.ply"),
              HasSubstr("property double geodesic_distance\n"));
  EXPECT_THAT(FileBytes(folder_ / "d.vtk"),
              HasSubstr("SCALARS geodesic_distance double 1\n"));
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

// Doubles and the order of vertices are kept, compressed or not.
TEST_F(OutputFilesTest, AreTheSameMeshAgain) {
  const json packed =
      GeodesicJson({"field", grid_, "--source", "0", "-o", folder_ / "d.ply.gz",
                    "-o", folder_ / "d.vtk.gz"});
  for (const json& output : packed["outputs"]) {
    EXPECT_EQ(output["bytes"],
              FileBytes(output["path"].get<std::string>()).size());
  }
  for (const char* name : {"d.ply", "d.vtk", "d.ply.gz", "d.vtk.gz"}) {
    EXPECT_EQ(GeodesicJson({"distance", folder_ / name, "0", "1"})["mesh"],
              digest_)
        << name;
  }
  EXPECT_LT(FileBytes(folder_ / "d.vtk.gz").size(),
            FileBytes(folder_ / "d.vtk").size());
}

// A square of two triangles, as one polygon, with colours.
TEST_F(OutputFilesTest, PlyKeepsWhatTheFileHeld) {
  WriteFile(folder_ / "square.ply",
            "ply\nformat ascii 1.0\ncomment mine\nelement vertex 4\n"
            "property float x\nproperty float y\nproperty float z\n"
            "property uchar red\nelement face 1\n"
            "property list uchar int vertex_indices\nend_header\n"
            "0 0 0 10\n1 0 0 20\n1 1 0 30\n0 1.0 0 40\n4 0 1 2 3\n");
  GeodesicJson({"field", folder_ / "square.ply", "--source", "0", "-o",
                folder_ / "result.ply"});
  EXPECT_THAT(
      FileBytes(folder_ / "result.ply"),
      AllOf(
          HasSubstr("comment mine\nelement vertex 4\n"),
          HasSubstr("property uchar red\nproperty double geodesic_distance\n"),
          EndsWith("end_header\n0 0 0 10 0\n1 0 0 20 1\n"
                   "1 1 0 30 1.4142135623730951\n0 1.0 0 40 1\n"
                   "4 0 1 2 3\n")));
  // What came from elsewhere, or is another file by now, has nothing to keep.
  const json upload = GeodesicJson({"upload", folder_ / "square.ply"});
  const std::string digest = upload["mesh"]["digest"];
  GeodesicJson({"field", digest, "--source", "0", "-o", folder_ / "plain.ply"});
  EXPECT_THAT(FileBytes(folder_ / "plain.ply"),
              AllOf(HasSubstr("property double x"), Not(HasSubstr("red"))));
}

// Lines that end as they did on old Macs are read, but not written.
TEST_F(OutputFilesTest, PlyThatCannotBeKeptIsNotWrittenOver) {
  const std::string old_mac =
      "ply\rformat ascii 1.0\relement vertex 3\rproperty float x\r"
      "property float y\rproperty float z\relement face 1\r"
      "property list uchar int vertex_indices\rend_header\r"
      "0 0 0\r1 0 0\r0 1 0\r3 0 1 2\r";
  WriteFile(folder_ / "mac.ply", old_mac);
  const ProcessResult over =
      Geodesic({"field", folder_ / "mac.ply", "--source", "0", "--in-place",
                "-o", folder_ / "mac.ply"});
  EXPECT_EQ(over.exit_code, 3) << over.err;
  EXPECT_THAT(over.err, HasSubstr("write to another file"));
  EXPECT_EQ(FileBytes(folder_ / "mac.ply"), old_mac);
  const ProcessResult beside =
      Geodesic({"field", folder_ / "mac.ply", "--source", "0", "-o",
                folder_ / "plain.ply", "--quiet"});
  EXPECT_EQ(beside.exit_code, 0) << beside.err;
  EXPECT_THAT(beside.err, HasSubstr("cannot be kept"));
}

TEST_F(OutputFilesTest, PlyIsAddedToInPlaceIfToldSo) {
  const std::string ply = folder_ / "d.ply";
  std::filesystem::create_symlink(ply, folder_ / "link.ply");
  std::filesystem::create_hard_link(ply, folder_ / "hard.ply");
  const std::string before = FileBytes(ply);
  for (const std::string question : {"field", "logmap"}) {
    for (const char* name : {"d.ply", "link.ply", "hard.ply"}) {
      EXPECT_THAT(Refusal({question, ply, "-s", "40", "-o", folder_ / name}, 3),
                  AllOf(HasSubstr("it is read by this command"),
                        HasSubstr("--in-place")))
          << question << name;
      EXPECT_EQ(FileBytes(ply), before);
    }
  }
  const ProcessResult added = Geodesic(
      {"logmap", ply, "-s", "40", "-o", folder_ / "link.ply", "--in-place"});
  EXPECT_EQ(added.exit_code, 0) << added.err;
  EXPECT_THAT(FileBytes(ply),
              HasSubstr("property double geodesic_distance\n"
                        "property double u\nproperty double v\n"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link.ply"));
}

TEST_F(OutputFilesTest, WhatACommandReadsIsNotWrittenOver) {
  const std::string mesh = folder_ / "square.obj";
  WriteFile(mesh, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n");
  const std::string ply = folder_ / "d.ply";
  const std::string list = folder_ / "list.csv";
  WriteFile(list, "1\n");
  const std::string pairs = folder_ / "pairs.csv";
  WriteFile(pairs, "1,2\n");
  const std::string names = folder_ / "names.csv";
  WriteFile(names, "tip 1\n");
  const std::string tip = "name:tip@" + names;
  const std::vector<std::pair<std::string, std::vector<std::string>>> table = {
      {mesh, {"path", mesh, "-s", "0", "-t", "3", "-o", mesh}},
      {mesh, {"isolines", mesh, "-s", "0", "-n", "2", "-o", mesh}},
      {mesh, {"distance", mesh, "0", "1", "-o", folder_ / "./square.obj"}},
      {ply, {"isolines", ply, "-s", "0", "-n", "2", "-o", ply}},
      {ply, {"sample", ply, "-n", "2", "-o", ply}},
      {list, {"matrix", mesh, "--sources", list, "-o", list}},
      {list, {"nearest", mesh, "-s", "0", "--targets", list, "-o", list}},
      {pairs, {"distance", mesh, "--pairs", pairs, "-o", pairs}},
      {names, {"field", mesh, "-s", tip + ":0.5", "-o", names}},
      {names, {"distance", mesh, "0", tip, "-o", names}}};
  for (const auto& [file, words] : table) {
    const std::string before = FileBytes(file);
    EXPECT_THAT(Refusal(words, 3),
                AllOf(HasSubstr("it is read by this command"),
                      HasSubstr("write to another file")))
        << words[0];
    EXPECT_EQ(FileBytes(file), before) << words[0];
  }
}

}  // namespace
}  // namespace geodesic::client
