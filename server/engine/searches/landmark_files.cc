#include "server/engine/searches/landmark_files.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "digest/sha256.h"
#include "server/engine/base/binary_codec.h"

namespace geodesic::server {
namespace {

// Apart from those of fields, which are in the same folder.
constexpr uint32_t kMetadataVersion = 1001;

static_assert(sizeof(Landmarks::Row) == Landmarks::kMost * sizeof(float),
              "rows are kept as they lie in memory");

std::string Encode(const Landmarks& landmarks) {
  BinaryWriter writer;
  writer.Put(kMetadataVersion);
  writer.Put(landmarks.count());
  return writer.bytes();
}

// How many there are. Empty if the metadata has another version.
std::optional<uint32_t> Decode(std::string_view bytes) {
  return DecodeRecord<uint32_t>(
      bytes, kMetadataVersion,
      [](BinaryReader& reader, uint32_t& count) { reader.Get(count); });
}

}  // namespace

std::string LandmarkFiles::NameOf(const std::string& digest) const {
  BinaryWriter writer;
  writer.PutString("geodesic.landmarks.v1");
  writer.PutString(version_);
  writer.PutString(digest);
  return Sha256Hex(writer.bytes());
}

absl::Status LandmarkFiles::Put(const std::string& digest,
                                const Landmarks& landmarks) {
  const std::array<std::string_view, 1> body = {AsBytes(landmarks.rows())};
  return blobs_.Put(NameOf(digest), Encode(landmarks), body);
}

absl::StatusOr<Landmarks> LandmarkFiles::Load(const std::string& digest,
                                              const Mesh& mesh) {
  const std::string name = NameOf(digest);
  const std::optional<BlobInfo> info = blobs_.Find(name);
  const std::optional<uint32_t> count =
      info ? Decode(info->metadata) : std::nullopt;
  if (!count || *count > Landmarks::kMost ||
      info->body_bytes != Landmarks::PlannedBytes(mesh)) {
    return absl::NotFoundError("the landmarks are not on disk");
  }
  std::vector<Landmarks::Row> rows(mesh.vertex_count());
  absl::Status status = blobs_.Read(name, [&](BlobBody& body) {
    return body.Read({reinterpret_cast<char*>(rows.data()),
                      rows.size() * sizeof(Landmarks::Row)});
  });
  if (!status.ok()) return status;
  return Landmarks(mesh, *count, std::move(rows));
}

void LandmarkFiles::Erase(const std::string& digest) {
  (void)blobs_.Erase(NameOf(digest));
}

}  // namespace geodesic::server
