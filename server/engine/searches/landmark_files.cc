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

static_assert(sizeof(Landmarks::Row) == sizeof(Landmarks::Steps),
              "rows are kept as they lie in memory");

struct Metadata {
  uint32_t count = 0;
  double step = 0;
};

std::string Encode(const Landmarks& landmarks) {
  BinaryWriter writer;
  writer.Put(kLandmarksRecord);
  writer.Put(landmarks.count());
  writer.Put(landmarks.step());
  return writer.bytes();
}

// Empty if the metadata is another record.
std::optional<Metadata> Decode(std::string_view bytes) {
  return DecodeRecord<Metadata>(bytes, kLandmarksRecord,
                                [](BinaryReader& reader, Metadata& metadata) {
                                  reader.Get(metadata.count);
                                  reader.Get(metadata.step);
                                });
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
  const std::string name = NameOf(digest);
  const std::string metadata = Encode(landmarks);
  const std::array<std::string_view, 1> body = {AsBytes(landmarks.rows())};
  blobs_.Share(name, metadata, body);
  return blobs_.Keep(name, metadata, body);
}

absl::StatusOr<Landmarks> LandmarkFiles::Load(const std::string& digest,
                                              const Mesh& mesh) {
  std::optional<Metadata> about;
  std::vector<Landmarks::Row> rows;
  const auto take = [&](std::string_view metadata,
                        BlobBody& body) -> absl::Status {
    about = Decode(metadata);
    if (!about || about->count > Landmarks::kMost ||
        body.bytes_left() != Landmarks::PlannedBytes(mesh)) {
      return absl::NotFoundError("the landmarks that are kept are of no use");
    }
    rows.resize(mesh.vertex_count());
    return body.Read(AsWritableBytes(rows));
  };
  const std::string name = NameOf(digest);
  const absl::StatusOr<BlobTier> from = blobs_.Read(name, take);
  if (!from.ok()) return from.status();
  Landmarks landmarks(mesh, about->count, about->step, std::move(rows));
  if (*from == BlobTier::kShared) {
    (void)blobs_.Keep(
        name, Encode(landmarks),
        std::array<std::string_view, 1>{AsBytes(landmarks.rows())});
  }
  return landmarks;
}

void LandmarkFiles::Erase(const std::string& digest) {
  (void)blobs_.Erase(NameOf(digest));
}

}  // namespace geodesic::server
