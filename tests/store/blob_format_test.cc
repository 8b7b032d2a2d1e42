#include "server/store/blob_format.h"

#include <gtest/gtest.h>

#include "digest/sha256.h"

namespace geodesic::server {
namespace {

BlobHeader Header() {
  return {.kind = "mesh",
          .name = Sha256Hex("name"),
          .body_bytes = 0x0102030405060708,
          .metadata_bytes = 77,
          .body_sha256 = Sha256Hex("body"),
          .metadata_sha256 = Sha256Hex("metadata")};
}

TEST(BlobFormatTest, HeadersComeBack) {
  const std::string bytes = EncodeBlobHeader(Header());
  ASSERT_EQ(bytes.size(), kBlobHeaderBytes);
  const auto header = DecodeBlobHeader(bytes);
  ASSERT_TRUE(header.ok()) << header.status();
  EXPECT_EQ(*header, Header());
}

// The places that the header's own comment names.
TEST(BlobFormatTest, LiesAsDescribed) {
  const std::string bytes = EncodeBlobHeader(Header());
  EXPECT_EQ(bytes.substr(0, 16), std::string("geodesicmesh\0\0\0\0", 16));
  EXPECT_EQ(bytes.substr(16, 8), std::string("\1\0\0\0\xa8\0\0\0", 8));
  EXPECT_EQ(bytes.substr(24, 8), "\x08\x07\x06\x05\x04\x03\x02\x01");
  EXPECT_EQ(bytes[32], 77);
}

TEST(BlobFormatTest, AnUnknownVersionIsNoDamage) {
  std::string bytes = EncodeBlobHeader(Header());
  bytes[16] = 2;
  // The digest that a later version would write.
  const std::string hex = Sha256Hex(bytes.substr(0, 136));
  for (size_t i = 0; i < 32; ++i) {
    bytes[136 + i] =
        static_cast<char>(std::stoi(hex.substr(2 * i, 2), nullptr, 16));
  }
  EXPECT_TRUE(absl::IsFailedPrecondition(DecodeBlobHeader(bytes).status()));
}

}  // namespace
}  // namespace geodesic::server
