// How a blob lies in its file:
//
//   header     168 bytes, described below
//   body       what is kept
//   metadata   what is known about it, read at every start
//
// Integers are little endian; digests are sha-256, 32 bytes.
//
//     0  "geodesic"
//     8  kind, 8 bytes, padded with zeros ("mesh", "field")
//    16  version of this format, uint32; 20: bytes of the header, uint32
//    24  bytes of the body, uint64;      32: bytes of the metadata, uint64
//    40  the blob's name: the file's name, for a file that was renamed
//    72  digest of the body;            104: digest of the metadata
//   136  digest of the 136 bytes before
//
// So digests cover each byte of a file and its length.

#ifndef GEODESIC_SERVER_STORE_BLOB_FORMAT_H_
#define GEODESIC_SERVER_STORE_BLOB_FORMAT_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace geodesic::server {

inline constexpr size_t kBlobHeaderBytes = 168;

struct BlobHeader {
  std::string kind;  // at most 8 characters
  std::string name;  // a digest's 64 hexadecimal digits, as the two below
  uint64_t body_bytes = 0;
  uint64_t metadata_bytes = 0;
  std::string body_sha256;
  std::string metadata_sha256;

  friend bool operator==(const BlobHeader&, const BlobHeader&) = default;
};

// kBlobHeaderBytes bytes.
std::string EncodeBlobHeader(const BlobHeader& header);

// Errors: DATA_LOSS saying what is wrong; FAILED_PRECONDITION for a version
// that this program does not know.
// REQUIRES: bytes.size() == kBlobHeaderBytes.
absl::StatusOr<BlobHeader> DecodeBlobHeader(std::string_view bytes);

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_STORE_BLOB_FORMAT_H_
