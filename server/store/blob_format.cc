#include "server/store/blob_format.h"

#include <bit>
#include <cstring>

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "digest/sha256.h"

namespace geodesic::server {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::string_view kMagic = "geodesic";
constexpr size_t kKindBytes = 8;
constexpr uint32_t kVersion = 1;
constexpr size_t kDigestBytes = 32;

template <typename Number>
void Append(Number number, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
}

void AppendDigest(const std::string& hex, std::string& bytes) {
  bytes += absl::HexStringToBytes(hex);
}

template <typename Number>
Number Take(std::string_view& bytes) {
  Number number;
  std::memcpy(&number, bytes.data(), sizeof(number));
  bytes.remove_prefix(sizeof(number));
  return number;
}

std::string TakeDigest(std::string_view& bytes) {
  std::string hex =
      absl::BytesToHexString(absl::string_view(bytes.data(), kDigestBytes));
  bytes.remove_prefix(kDigestBytes);
  return hex;
}

}  // namespace

std::string EncodeBlobHeader(const BlobHeader& header) {
  std::string bytes(kMagic);
  bytes += header.kind;
  bytes.resize(kMagic.size() + kKindBytes);
  Append(kVersion, bytes);
  Append(static_cast<uint32_t>(kBlobHeaderBytes), bytes);
  Append(header.body_bytes, bytes);
  Append(header.metadata_bytes, bytes);
  AppendDigest(header.name, bytes);
  AppendDigest(header.body_sha256, bytes);
  AppendDigest(header.metadata_sha256, bytes);
  AppendDigest(Sha256Hex(bytes), bytes);
  return bytes;
}

absl::StatusOr<BlobHeader> DecodeBlobHeader(std::string_view bytes) {
  const std::string_view all = bytes;
  if (bytes.substr(0, kMagic.size()) != kMagic) {
    return absl::DataLossError("the file does not begin as geodesicd's do");
  }
  std::string_view digest = all.substr(kBlobHeaderBytes - kDigestBytes);
  if (TakeDigest(digest) !=
      Sha256Hex(all.substr(0, kBlobHeaderBytes - kDigestBytes))) {
    return absl::DataLossError("the header does not have the digest it names");
  }
  bytes.remove_prefix(kMagic.size());
  BlobHeader header;
  header.kind = bytes.substr(0, kKindBytes);
  header.kind.resize(header.kind.find_last_not_of('\0') + 1);
  bytes.remove_prefix(kKindBytes);
  const auto version = Take<uint32_t>(bytes);
  const auto size = Take<uint32_t>(bytes);
  if (version != kVersion || size != kBlobHeaderBytes) {
    return absl::FailedPreconditionError(absl::StrCat(
        "the file has format ", version, "; this geodesicd knows ", kVersion));
  }
  header.body_bytes = Take<uint64_t>(bytes);
  header.metadata_bytes = Take<uint64_t>(bytes);
  header.name = TakeDigest(bytes);
  header.body_sha256 = TakeDigest(bytes);
  header.metadata_sha256 = TakeDigest(bytes);
  return header;
}

}  // namespace geodesic::server
