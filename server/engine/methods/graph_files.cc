#include "server/engine/methods/graph_files.h"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "digest/sha256.h"
#include "server/engine/base/binary_codec.h"

namespace geodesic::server {
namespace {

using Arc = SaddleVertexGraph::Arc;
static_assert(sizeof(Arc) == sizeof(uint32_t) + sizeof(float),
              "arcs are kept as they lie in memory");

struct Metadata {
  std::string mesh_digest;
  uint64_t arcs = 0;
};

std::string Encode(const std::string& digest, const SaddleVertexGraph& graph) {
  BinaryWriter writer;
  writer.Put(kGraphRecord);
  writer.PutString(digest);
  writer.Put(uint64_t{graph.arcs().size()});
  return writer.bytes();
}

std::array<std::string_view, 2> Body(const SaddleVertexGraph& graph) {
  return {AsBytes(graph.offsets()), AsBytes(graph.arcs())};
}

// Empty if the metadata is another record.
std::optional<Metadata> Decode(std::string_view bytes) {
  return DecodeRecord<Metadata>(bytes, kGraphRecord,
                                [](BinaryReader& reader, Metadata& metadata) {
                                  reader.GetString(metadata.mesh_digest);
                                  reader.Get(metadata.arcs);
                                });
}

}  // namespace

std::string GraphFiles::NameOf(const std::string& digest,
                               uint32_t neighbours) const {
  BinaryWriter writer;
  writer.PutString("geodesic.saddle-vertex-graph.v1");
  writer.PutString(version_);
  writer.PutString(digest);
  writer.Put(neighbours);
  return Sha256Hex(writer.bytes());
}

absl::Status GraphFiles::Put(const std::string& digest, uint32_t neighbours,
                             const SaddleVertexGraph& graph) {
  const std::string name = NameOf(digest, neighbours);
  const std::string metadata = Encode(digest, graph);
  blobs_.Share(name, metadata, Body(graph));
  return blobs_.Keep(name, metadata, Body(graph));
}

absl::StatusOr<std::shared_ptr<const SaddleVertexGraph>> GraphFiles::Load(
    const std::string& digest, uint32_t neighbours, const Mesh& mesh) {
  std::vector<uint64_t> offsets;
  std::vector<Arc> arcs;
  const auto take = [&](std::string_view bytes,
                        BlobBody& body) -> absl::Status {
    const std::optional<Metadata> metadata = Decode(bytes);
    const uint64_t offset_count = uint64_t{mesh.vertex_count()} + 1;
    if (!metadata || metadata->arcs > body.bytes_left() / sizeof(Arc) ||
        body.bytes_left() !=
            offset_count * sizeof(uint64_t) + metadata->arcs * sizeof(Arc)) {
      return absl::NotFoundError("the graph that is kept is of no use");
    }
    offsets.resize(offset_count);
    arcs.resize(metadata->arcs);
    absl::Status read = body.Read(AsWritableBytes(offsets));
    return read.ok() ? body.Read(AsWritableBytes(arcs)) : read;
  };
  const std::string name = NameOf(digest, neighbours);
  const absl::StatusOr<BlobTier> from = blobs_.Read(name, take);
  if (!from.ok()) return from.status();
  auto graph =
      SaddleVertexGraph::FromArcs(mesh, std::move(offsets), std::move(arcs));
  if (graph.ok() && *from == BlobTier::kShared) {
    (void)blobs_.Keep(name, Encode(digest, **graph), Body(**graph));
  }
  return graph;
}

void GraphFiles::EraseMesh(const std::string& digest) {
  blobs_.EraseIf([&](std::string_view metadata) {
    const std::optional<Metadata> decoded = Decode(metadata);
    return decoded && decoded->mesh_digest == digest;
  });
}

}  // namespace geodesic::server
