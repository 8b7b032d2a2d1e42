// Answers in the formats other programs read.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "absl/strings/escaping.h"
#include "client/output/atomic_file.h"
#include "client/output/field_writers.h"
#include "client/output/line_writers.h"
#include "client/output/matrix_writers.h"
#include "client/output/pair_writers.h"
#include "client/output/viewer_page.h"
#include "tests/client/temporary_folder.h"

namespace geodesic::client {
namespace {

using ::testing::ElementsAre;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <typename Write>
std::string Written(const Write& write) {
  const TemporaryFolder folder;
  absl::StatusOr<AtomicFile> file = AtomicFile::Create(folder / "out");
  EXPECT_TRUE(file.ok());
  write(&*file);
  EXPECT_TRUE(file->Commit().ok());
  return FileBytes(folder / "out");
}

const std::vector<double>& Distances() {
  static const auto& distances =
      *new std::vector<double>{0, 0.1, 1.0 / 3, kInfinity};
  return distances;
}

Column DistanceColumn(const std::vector<double>& distances = Distances()) {
  return {.name = kDistanceColumn, .values = distances};
}

// Nearest sources and gradients too: doubles, integers and floats.
std::vector<Column> AllColumns() {
  return {DistanceColumn(),
          {.name = kNearestSourceColumn,
           .values = {0, 1, 1, -1},
           .type = NumberType::kInt32},
          {.name = kGradientColumn,
           .values = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0.1},
           .components = 3,
           .type = NumberType::kFloat32}};
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
      "property float gradient_x\n"
      "property float gradient_y\n"
      "property float gradient_z\n"
      "element face 2\n"
      "property list uchar int vertex_indices\n"
      "end_header\n";
  ASSERT_EQ(bytes.substr(0, header.size()), header);
  constexpr size_t kRow = 4 * 8 + 4 + 3 * 4;
  const size_t vertex = header.size() + 3 * kRow;  // the last one
  const size_t faces = vertex + kRow;
  ASSERT_EQ(bytes.size(), faces + 2 * 13);
  EXPECT_EQ(At<double>(bytes, vertex + 16), 0.1);
  EXPECT_EQ(At<double>(bytes, vertex + 24), kInfinity);
  EXPECT_EQ(At<int32_t>(bytes, vertex + 32), -1);
  EXPECT_EQ(At<float>(bytes, vertex + 36 + 8), 0.1F);
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
  const size_t gradients = after(sources + 16, "\nVECTORS gradient float\n");
  // 0.1F is 0x3dcccccd.
  EXPECT_EQ(bytes.substr(gradients + 11 * 4, 4), "\x3d\xcc\xcc\xcd");
  EXPECT_EQ(bytes.size(), gradients + 12 * 4 + 1);
}

// The JSON object that the page holds.
nlohmann::json AnswerIn(const std::string& page) {
  constexpr std::string_view kBegin =
      "<script id=\"answer\" type=\"application/json\">";
  const size_t begin = page.find(kBegin) + kBegin.size();
  return nlohmann::json::parse(
      page.substr(begin, page.find("</script>", begin) - begin));
}

TEST(ViewerPageTest, HoldsTheMeshAndItsField) {
  const std::vector<Point> sources = {{0.25, 0.25, 0}};
  const std::string page = Written([&](AtomicFile* file) {
    WriteViewerPage(Square(),
                    {.name = "a</script>\xff",
                     .mesh_digest = "d1",
                     .distances = Distances(),
                     .sources = sources},
                    file);
  });
  const nlohmann::json answer = AnswerIn(page);
  EXPECT_EQ(answer["name"], "a</script>\uFFFD");
  EXPECT_EQ(answer["digest"], "d1");
  std::string bytes;
  ASSERT_TRUE(
      absl::Base64Unescape(answer["distances"].get<std::string>(), &bytes));
  ASSERT_EQ(bytes.size(), Distances().size() * sizeof(double));
  for (size_t v = 0; v < Distances().size(); ++v) {
    EXPECT_EQ(At<double>(bytes, v * sizeof(double)), Distances()[v]);
  }
  ASSERT_TRUE(
      absl::Base64Unescape(answer["positions"].get<std::string>(), &bytes));
  ASSERT_EQ(bytes.size(), 4 * 3 * sizeof(float));
  for (size_t v = 0; v < 4; ++v) {
    for (size_t axis = 0; axis < 3; ++axis) {
      const float offset = At<float>(bytes, (3 * v + axis) * sizeof(float));
      // An offset is at most half a unit long here.
      constexpr double kFloatRounding = 0x1p-25;
      EXPECT_NEAR(answer["center"][axis].get<double>() + offset,
                  Square().positions[v][axis], kFloatRounding);
    }
  }
  ASSERT_TRUE(absl::Base64Unescape(answer["faces"].get<std::string>(), &bytes));
  ASSERT_EQ(bytes.size(), 2 * 3 * sizeof(uint32_t));
  EXPECT_EQ(At<uint32_t>(bytes, 5 * sizeof(uint32_t)), 3);
  ASSERT_TRUE(
      absl::Base64Unescape(answer["sources"].get<std::string>(), &bytes));
  EXPECT_EQ(At<double>(bytes, 0), 0.25);
  // The program of the page is there, whole, after the answer.
  EXPECT_TRUE(page.ends_with("</html>\n"));
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
            "3,inf,-1,0,0,0.1\n");
}

using nlohmann::json;

// A path of three points, one that was not found, and a triangle that closes.
Lines Sample() {
  Lines lines = {.attributes = {{"source", NumberType::kInt32},
                                {"length", NumberType::kFloat32},
                                {"level"}}};
  lines.lines.push_back(
      {.polyline = {.points = {VertexPoint{4}, EdgePoint{1, 2, 0.5},
                               FacePoint{3, {0.25, 0.25, 0.5}}},
                    .positions = {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}}},
       .values = {7, 0.1, 3}});
  lines.lines.push_back({.values = {-1, kInfinity, kInfinity}});
  lines.lines.push_back(
      {.polyline = {.points = {VertexPoint{0}, VertexPoint{1}, VertexPoint{2}},
                    .positions = {{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}},
       .is_closed = true,
       .values = {2, 0.5, 1}});
  return lines;
}

std::string WrittenAs(OutputFormat format, const Lines& lines = Sample()) {
  return Written([&](AtomicFile* file) { WriteLines(lines, format, file); });
}

// Two points in each l statement: some programs keep no more of it.
TEST(LineWritersTest, Obj) {
  EXPECT_EQ(WrittenAs(OutputFormat::kObj),
            "# source 7 length 0.1 level 3\n"
            "g line_0\n"
            "v 0 0 0\nv 1 0 0\nv 1 2 0\n"
            "l 1 2\nl 2 3\n"
            "# source 2 length 0.5 level 1\n"
            "g line_2\n"
            "v 0 0 1\nv 1 0 1\nv 0 1 1\n"
            "l 4 5\nl 5 6\nl 6 4\n");
}

TEST(LineWritersTest, Csv) {
  EXPECT_EQ(WrittenAs(OutputFormat::kCsv),
            "line,point,x,y,z,place,source,length,level\n"
            "0,0,0,0,0,4,7,0.1,3\n"
            "0,1,1,0,0,edge:1-2@0.5,7,0.1,3\n"
            "0,2,1,2,0,\"face:3@0.25,0.25,0.5\",7,0.1,3\n"
            "2,0,0,0,1,0,2,0.5,1\n"
            "2,1,1,0,1,1,2,0.5,1\n"
            "2,2,0,1,1,2,2,0.5,1\n"
            "2,3,0,0,1,0,2,0.5,1\n");
}

TEST(LineWritersTest, Json) {
  const json collection = json::parse(WrittenAs(OutputFormat::kJson));
  EXPECT_EQ(collection["type"], "FeatureCollection");
  const json& features = collection["features"];
  ASSERT_EQ(features.size(), 3);
  EXPECT_EQ(features[0]["geometry"],
            json::parse(R"({"type": "LineString", "coordinates":
                            [[0.0,0.0,0.0],[1.0,0.0,0.0],[1.0,2.0,0.0]]})"));
  EXPECT_EQ(features[0]["properties"]["source"], 7);
  EXPECT_EQ(features[0]["properties"]["points"][1]["edge"], json({1, 2}));
  EXPECT_TRUE(features[1]["geometry"].is_null());
  EXPECT_TRUE(features[1]["properties"]["source"].is_null());
  EXPECT_TRUE(features[1]["properties"]["length"].is_null());
  // A ring repeats its first position.
  EXPECT_EQ(features[2]["geometry"]["coordinates"].size(), 4);
  EXPECT_EQ(features[2]["properties"]["closed"], true);
  EXPECT_EQ(features[2]["properties"]["points"].size(), 3);
}

TEST(LineWritersTest, PlyHasEdges) {
  const std::string bytes = WrittenAs(OutputFormat::kPly);
  const std::string header =
      "ply\nformat binary_little_endian 1.0\n"
      "element vertex 6\n"
      "property double x\nproperty double y\nproperty double z\n"
      "element edge 5\n"
      "property int vertex1\nproperty int vertex2\nproperty int line\n"
      "property int source\nproperty float length\nproperty double level\n"
      "end_header\n";
  ASSERT_EQ(bytes.substr(0, header.size()), header);
  const size_t edges = header.size() + 6 * 24;
  constexpr size_t kRow = 4 * 4 + 4 + 8;
  ASSERT_EQ(bytes.size(), edges + 5 * kRow);
  const auto edge = [&](size_t number) {
    std::array<int32_t, 4> row;
    std::memcpy(row.data(), bytes.data() + edges + number * kRow, sizeof(row));
    return row;
  };
  EXPECT_EQ(edge(0), (std::array<int32_t, 4>{0, 1, 0, 7}));
  EXPECT_EQ(edge(1), (std::array<int32_t, 4>{1, 2, 0, 7}));
  EXPECT_EQ(edge(2), (std::array<int32_t, 4>{3, 4, 2, 2}));
  EXPECT_EQ(edge(4), (std::array<int32_t, 4>{5, 3, 2, 2}));
  EXPECT_EQ(At<float>(bytes, edges + 16), 0.1F);
  EXPECT_EQ(At<double>(bytes, edges + 20), 3);
}

TEST(LineWritersTest, VtkHasLinesAndCellData) {
  const std::string bytes = WrittenAs(OutputFormat::kVtk);
  const std::string lines = "\nLINES 2 9\n";
  const size_t at = bytes.find(lines);
  ASSERT_NE(at, std::string::npos);
  // 3 points, then 4 with the first again; big endian.
  const std::string body = bytes.substr(at + lines.size(), 36);
  const char expected[] = {3, 0, 1, 2, 4, 3, 4, 5, 3};
  for (size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(body.substr(4 * i, 4), std::string(3, '\0') + expected[i]) << i;
  }
  EXPECT_NE(bytes.find("\nCELL_DATA 2\nSCALARS source double 1\n"),
            std::string::npos);
  const std::string lengths =
      "\nSCALARS length float 1\nLOOKUP_TABLE default\n";
  EXPECT_EQ(bytes.substr(bytes.find(lengths) + lengths.size(), 4),
            "\x3d\xcc\xcc\xcd");
  EXPECT_NE(bytes.find("\nSCALARS level double 1\n"), std::string::npos);
}

TEST(LineWritersTest, NoLinesAreFine) {
  EXPECT_EQ(WrittenAs(OutputFormat::kObj, {}), "");
  EXPECT_EQ(json::parse(WrittenAs(OutputFormat::kJson, {}))["features"],
            json::array());
}

template <typename Number>
std::vector<Number> Numbers(const std::string& bytes) {
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return numbers;
}

// The members of an archive without compression, read by what the zip format
// says of local headers.
std::map<std::string, std::string> Members(const std::string& zip) {
  std::map<std::string, std::string> members;
  size_t at = 0;
  while (zip.compare(at, 4, "PK\3\4") == 0) {
    const auto sizes = Numbers<uint32_t>(zip.substr(at + 18, 8));
    const auto lengths = Numbers<uint16_t>(zip.substr(at + 26, 4));
    EXPECT_EQ(sizes[0], sizes[1]);  // stored
    const size_t body = at + 30 + lengths[0] + lengths[1];
    members[zip.substr(at + 30, lengths[0])] = zip.substr(body, sizes[0]);
    at = body + sizes[0];
  }
  EXPECT_EQ(zip.compare(at, 4, "PK\1\2"), 0);
  return members;
}

// What follows the header of an .npy file.
std::string Body(const std::string& npy) {
  return npy.substr(10 + Numbers<uint16_t>(npy.substr(8, 2))[0]);
}

class MatrixWritersTest : public ::testing::Test {
 protected:
  void Open(OutputFormat format, NumberType type = NumberType::kFloat64) {
    absl::StatusOr<std::unique_ptr<MatrixWriter>> writer =
        CreateMatrixWriter(path_, format, type, places_);
    ASSERT_TRUE(writer.ok()) << writer.status();
    writer_ = *std::move(writer);
    ASSERT_TRUE(writer_->Begin({2, 3}).ok());
  }

  void Append(uint64_t row, const std::vector<double>& values,
              const std::vector<uint32_t>& columns = {}) {
    ASSERT_TRUE(writer_->Append({row, columns, values}).ok());
  }

  std::string Committed() {
    EXPECT_EQ(folder_.count(), visible_before_);
    absl::StatusOr<uint64_t> size = writer_->Commit();
    EXPECT_TRUE(size.ok()) << size.status();
    const std::string bytes = FileBytes(path_);
    EXPECT_EQ(*size, bytes.size());
    EXPECT_EQ(folder_.count(), 1);
    return bytes;
  }

  TemporaryFolder folder_;
  std::string path_ = folder_ / "m";
  MatrixPlaces places_ = {.sources = {{VertexPoint{7}}, {VertexPoint{0}, 0.5}}};
  std::unique_ptr<MatrixWriter> writer_;
  // An AtomicFile shows beside its place while it grows.
  size_t visible_before_ = 1;
};

TEST_F(MatrixWritersTest, NpyIsDense) {
  Open(OutputFormat::kNpy, NumberType::kFloat32);
  Append(0, {0, 0.5, 2});
  Append(1, {1, 0, kInfinity});
  const std::string bytes = Committed();
  EXPECT_NE(bytes.find("'<f4'"), std::string::npos);
  EXPECT_NE(bytes.find("'shape': (2, 3), }"), std::string::npos);
  EXPECT_THAT(Numbers<float>(Body(bytes)),
              ElementsAre(0, 0.5, 2, 1, 0, kInfinity));
}

TEST_F(MatrixWritersTest, NpzIsWhatScipyLoads) {
  visible_before_ = 0;
  Open(OutputFormat::kNpz, NumberType::kFloat32);
  Append(0, {0, 2.5}, {0, 2});
  Append(1, {1}, {1});
  std::map<std::string, std::string> members = Members(Committed());
  EXPECT_NE(members["data.npy"].find("'<f4'"), std::string::npos);
  EXPECT_THAT(Numbers<float>(Body(members["data.npy"])),
              ElementsAre(0, 2.5, 1));
  EXPECT_NE(members["data.npy"].find("'shape': (3,)"), std::string::npos);
  EXPECT_THAT(Numbers<int32_t>(Body(members["indices.npy"])),
              ElementsAre(0, 2, 1));
  EXPECT_THAT(Numbers<int32_t>(Body(members["indptr.npy"])),
              ElementsAre(0, 2, 3));
  EXPECT_THAT(Numbers<int64_t>(Body(members["shape.npy"])), ElementsAre(2, 3));
  EXPECT_EQ(Body(members["format.npy"]), "csr");
  EXPECT_NE(members["format.npy"].find("'|S3'"), std::string::npos);
  EXPECT_NE(members["format.npy"].find("'shape': ()"), std::string::npos);
  EXPECT_EQ(members.size(), 5);
}

TEST_F(MatrixWritersTest, NpzKeepsTheFiniteValuesOfDenseRows) {
  visible_before_ = 0;
  Open(OutputFormat::kNpz);
  Append(0, {kInfinity, 0, 1});
  Append(1, {kInfinity, kInfinity, kInfinity});
  std::map<std::string, std::string> members = Members(Committed());
  EXPECT_NE(members["data.npy"].find("'<f8'"), std::string::npos);
  EXPECT_THAT(Numbers<double>(Body(members["data.npy"])), ElementsAre(0, 1));
  EXPECT_THAT(Numbers<int32_t>(Body(members["indices.npy"])),
              ElementsAre(1, 2));
  EXPECT_THAT(Numbers<int32_t>(Body(members["indptr.npy"])),
              ElementsAre(0, 2, 2));
}

TEST_F(MatrixWritersTest, NpzIsTheSameEveryTime) {
  visible_before_ = 0;
  std::string first;
  for (int i = 0; i < 2; ++i) {
    Open(OutputFormat::kNpz);
    Append(0, {1, 2, 3});
    Append(1, {4, 5, 6});
    ASSERT_TRUE(writer_->Commit().ok());
    if (i == 0) first = FileBytes(path_);
  }
  EXPECT_EQ(FileBytes(path_), first);
}

TEST_F(MatrixWritersTest, CsvHasALineForEachValue) {
  Open(OutputFormat::kCsv);
  Append(0, {0, 2.5}, {0, 2});
  Append(1, {1, 0, kInfinity});
  EXPECT_EQ(Committed(),
            "source,target,distance\n7,0,0\n7,2,2.5\n0:0.5,0,1\n0:0.5,1,0\n"
            "0:0.5,2,inf\n");
}

TEST_F(MatrixWritersTest, NothingIsLeftWithoutCommit) {
  for (const OutputFormat format : kMatrixFormats) {
    Open(format);
    Append(0, {1, 2, 3});
    writer_.reset();
    EXPECT_EQ(folder_.count(), 0);
  }
}

TEST(CsvTest, FloatsHaveTheirFewestDigits) {
  // As they come from the server: rounded to floats.
  const std::vector<double> values = {0.1F};
  EXPECT_EQ(CsvRow({.sources = {{VertexPoint{1}}}}, {.values = values},
                   NumberType::kFloat32),
            "1,0,0.1\n");
  const std::vector<PointPair> pairs = {{VertexPoint{1}, VertexPoint{2}}};
  EXPECT_EQ(CsvPairs(pairs, values, NumberType::kFloat32), "1,2,0.1\n");
}

TEST(CreateMatrixWriterTest, NamesThePathItCannotWrite) {
  for (const OutputFormat format : kMatrixFormats) {
    const absl::Status status =
        CreateMatrixWriter("/nowhere/m", format, NumberType::kFloat64, {})
            .status();
    EXPECT_FALSE(status.ok());
    EXPECT_NE(status.message().find("/nowhere/m"), absl::string_view::npos);
  }
}

}  // namespace
}  // namespace geodesic::client
