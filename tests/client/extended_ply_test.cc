// PLY files that get more values at their vertices.

#include "client/output/extended_ply.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <bit>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "tests/client/temporary_folder.h"

namespace geodesic::client {
namespace {

using ::testing::HasSubstr;
using ::testing::Optional;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<Column> Columns() {
  return {{.name = kDistanceColumn, .values = {0, 0.1, kInfinity}},
          {.name = kNearestSourceColumn,
           .values = {0, 1, -1},
           .type = NumberType::kInt32}};
}

// A header with colours before and after the coordinates, and faces with a
// value of their own; `more` lines are the last properties of vertices.
std::string Header(const std::string& format, const std::string& more = "",
                   const std::string& comment = "") {
  return "ply\nformat " + format + " 1.0\n" + comment +
         "comment made by hand\nelement vertex 3\nproperty uchar red\n"
         "property float x\nproperty float y\nproperty float z\n"
         "property short quality\n" +
         more +
         "element face 1\nproperty list uchar uint vertex_indices\n"
         "property uchar group\nend_header\n";
}

const std::string& UnitComment() {
  static const auto& comment =
      *new std::string(std::string(kUnitComment) + "\n");
  return comment;
}

constexpr char kColumnLines[] =
    "property double geodesic_distance\nproperty int nearest_source\n";

// Numbers of a binary file.
template <typename Number>
void Put(Number number, std::endian order, std::string* bytes) {
  std::string text(reinterpret_cast<const char*>(&number), sizeof(number));
  if (order == std::endian::big) text = {text.rbegin(), text.rend()};
  *bytes += text;
}

// Three vertices, with or without the columns, and one face.
std::string Body(std::endian order, bool with_columns) {
  const std::vector<Column> columns = Columns();
  std::string body;
  for (int v = 0; v < 3; ++v) {
    Put(static_cast<uint8_t>(200 + v), order, &body);
    for (const float x : {1.5F * v, -2.25F, 1e-9F}) Put(x, order, &body);
    Put(static_cast<int16_t>(-300 * v), order, &body);
    if (!with_columns) continue;
    Put(columns[0].values[v], order, &body);
    Put(static_cast<int32_t>(columns[1].values[v]), order, &body);
  }
  Put(uint8_t{3}, order, &body);
  for (const uint32_t corner : {0, 1, 2}) Put(corner, order, &body);
  Put(uint8_t{7}, order, &body);
  return body;
}

TEST(ExtendedPlyTest, BinaryFilesKeepTheirOrderOfBytesAndAllTheyHold) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const std::string format = order == std::endian::little
                                   ? "binary_little_endian"
                                   : "binary_big_endian";
    EXPECT_THAT(ExtendedPly(Header(format) + Body(order, false), Columns()),
                Optional(Header(format, kColumnLines, UnitComment()) +
                         Body(order, true)));
  }
}

TEST(ExtendedPlyTest, TextKeepsItsNumbersAsTheyAreWritten) {
  const std::string faces = "3 0 1 2 7\n";
  EXPECT_THAT(
      ExtendedPly(Header("ascii") +
                      "200 0.10 0 0 5\n\n 201  1e0 0 0\t6\n202 0 1 0 7\n" +
                      faces,
                  Columns()),
      Optional(Header("ascii", kColumnLines, UnitComment()) +
               "200 0.10 0 0 5 0 0\n201 1e0 0 0 6 0.1 1\n"
               "202 0 1 0 7 inf -1\n" +
               faces));
}

TEST(ExtendedPlyTest, FloatsStayFloats) {
  const std::vector<Column> columns = {
      {.name = "d", .values = {0.1}, .type = NumberType::kFloat32}};
  const auto header = [](const std::string& format, const std::string& more) {
    return "ply\nformat " + format + " 1.0\n" +
           (more.empty() ? "" : UnitComment()) +
           "element vertex 1\nproperty uchar red\n" + more + "end_header\n";
  };
  constexpr char kLine[] = "property float d\n";
  EXPECT_THAT(ExtendedPly(header("ascii", "") + "7\n", columns),
              Optional(header("ascii", kLine) + "7 0.1\n"));
  // 0.1F is 0x3dcccccd.
  EXPECT_THAT(
      ExtendedPly(header("binary_big_endian", "") + "7", columns),
      Optional(header("binary_big_endian", kLine) + "7\x3d\xcc\xcc\xcd"));
}

TEST(ExtendedPlyTest, LinesOfWindowsStayWhatTheyAre) {
  EXPECT_THAT(
      ExtendedPly("ply\r\nformat ascii 1.0\r\nelement vertex 1\r\n"
                  "property double x\r\nproperty double y\r\n"
                  "property double z\r\nend_header\r\n1 2 3\r\n",
                  std::vector<Column>{{.name = "d", .values = {0.5}}}),
      Optional("ply\r\nformat ascii 1.0\r\n" + std::string(kUnitComment) +
               "\r\nelement vertex 1\r\nproperty double x\r\n"
               "property double y\r\nproperty double z\r\n"
               "property double d\r\nend_header\r\n1 2 3 0.5\r\n"));
}

TEST(ExtendedPlyTest, EarlierResultsOfTheSameNameGiveWayWithWhatTheyWere) {
  const std::string old_file =
      Header("binary_little_endian") + Body(std::endian::little, false);
  std::vector<Column> other = Columns();
  other[0].values = {9, 8, 7};
  const auto once =
      ExtendedPly(old_file, other, "within 1e-06 (relative error)");
  ASSERT_TRUE(once.has_value());
  EXPECT_THAT(*once, HasSubstr("\ncomment within 1e-06"));
  const auto twice =
      ExtendedPly(*once, Columns(), "within 0.1 (relative error)");
  EXPECT_EQ(twice,
            ExtendedPly(old_file, Columns(), "within 0.1 (relative error)"));
  EXPECT_THAT(*twice, HasSubstr("comment made by hand"));
  // Values beside which others are added are still what they were.
  EXPECT_THAT(*ExtendedPly(*once, std::vector<Column>{{.name = "other",
                                                       .values = {1, 2, 3}}}),
              HasSubstr("within 1e-06"));
}

// A camera and a face, then vertices with lists: as text, and as bytes.
TEST(ExtendedPlyTest, VerticesMayComeLateAndHoldLists) {
  const auto header = [](const std::string& format, const std::string& more) {
    return "ply\nformat " + format + " 1.0\n" +
           (more.empty() ? "" : UnitComment()) +
           "element camera 1\nproperty float view\nelement face 1\n"
           "property list uchar int vertex_indices\nelement vertex 3\n"
           "property list ushort short tags\nproperty uchar red\n" +
           more + "end_header\n";
  };
  EXPECT_THAT(
      ExtendedPly(header("ascii", "") + "7.5\n3 0 1 2\n2 5 -6 9\n0 8\n1 4 7\n",
                  Columns()),
      Optional(header("ascii", kColumnLines) +
               "7.5\n3 0 1 2\n2 5 -6 9 0 0\n0 8 0.1 1\n"
               "1 4 7 inf -1\n"));
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const auto body = [order](bool with_columns) {
      const std::vector<Column> columns = Columns();
      std::string bytes;
      Put(7.5F, order, &bytes);
      Put(uint8_t{3}, order, &bytes);
      for (const int32_t corner : {0, 1, 2}) Put(corner, order, &bytes);
      for (uint16_t v = 0; v < 3; ++v) {
        Put(static_cast<uint16_t>(300 * v), order, &bytes);
        for (int i = 0; i < 300 * v; ++i) Put(int16_t{-6}, order, &bytes);
        Put(uint8_t{9}, order, &bytes);
        if (!with_columns) continue;
        Put(columns[0].values[v], order, &bytes);
        Put(static_cast<int32_t>(columns[1].values[v]), order, &bytes);
      }
      return bytes;
    };
    const std::string format = order == std::endian::little
                                   ? "binary_little_endian"
                                   : "binary_big_endian";
    EXPECT_THAT(ExtendedPly(header(format, "") + body(false), Columns()),
                Optional(header(format, kColumnLines) + body(true)));
    EXPECT_EQ(
        ExtendedPly(header(format, "") + body(false).substr(0, 600), Columns()),
        std::nullopt);
  }
}

TEST(ExtendedPlyTest, WhatCannotBeExtendedIsRefused) {
  const std::string header = Header("binary_little_endian");
  const std::string whole = header + Body(std::endian::little, false);
  // 19 bytes of a vertex are missing, or all of them.
  for (const size_t size : {size_t{0}, size_t{2}, header.size() - 12,
                            header.size(), header.size() + 3 * 15 - 1}) {
    EXPECT_EQ(ExtendedPly(whole.substr(0, size), Columns()), std::nullopt);
  }
  const std::vector<Column> too_few = {{.name = "d", .values = {1, 2}}};
  EXPECT_EQ(ExtendedPly(whole, too_few), std::nullopt);
  for (const std::string wrong :
       {"ply\nformat ascii 1.0\nelement vertex 3\nproperty list uchar int n\n"
        "end_header\n0\n0\n1\n",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty list uchar int n\n"
        "end_header\n0\n0\n-1\n",
        "ply\nformat ascii 1.0\nelement face 2\nproperty uchar a\n"
        "element vertex 3\nproperty float x\nend_header\n1\n1\n1\n1\n",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
        "end_header\n1\n1 2\n1\n",
        "ply\nformat ascii 1.0\nelement face 0\nend_header\n",
        "ply\rformat ascii 1.0\relement vertex 0\rend_header\r",
        "ply\nelement vertex 3\nproperty float x\nend_header\n1\n1\n1\n",
        "ply\nformat other 1.0\nelement vertex 3\nproperty float x\n"
        "end_header\n1\n1\n1\n",
        "solid ply\n"}) {
    EXPECT_EQ(ExtendedPly(wrong, Columns()), std::nullopt) << wrong;
  }
}

TEST(ExtendedPlyTest, FilesMayBeCompressed) {
  const TemporaryFolder folder;
  const std::string ply =
      Header("binary_little_endian") + Body(std::endian::little, false);
  const auto expected = ExtendedPly(ply, Columns());
  ASSERT_TRUE(expected.has_value());
  std::ofstream(folder / "a.ply", std::ios::binary) << ply;
  const gzFile packed = gzopen((folder / "a.ply.gz").c_str(), "wb");
  gzwrite(packed, ply.data(), static_cast<unsigned>(ply.size()));
  gzclose(packed);
  EXPECT_EQ(ExtendedPlyFile(folder / "a.ply", Columns()), expected);
  EXPECT_EQ(ExtendedPlyFile(folder / "a.ply.gz", Columns()), expected);
  EXPECT_EQ(ExtendedPlyFile(folder / "none.ply", Columns()), std::nullopt);
}

}  // namespace
}  // namespace geodesic::client
