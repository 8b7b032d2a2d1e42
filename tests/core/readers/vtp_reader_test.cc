#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_replace.h"
#include "geodesic/read_mesh.h"
#include "tests/core/readers/byte_writer.h"
#include "tests/core/readers/soup_checks.h"
#include "tests/core/readers/vtp_writer.h"
#include "tests/support/checkpoints.h"

namespace geodesic {
namespace {

using test::ByteWriter;
using test::ExpectRead;
using test::IsInvalid;
using test::IsInvalidWith;
using test::VtpFormat;
using test::VtpOptions;
using test::VtpPiece;
using test::VtpWriter;
using ::testing::ElementsAre;
using ::testing::SizeIs;

absl::StatusOr<TriangleSoup> Read(const std::string& bytes) {
  return ReadMesh(bytes, MeshFormat::kVtp);
}

// A square and a triangle, a vertex of no face between them, and a piece
// without faces.
std::vector<VtpPiece> Pieces() {
  return {{{{0.1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1e-300}},
           {{0, 1, 2, 3}, {2, 1, 0}}},
          {{{7, 7, 7}}, {}},
          {{{2, 0, 0}, {3, 0, 0}, {2, 1, -1e300}}, {{0, 1, 2}}}};
}

class VtpOptionsTest : public testing::TestWithParam<VtpOptions> {};

INSTANTIATE_TEST_SUITE_P(All, VtpOptionsTest,
                         testing::ValuesIn(test::AllVtpOptions()),
                         [](const auto& options) {
                           return test::NameOf(options.param);
                         });

TEST_P(VtpOptionsTest, AllPiecesAreRead) {
  const TriangleSoup soup =
      ExpectRead(Read(VtpWriter(GetParam()).Write(Pieces())));
  EXPECT_THAT(soup.positions,
              ElementsAre(Point{0.1, 0, 0}, Point{1, 0, 0}, Point{1, 1, 0},
                          Point{0, 1, 1e-300}, Point{7, 7, 7}, Point{2, 0, 0},
                          Point{3, 0, 0}, Point{2, 1, -1e300}));
  EXPECT_THAT(soup.triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3},
                          Triangle{2, 1, 0}, Triangle{5, 6, 7}));
}

// More than one buffer of each, and blocks that end within a number.
TEST_P(VtpOptionsTest, LargeArraysAreRead) {
  VtpPiece piece;
  for (int i = 0; i < 6000; ++i) {
    piece.points.push_back({0.5 * i, i % 7 - 3.0, 1.0 * (i * 37 % 1000)});
    if (i >= 2) piece.polygons.push_back({i, i - 1, i - 2});
  }
  VtpOptions options = GetParam();
  options.block_bytes = 1001;
  const TriangleSoup soup = ExpectRead(Read(VtpWriter(options).Write({piece})));
  EXPECT_EQ(soup.positions, piece.points);
  ASSERT_THAT(soup.triangles, SizeIs(5998));
  EXPECT_EQ(soup.triangles[4000], (Triangle{4002, 4001, 4000}));
}

// A file of one piece: three points as text, and a triangle.
std::string Plain(const std::vector<std::pair<absl::string_view, std::string>>&
                      changes = {}) {
  const std::string bytes =
      VtpWriter({}).Write({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}});
  std::string changed = bytes;
  for (const auto& [part, replacement] : changes) {
    EXPECT_GE(absl::StrReplaceAll({{part, replacement}}, &changed), 1) << part;
  }
  return changed;
}

TEST(VtpReaderTest, MarkupMayBeWrittenOtherwise) {
  const TriangleSoup soup = ExpectRead(Read(Plain(
      {{"<?xml version=\"1.0\"?>",
        "\xef\xbb\xbf<?xml version='1.0' encoding='UTF-8'?><!-- a > b < c -->"},
       {"<Points>",
        "<PointData><DataArray type='Float32' Name='d' "
        "format='ascii'>1 2 3</DataArray></PointData><Points >"},
       {"\"Int64\" Name=\"connectivity\"", "'UInt8'\n Name = 'connectivity'"},
       {" NumberOfStrips=\"0\"", ""}})));
  EXPECT_THAT(soup.positions, SizeIs(3));
  EXPECT_THAT(soup.triangles, ElementsAre(Triangle{0, 1, 2}));
}

// Some files have the header's base64 apart from that of the numbers.
TEST(VtpReaderTest, PaddingMayStandBehindTheHeader) {
  ByteWriter header;
  header.Put<uint32_t>(72);
  ByteWriter numbers;
  numbers.Put<double>(0, 0, 0, 1, 0, 0, 0, 1, 0.25);
  std::string bytes =
      VtpWriter({.format = VtpFormat::kBinary})
          .Write({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}});
  const std::string old_text =
      VtpWriter({.format = VtpFormat::kBinary})
          .Encoded<double>({0, 0, 0, 1, 0, 0, 0, 1, 0});
  ASSERT_EQ(
      absl::StrReplaceAll({{old_text, absl::Base64Escape(header.bytes()) +
                                          absl::Base64Escape(numbers.bytes())}},
                          &bytes),
      1);
  EXPECT_EQ(ExpectRead(Read(bytes)).positions.back(), (Point{0, 1, 0.25}));
}

TEST(VtpReaderTest, WhatIsNoSurfaceIsNamedWithTheWayOut) {
  const std::string type = "type=\"PolyData\"";
  EXPECT_THAT(Read(Plain({{type, "type=\"UnstructuredGrid\""}})),
              IsInvalid("the file holds a UnstructuredGrid, which is no "
                        "surface: extract its surface first (Extract Surface "
                        "in ParaView, extract_surface() in PyVista) and save "
                        "that as .vtp"));
  EXPECT_THAT(Read(Plain({{type, "type=\"PPolyData\""}})),
              IsInvalidWith("names other files: save the surface as one .vtp"));
  for (const char* name : {"vtkLZ4DataCompressor", "vtkLZMADataCompressor"}) {
    EXPECT_THAT(
        Read(Plain({{type, absl::StrCat(type, " compressor=\"", name, "\"")}})),
        IsInvalid(absl::StrCat("the arrays are compressed by ", name,
                               ", which is not read: save the file with zlib "
                               "or without compression")));
  }
  EXPECT_THAT(Read(Plain({{"NumberOfStrips=\"0\"", "NumberOfStrips=\"1\""}})),
              IsInvalid("piece 0: triangle strips are not supported: save "
                        "plain triangles"));
  EXPECT_THAT(Read(Plain({{"NumberOfLines=\"0\"", "NumberOfLines=\"1\""},
                          {"NumberOfPolys=\"1\"", "NumberOfPolys=\"0\""}})),
              IsInvalid("the file holds lines and no polygons: save a "
                        "surface"));
}

TEST(VtpReaderTest, MalformedFilesAreNamed) {
  const std::string points = "NumberOfPoints=\"3\"";
  const std::string polygons = "NumberOfPolys=\"1\"";
  for (const auto& [part, replacement, message] :
       std::vector<std::array<std::string, 3>>{
           {"</PolyData>", "", "the XML is damaged or cut off"},
           {"PolyData>", "Poly>", "no element PolyData"},
           {"Piece", "Peace", "no element Piece"},
           {"LittleEndian", "MiddleEndian", "'MiddleEndian' is neither"},
           {"UInt32", "UInt16", "header_type 'UInt16'"},
           {points, "NumberOfPoints=\"x\"", "NumberOfPoints 'x' is no count"},
           {points, "NumberOfPoints=\"-1\"", "'-1' is no count"},
           {points, "NumberOfPoints=\"4\"",
            "4 points do not fit the array Points"},
           {points, "NumberOfPoints=\"9000000000000000000\"",
            "9000000000000000000 points do not fit"},
           {points, "NumberOfPoints=\"2\"",
            "cell 0 names vertex 2, but there are 2"},
           {polygons, "NumberOfPolys=\"2\"", "cell 1: its end in offsets"},
           {polygons, "NumberOfPolys=\"9000000000000000000\"",
            "9000000000000000000 polygons do not fit"},
           {"Points>", "Pints>", "the array Points is missing"},
           {"Name=\"offsets\"", "Name=\"ends\"", "array offsets is missing"},
           {"connectivity", "corners", "array connectivity is missing"},
           {"Components=\"3\"", "Components=\"2\"", "have '2' components"},
           {"Float64", "Real", "Points: 'Real' is no known type"},
           {"Int64", "Float32", "'Float32' is no type of whole numbers"},
           {"ascii", "hex", "format 'hex' is neither"},
           {"ascii", "appended", "there is no AppendedData"},
           {"1 0 0 0 1 0", "1 nan 0 0 1 0", "point 1: a coordinate"},
           {"0 1 2 ", "0 1 -2 ", "names vertex -2"},
           {"0 1 2 ", "0 1 ", "cell 0: corner 2 is no number"},
           {"\n3 \n", "\n2 \n", "cell 0 has 2 corners"},
           {"\n3 \n", "\n4000000000 \n", "its end in offsets is out of range"},
       }) {
    EXPECT_THAT(Read(Plain({{part, replacement}})), IsInvalidWith(message))
        << part << " -> " << replacement;
  }
  EXPECT_THAT(Read("<VTKFile"), IsInvalidWith("byte 7: the XML is damaged"));
  EXPECT_THAT(Read("<a><VTKFile/></a>"), IsInvalidWith("is not VTKFile"));
}

TEST(VtpReaderTest, WrongOffsetsAreNamed) {
  const std::string bytes =
      VtpWriter({.format = VtpFormat::kAppendedRaw})
          .Write({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}});
  for (const char* offset : {"-1", "x", "", "1000000", "9999999999999999999"}) {
    EXPECT_THAT(Read(absl::StrReplaceAll(
                    bytes, {{"offset=\"0\"",
                             absl::StrCat("offset=\"", offset, "\"")}})),
                IsInvalidWith("is not within the 113 bytes of AppendedData"))
        << offset;
  }
  // What lies there is no array.
  EXPECT_THAT(
      Read(absl::StrReplaceAll(bytes, {{"offset=\"0\"", "offset=\"3\""}})),
      IsInvalidWith("piece 0: "));
  EXPECT_THAT(Read(absl::StrReplaceAll(bytes, {{"\"raw\"", "\"hex\""}})),
              IsInvalidWith("'hex' is neither raw nor base64"));
  EXPECT_THAT(Read(absl::StrReplaceAll(bytes, {{"\n_", "\n"}})),
              IsInvalidWith("does not begin with '_'"));
}

// A file whose points, as base64, are `text`.
std::string WithPoints(const std::string& text, bool is_compressed,
                       uint64_t count = 3) {
  return absl::StrCat(
      "<VTKFile type='PolyData'",
      is_compressed ? " compressor='vtkZLibDataCompressor'" : "",
      "><PolyData><Piece NumberOfPoints='", count,
      "'><Points><DataArray type='Float64' NumberOfComponents='3' "
      "format='binary'>",
      text, "</DataArray></Points></Piece></PolyData></VTKFile>");
}

template <typename... Numbers>
std::string Header(Numbers... numbers) {
  ByteWriter header;
  header.Put<uint32_t>(numbers...);
  return absl::Base64Escape(header.bytes());
}

TEST(VtpReaderTest, SizesThatLieAreNamed) {
  const VtpWriter plain({.format = VtpFormat::kBinary});
  const std::string numbers = absl::Base64Escape(std::string(72, '\0'));
  EXPECT_THAT(
      ExpectRead(Read(WithPoints(Header(72) + numbers, false))).positions,
      SizeIs(3));
  EXPECT_THAT(Read(WithPoints(Header(73) + numbers, false)),
              IsInvalid("piece 0: Points: its header promises 73 bytes, but 72 "
                        "follow"));
  EXPECT_THAT(Read(WithPoints(Header(71) + numbers, false)),
              IsInvalid("piece 0: 3 points do not fit the array Points"));
  EXPECT_THAT(Read(WithPoints("AAA", false)),
              IsInvalid("piece 0: Points: its header is cut off"));
  EXPECT_THAT(Read(WithPoints("", false)), IsInvalidWith("is cut off"));
  EXPECT_THAT(Read(WithPoints(Header(72) + "!" + numbers, false)),
              IsInvalidWith("point 0: a coordinate is missing, damaged"));

  // 72 zeros, as zlib has them.
  const std::string whole = VtpWriter({.format = VtpFormat::kBinary,
                                       .is_compressed = true,
                                       .block_bytes = 72})
                                .Encoded(std::vector<double>(9));
  std::string header;
  ASSERT_TRUE(absl::Base64Unescape(whole.substr(0, 24), &header));
  const auto size = static_cast<uint8_t>(header[12]);
  const std::string block = whole.substr(24);
  const auto read = [&](auto... words) {
    return Read(WithPoints(Header(words...) + block, true));
  };
  EXPECT_TRUE(read(1, 72, 0, size).ok());
  // VTK's blocks are of 32 KiB, however few bytes there are.
  EXPECT_TRUE(read(1, 32768, 72, size).ok());
  const auto damaged = IsInvalidWith("point 0: a coordinate is missing");
  EXPECT_THAT(read(1, 80, 0, size), damaged);
  EXPECT_THAT(read(1, 72, 0, size - 1), damaged);
  EXPECT_THAT(read(1, 72, 0, size + 1), damaged);
  EXPECT_THAT(read(1, 72, 0, 4000000000), damaged);
  EXPECT_THAT(read(1, 72, 0, 0), damaged);
  EXPECT_THAT(read(2, 36, 0, size, 0), damaged);
  EXPECT_THAT(read(1, 71, 0, size), IsInvalidWith("3 points do not fit"));
  EXPECT_THAT(read(1, 72, 73, size), IsInvalidWith("which cannot be"));
  EXPECT_THAT(read(1, 0, 0, size), IsInvalidWith("which cannot be"));
  EXPECT_THAT(read(1, 4000000000, 0, size), IsInvalidWith("which cannot be"));
  EXPECT_THAT(read(0, 72, 0), IsInvalidWith("3 points do not fit"));
  EXPECT_THAT(read(4000000000, 72, 0, size),
              IsInvalidWith("4000000000 compressed blocks"));
}

TEST(VtpReaderTest, ABombStopsAtTheLimit) {
  const std::string text = VtpWriter({.format = VtpFormat::kBinary,
                                      .is_compressed = true,
                                      .block_bytes = 1 << 22})
                               .Encoded(std::vector<double>(3'000'000));
  ASSERT_LT(text.size(), 50'000u);
  const std::string bytes = WithPoints(text, true, 1'000'000);
  EXPECT_TRUE(absl::IsResourceExhausted(
      ReadMesh(bytes, MeshFormat::kVtp, {.max_vertices = 999'999}).status()));
  EXPECT_THAT(ExpectRead(Read(bytes)).positions, SizeIs(1'000'000));
}

TEST(VtpReaderTest, PiecesMayNotShareTheirArrays) {
  const std::string one =
      VtpWriter({.format = VtpFormat::kAppendedRaw})
          .Write({{std::vector<Point>(1000, Point{1, 2, 3}), {{0, 1, 2}}}});
  const size_t begin = one.find("<Piece");
  const size_t end = one.find("</PolyData>");
  const std::string piece = one.substr(begin, end - begin);
  EXPECT_THAT(
      Read(one.substr(0, begin) + piece + piece + piece + one.substr(end)),
      IsInvalidWith("its arrays are also those of other pieces"));
}

TEST(VtpReaderTest, MarkupIsLimited) {
  const std::string limit = "more than 1048576 bytes of XML";
  std::string many = "<a/>";
  while (many.size() < (2 << 20)) many += many;
  EXPECT_THAT(Read(Plain({{"<PolyData>", "<PolyData>" + many}})),
              IsInvalidWith(limit));
  const std::string comment(2 << 20, '!');
  EXPECT_THAT(Read(Plain({{"<PolyData>", "<!--" + comment + "--><PolyData>"}})),
              IsInvalidWith(limit));
  EXPECT_THAT(Read(Plain({{"<PolyData>", comment + "<PolyData>"}})),
              IsInvalidWith(limit));
  // However deep, nothing recurs.
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<a>";
  EXPECT_THAT(Read(Plain({{"<PolyData>", deep + "<PolyData>"}})),
              IsInvalidWith("the XML is damaged or cut off"));
}

TEST(VtpReaderTest, ACheckpointStopsIt) {
  // Polled for the markup, for vertices and for triangles.
  for (const uint64_t stop_at : {0, 1, 2, 3}) {
    test::RecordingCheckpoint checkpoint(stop_at);
    EXPECT_EQ(ReadMesh(Plain(), MeshFormat::kVtp, {.checkpoint = &checkpoint})
                  .status(),
              test::RecordingCheckpoint::Stopped());
    EXPECT_THAT(checkpoint.polls(), SizeIs(stop_at + 1));
  }
}

}  // namespace
}  // namespace geodesic
