#include "server/engine/meshes/mesh_upload.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "geodesic_types/field_path.h"
#include "tests/core/readers/vtp_writer.h"
#include "tests/engine/uploads.h"
#include "tests/support/gzip_file.h"
#include "tests/support/meshes/curved_meshes.h"

namespace geodesic::server {
namespace {

using geodesic::test::Gzip;
using ::testing::AllOf;
using ::testing::HasSubstr;

class MeshUploadTest : public ::testing::Test {
 protected:
  absl::StatusOr<std::unique_ptr<MeshUpload>> Start(
      const UploadHeader& header) {
    return MeshUpload::Start(header, limits_, memory_);
  }

  std::unique_ptr<MeshUpload> Received(const std::string& off_file) {
    auto upload =
        *Start({.format = MeshFormat::kOff, .size_bytes = off_file.size()});
    EXPECT_TRUE(upload->Append(0, off_file).ok());
    EXPECT_TRUE(upload->Finish().ok());
    return upload;
  }

  // Parses with as much memory as it takes, in the end `*taken`.
  absl::StatusOr<TriangleSoup> TryToParse(MeshUpload& upload,
                                          uint64_t* taken = nullptr) {
    for (;;) {
      absl::Status status = upload.ReserveForParse();
      if (!status.ok()) return status;
      if (taken != nullptr) *taken = memory_->used();
      auto parsed = upload.Parse(checkpoint_);
      if (!parsed.ok()) return parsed.status();
      if (*parsed) return std::move(upload.soup());
    }
  }

  // What is wrong with the header, and where.
  void ExpectRefused(const UploadHeader& header, absl::StatusCode code,
                     const std::string& field, const std::string& message) {
    const absl::Status status = Start(header).status();
    EXPECT_EQ(status.code(), code) << status;
    EXPECT_EQ(FieldPathOf(status).value_or(""), field);
    EXPECT_THAT(std::string(status.message()), HasSubstr(message));
  }

  NoCheckpoint checkpoint_;
  Limits limits_ = {
      .max_upload_bytes = 1 << 20, .max_vertices = 1000, .max_faces = 2000};
  std::shared_ptr<ByteBudget> memory_ =
      std::make_shared<ByteBudget>("upload memory", 16 << 20);
};

TEST_F(MeshUploadTest, ArraysArriveUnchanged) {
  const TriangleSoup soup = geodesic::test::Icosphere(2);
  const std::string bytes = test::ArrayBytes(soup);
  auto upload = *Start(test::ArrayHeader(soup));
  // Chunks that respect no element's bounds.
  for (size_t at = 0; at < bytes.size(); at += 777) {
    ASSERT_TRUE(upload->Append(at, bytes.substr(at, 777)).ok());
  }
  ASSERT_TRUE(upload->Finish().ok());
  EXPECT_EQ(upload->file(), std::nullopt);
  const auto parsed = TryToParse(*upload).value();
  EXPECT_EQ(parsed.positions, soup.positions);
  EXPECT_EQ(parsed.triangles, soup.triangles);
}

TEST_F(MeshUploadTest, BadHeadersAreRefused) {
  using enum absl::StatusCode;
  ExpectRefused({.format = MeshFormat::kObj}, kInvalidArgument,
                "header.size_bytes", "empty");
  ExpectRefused({.format = MeshFormat::kObj, .size_bytes = (1 << 20) + 1},
                kResourceExhausted, "", "max_upload_bytes");
  ExpectRefused({.format = MeshFormat::kObj,
                 .size_bytes = 10,
                 .expected_digest = "short"},
                kInvalidArgument, "header.expected_digest", "64");
  ExpectRefused(
      {.format = MeshFormat::kObj, .size_bytes = 10, .vertex_count = 3},
      kInvalidArgument, "header.vertex_count", "arrays");
  ExpectRefused({.format = MeshFormat::kObj, .size_bytes = 10, .face_count = 3},
                kInvalidArgument, "header.face_count", "arrays");
}

TEST_F(MeshUploadTest, CountsOfArraysAreChecked) {
  using enum absl::StatusCode;
  ExpectRefused({.size_bytes = 100, .vertex_count = 3, .face_count = 1},
                kInvalidArgument, "header.size_bytes", "84");
  ExpectRefused({.size_bytes = 100, .vertex_count = 1001, .face_count = 1},
                kResourceExhausted, "", "max_vertices");
  ExpectRefused({.size_bytes = 100, .vertex_count = 3, .face_count = 2001},
                kResourceExhausted, "", "max_faces");
  // 24 V + 12 F = 36 in 64 bits.
  ExpectRefused({.size_bytes = 36,
                 .vertex_count = (uint64_t{1} << 61) + 1,
                 .face_count = 1},
                kResourceExhausted, "", "max_vertices");
}

TEST_F(MeshUploadTest, ChunksMustFollowEachOther) {
  auto upload = *Start({.format = MeshFormat::kObj, .size_bytes = 10});
  ASSERT_TRUE(upload->Append(0, "abc").ok());
  for (const uint64_t offset : {0, 2, 4}) {
    const absl::Status status = upload->Append(offset, "d");
    EXPECT_TRUE(absl::IsInvalidArgument(status));
    EXPECT_EQ(FieldPathOf(status), "chunk.offset");
    EXPECT_THAT(std::string(status.message()), HasSubstr("3 bytes"));
  }
  EXPECT_TRUE(upload->Append(3, "d").ok());
}

TEST_F(MeshUploadTest, NoMoreNorLessThanAnnounced) {
  auto upload = *Start({.format = MeshFormat::kObj, .size_bytes = 4});
  ASSERT_TRUE(upload->Append(0, "abc").ok());
  const absl::Status more = upload->Append(3, "de");
  EXPECT_TRUE(absl::IsInvalidArgument(more));
  EXPECT_EQ(FieldPathOf(more), "chunk.data");
  const absl::Status less = upload->Finish();
  EXPECT_TRUE(absl::IsInvalidArgument(less));
  EXPECT_THAT(std::string(less.message()),
              AllOf(HasSubstr("3"), HasSubstr("4")));
  EXPECT_TRUE(upload->Append(3, "d").ok());
  EXPECT_TRUE(upload->Finish().ok());
}

TEST_F(MeshUploadTest, AHeaderTakesNoMemory) {
  limits_.max_upload_bytes = uint64_t{1} << 40;
  auto upload =
      *Start({.format = MeshFormat::kObj, .size_bytes = uint64_t{1} << 40});
  EXPECT_EQ(memory_->used(), 0);
  ASSERT_TRUE(upload->Append(0, "v").ok());
  EXPECT_LE(memory_->used(), 2 << 20);
}

TEST_F(MeshUploadTest, BytesStayWithinTheBudget) {
  limits_.max_upload_bytes = uint64_t{1} << 30;
  auto upload =
      *Start({.format = MeshFormat::kObj, .size_bytes = uint64_t{1} << 30});
  const std::string chunk(1 << 20, '#');
  absl::Status status;
  uint64_t sent = 0;
  while (status.ok() && sent < (uint64_t{64} << 20)) {
    status = upload->Append(sent, chunk);
    sent += chunk.size();
  }
  EXPECT_TRUE(absl::IsResourceExhausted(status)) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr("upload memory"));
  upload.reset();
  EXPECT_EQ(memory_->used(), 0);
}

TEST_F(MeshUploadTest, ParsingIsPaidForInAdvance) {
  const std::string bytes(1 << 20, '\n');
  auto tight = std::make_shared<ByteBudget>("upload memory", 2 << 20);
  auto upload = *MeshUpload::Start(
      {.format = MeshFormat::kObj, .size_bytes = bytes.size()}, limits_, tight);
  ASSERT_TRUE(upload->Append(0, bytes).ok());
  ASSERT_TRUE(upload->Finish().ok());
  EXPECT_TRUE(absl::IsResourceExhausted(upload->ReserveForParse()));
}

// "3 0 0 0 ...", a polygon of so many corners in two bytes each.
std::string Polygon(uint32_t corners) {
  std::string bytes = absl::StrCat("OFF\n1 1 0\n0 0 0\n", corners);
  for (uint32_t corner = 0; corner < corners; ++corner) bytes += " 0";
  return bytes + "\n";
}

// It makes six times its size of triangles, and an array that grows holds twice
// its content at times.
TEST_F(MeshUploadTest, NoFileTakesMoreThanWasSetAside) {
  constexpr uint32_t kCorners = 100'000;
  constexpr uint64_t kTriangleBytes = (kCorners - 2) * sizeof(Triangle);
  limits_.max_faces = kCorners;
  auto upload = Received(Polygon(kCorners));
  ASSERT_TRUE(upload->ReserveForParse().ok());
  EXPECT_EQ(memory_->used(), MeshUpload::BytesToParse(upload->header()));
  const auto cut_off = upload->Parse(checkpoint_).value();
  EXPECT_FALSE(cut_off);

  uint64_t taken = 0;
  const auto parsed = TryToParse(*upload, &taken).value();
  EXPECT_EQ(parsed.triangles.size(), kCorners - 2);
  EXPECT_GE(taken, upload->header().size_bytes + 2 * kTriangleBytes);
  EXPECT_EQ(memory_->used(), upload->memory().bytes());
  EXPECT_GE(memory_->used(), kTriangleBytes);
}

TEST_F(MeshUploadTest, ALimitIsNoLackOfMemory) {
  limits_.max_faces = 10;
  auto upload = Received(Polygon(100));
  const absl::Status status = TryToParse(*upload).status();
  EXPECT_TRUE(absl::IsResourceExhausted(status)) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr("limit of 10"));
  EXPECT_EQ(memory_->used(), 0);
}

TEST_F(MeshUploadTest, CompressedFilesAreTheSameMesh) {
  const std::string off = test::OffFile(geodesic::test::Icosphere(2));
  auto plain = Received(off);
  auto compressed = Received(Gzip(off));
  ASSERT_TRUE(TryToParse(*plain).ok());
  const auto soup = TryToParse(*compressed);
  ASSERT_TRUE(soup.ok()) << soup.status();
  EXPECT_EQ(compressed->digest(), plain->digest());
}

// Its arrays are compressed, so the usual bounds do not hold.
TEST_F(MeshUploadTest, AVtpMayHoldMuchMoreThanItsBytes) {
  std::vector<int64_t> polygon(2002);
  for (size_t i = 0; i < polygon.size(); ++i) polygon[i] = i % 3;
  const std::string file =
      geodesic::test::VtpWriter({.format = geodesic::test::VtpFormat::kBinary,
                                 .is_compressed = true,
                                 .block_bytes = 1 << 15})
          .Write({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {polygon}}});
  auto upload = *Start({.format = MeshFormat::kVtp, .size_bytes = file.size()});
  ASSERT_TRUE(upload->Append(0, file).ok());
  ASSERT_TRUE(upload->Finish().ok());
  const auto parsed = TryToParse(*upload).value();
  ASSERT_EQ(parsed.triangles.size(), 2000u);
  EXPECT_GT(4 * 2000 * sizeof(Triangle), 48 * file.size());
}

TEST_F(MeshUploadTest, ABombTakesNoMoreThanAnUploadMay) {
  // Comments of 8 MiB, in some kilobytes.
  const std::string bomb =
      Gzip("OFF\n#" + std::string(8 << 20, ' ') + test::kTetrahedronOff);
  ASSERT_LT(bomb.size(), 20'000);
  auto upload = Received(bomb);
  uint64_t most = 0;
  for (;;) {
    ASSERT_TRUE(upload->ReserveForParse().ok());
    most = std::max(most, memory_->used());
    const auto parsed = upload->Parse(checkpoint_);
    if (parsed.ok()) {
      ASSERT_FALSE(*parsed);
      continue;
    }
    EXPECT_TRUE(absl::IsResourceExhausted(parsed.status())) << parsed.status();
    break;
  }
  // Twice max_upload_bytes, while it is decompressed.
  EXPECT_LE(most, 2 * limits_.max_upload_bytes + bomb.size());
  EXPECT_EQ(memory_->used(), 0);
}

TEST_F(MeshUploadTest, DamagedCompressionIsTheClientsFault) {
  std::string bytes = Gzip(test::kTetrahedronOff);
  bytes.resize(bytes.size() - 9);
  auto upload = Received(bytes);
  const absl::Status status = TryToParse(*upload).status();
  EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
  EXPECT_EQ(FieldPathOf(status).value_or(""), "chunk.data");
}

}  // namespace
}  // namespace geodesic::server
