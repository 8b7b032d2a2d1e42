#include "client/output/field_writers.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "tests/client/written.h"

namespace geodesic::client {
namespace {

const std::vector<double>& Distances() {
  static const auto& distances =
      *new std::vector<double>{0, 0.1, 1.0 / 3, kInfinity};
  return distances;
}

Column DistanceColumn(const std::vector<double>& distances = Distances()) {
  return {.name = kDistanceColumn, .values = distances};
}

// Nearest sources and gradients too.
std::vector<Column> AllColumns() {
  return {DistanceColumn(),
          {.name = kNearestSourceColumn,
           .values = {0, 1, 1, -1},
           .type = NumberType::kInt32},
          {.name = kGradientColumn,
           .values = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0.5},
           .components = 3}};
}

MeshArrays Square() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.1}},
          {{0, 1, 2}, {2, 1, 3}}};
}

template <typename Value>
Value At(const std::string& bytes, size_t offset) {
  Value value;
  std::memcpy(&value, bytes.data() + offset, sizeof(value));
  return value;
}

double BigEndianDouble(const std::string& bytes, size_t offset) {
  const uint64_t swapped = __builtin_bswap64(At<uint64_t>(bytes, offset));
  double value;
  std::memcpy(&value, &swapped, sizeof(value));
  return value;
}

TEST(FieldWritersTest, Npy) {
  const std::string bytes =
      Written([](AtomicFile* file) { WriteNpy(DistanceColumn(), file); });
  // The layout of NumPy's format 1.0: magic, version, length of the header.
  ASSERT_EQ(bytes.size(), 128 + 32);
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  EXPECT_EQ(At<uint16_t>(bytes, 8), 118);
  EXPECT_EQ(bytes.substr(10, 59),
            "{'descr': '<f8', 'fortran_order': False, 'shape': (4,), }  ");
  EXPECT_EQ(bytes[127], '\n');
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(At<double>(bytes, 128 + 8 * i), Distances()[i]);
  }
}

TEST(FieldWritersTest, NpyHeaderFillsBlocksWhateverTheCount) {
  for (const size_t count : {0, 9, 10, 99999}) {
    const std::vector<double> distances(count, 1);
    const std::string bytes = Written(
        [&](AtomicFile* file) { WriteNpy(DistanceColumn(distances), file); });
    EXPECT_EQ((bytes.size() - 8 * count) % 64, 0);
  }
}

TEST(FieldWritersTest, CsvGivesTheSameDoublesAgain) {
  const std::vector<double> distances = {5e-324, 1.7976931348623157e308,
                                         0.1 + 0.2, 123456789.123456789};
  const std::string text = Written([&](AtomicFile* file) {
    WriteCsv(std::vector{DistanceColumn(distances)}, file);
  });
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  for (const double distance : distances) {
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_EQ(std::strtod(line.c_str() + 2, nullptr), distance) << line;
  }
}

TEST(FieldWritersTest, Raw) {
  const std::string bytes = Written([](AtomicFile* file) {
    AppendNumbers(DistanceColumn().values, NumberType::kFloat64, file);
  });
  ASSERT_EQ(bytes.size(), 32);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(At<double>(bytes, 8 * i), Distances()[i]);
  }
}

TEST(FieldWritersTest, Ply) {
  const std::string bytes =
      Written([](AtomicFile* file) { WritePly(Square(), AllColumns(), file); });
  const std::string header =
      "ply\n"
      "format binary_little_endian 1.0\n"
      "comment distances in the unit of the coordinates\n"
      "element vertex 4\n"
      "property double x\n"
      "property double y\n"
      "property double z\n"
      "property double geodesic_distance\n"
      "property int nearest_source\n"
      "property double gradient_x\n"
      "property double gradient_y\n"
      "property double gradient_z\n"
      "element face 2\n"
      "property list uchar int vertex_indices\n"
      "end_header\n";
  ASSERT_EQ(bytes.substr(0, header.size()), header);
  constexpr size_t kRow = 4 * 8 + 4 + 3 * 8;
  const size_t vertex = header.size() + 3 * kRow;  // the last one
  const size_t faces = vertex + kRow;
  ASSERT_EQ(bytes.size(), faces + 2 * 13);
  EXPECT_EQ(At<double>(bytes, vertex + 16), 0.1);
  EXPECT_EQ(At<double>(bytes, vertex + 24), kInfinity);
  EXPECT_EQ(At<int32_t>(bytes, vertex + 32), -1);
  EXPECT_EQ(At<double>(bytes, vertex + 36 + 16), 0.5);
  EXPECT_EQ(bytes[faces + 13], 3);
  EXPECT_EQ(At<int32_t>(bytes, faces + 14), 2);
  EXPECT_EQ(At<int32_t>(bytes, faces + 22), 3);
}

TEST(FieldWritersTest, Vtk) {
  const std::string bytes =
      Written([](AtomicFile* file) { WriteVtk(Square(), AllColumns(), file); });
  // Where what follows this text begins, which is itself due at `at`.
  const auto after = [&bytes](size_t at, const std::string& text) {
    EXPECT_EQ(bytes.substr(at, text.size()), text);
    return at + text.size();
  };
  const size_t points = after(0,
                              "# vtk DataFile Version 3.0\n"
                              "geodesic distance field\n"
                              "BINARY\n"
                              "DATASET POLYDATA\n"
                              "POINTS 4 double\n");
  EXPECT_EQ(BigEndianDouble(bytes, points + 3 * 24 + 16), 0.1);
  const size_t faces = after(points + 4 * 24, "\nPOLYGONS 2 8\n");
  EXPECT_EQ(bytes.substr(faces, 8), std::string("\0\0\0\3\0\0\0\0", 8));
  const size_t distances = after(faces + 2 * 16,
                                 "\nPOINT_DATA 4\n"
                                 "SCALARS geodesic_distance double 1\n"
                                 "LOOKUP_TABLE default\n");
  EXPECT_EQ(BigEndianDouble(bytes, distances + 16), 1.0 / 3);
  EXPECT_EQ(BigEndianDouble(bytes, distances + 24), kInfinity);
  const size_t sources = after(
      distances + 32, "\nSCALARS nearest_source int 1\nLOOKUP_TABLE default\n");
  EXPECT_EQ(bytes.substr(sources + 12, 4), std::string(4, '\xff'));
  const size_t gradients = after(sources + 16, "\nVECTORS gradient double\n");
  EXPECT_EQ(BigEndianDouble(bytes, gradients + 11 * 8), 0.5);
  EXPECT_EQ(bytes.size(), gradients + 12 * 8 + 1);
}

TEST(FieldWritersTest, FloatsAreHalfAsLong) {
  const std::string raw = Written([](AtomicFile* file) {
    AppendNumbers(DistanceColumn().values, NumberType::kFloat32, file);
  });
  ASSERT_EQ(raw.size(), 16);
  EXPECT_EQ(At<float>(raw, 4), 0.1F);
  EXPECT_EQ(At<float>(raw, 12), static_cast<float>(kInfinity));
  Column column = DistanceColumn();
  column.type = NumberType::kFloat32;
  const std::string npy =
      Written([&](AtomicFile* file) { WriteNpy(column, file); });
  EXPECT_EQ(npy.substr(10, 16), "{'descr': '<f4',");
  EXPECT_EQ(npy.substr(128), raw);
  // The fewest digits that give the same float.
  EXPECT_EQ(
      Written([&](AtomicFile* file) { WriteCsv(std::vector{column}, file); }),
      "vertex,geodesic_distance\n0,0\n1,0.1\n2,0.33333334\n3,inf\n");
}

TEST(FieldWritersTest, CsvOfAllColumns) {
  EXPECT_EQ(Written([](AtomicFile* file) { WriteCsv(AllColumns(), file); }),
            "vertex,geodesic_distance,nearest_source,gradient_x,gradient_y,"
            "gradient_z\n"
            "0,0,0,0,0,0\n"
            "1,0.1,1,1,0,0\n"
            "2,0.3333333333333333,1,0,1,0\n"
            "3,inf,-1,0,0,0.5\n");
}

}  // namespace
}  // namespace geodesic::client
