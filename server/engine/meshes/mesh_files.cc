#include "server/engine/meshes/mesh_files.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <span>
#include <string_view>
#include <utility>

#include "absl/strings/str_cat.h"
#include "server/engine/base/argument_checks.h"
#include "server/engine/base/binary_codec.h"
#include "server/engine/base/status_details.h"
#include "server/engine/meshes/mesh_digest.h"

namespace geodesic::server {
namespace {

constexpr uint32_t kMetadataVersion = 1;

// A cancelled read stops within this many bytes, about 10 ms.
constexpr size_t kPieceBytes = size_t{8} << 20;

// Freeing disk space takes longer than a second.
constexpr std::chrono::milliseconds kRetryDelay{5000};

// Calls `visit` for each number of a summary, in the order of the file.
template <typename Summary, typename Visit>
void VisitNumbers(Summary& summary, Visit visit) {
  visit(summary.vertices);
  visit(summary.faces);
  visit(summary.edges);
  visit(summary.boundary_edges);
  visit(summary.boundary_loops);
  visit(summary.components);
  visit(summary.isolated_vertices);
  visit(summary.non_manifold_edges);
  visit(summary.non_manifold_vertices);
  visit(summary.inconsistent_edges);
  visit(summary.is_orientable);
  visit(summary.saddle_vertices);
  visit(summary.degenerate_faces);
  for (auto& x : summary.bounding_box_min) visit(x);
  for (auto& x : summary.bounding_box_max) visit(x);
  visit(summary.mean_edge_length);
  visit(summary.anisotropy);
}

// Bytes of the body of a mesh's file.
uint64_t BodyBytes(uint64_t vertices, uint64_t faces) {
  return MeshDigestHead(vertices, faces).size() + vertices * sizeof(Point) +
         faces * sizeof(Triangle);
}

struct Metadata {
  MeshSummary summary;
  std::optional<FileKey> file;
};

std::string Encode(const MeshSummary& summary,
                   const std::optional<FileKey>& file) {
  BinaryWriter writer;
  writer.Put(kMetadataVersion);
  VisitNumbers(summary, [&](auto number) { writer.Put(number); });
  writer.Put(summary.genus.has_value());
  writer.Put(summary.genus.value_or(0));
  writer.Put(file.has_value());
  writer.Put(static_cast<uint32_t>(file ? file->format : UploadFormat()));
  writer.PutString(file ? file->sha256 : "");
  return writer.bytes();
}

// Empty if the metadata has another version.
std::optional<Metadata> Decode(std::string_view bytes) {
  return DecodeRecord<Metadata>(
      bytes, kMetadataVersion, [](BinaryReader& reader, Metadata& metadata) {
        VisitNumbers(metadata.summary,
                     [&](auto& number) { reader.Get(number); });
        bool has_genus = false;
        int64_t genus = 0;
        reader.Get(has_genus);
        reader.Get(genus);
        if (has_genus) metadata.summary.genus = genus;
        bool has_file = false;
        uint32_t format = 0;
        FileKey file;
        reader.Get(has_file);
        reader.Get(format);
        reader.GetString(file.sha256);
        file.format = static_cast<UploadFormat>(format);
        if (has_file) metadata.file = std::move(file);
      });
}

std::optional<MeshDescription> ToDescription(BlobInfo info) {
  std::optional<Metadata> metadata = Decode(info.metadata);
  if (!metadata) return std::nullopt;
  return MeshDescription{.digest = std::move(info.name),
                         .summary = metadata->summary,
                         .stored_bytes = info.file_bytes};
}

// Mesh stores its faces in another order than the file.
absl::Status AppendTriangles(const Mesh& mesh, BlobSink& sink) {
  constexpr uint32_t kPiece = 64 << 10;
  std::vector<Triangle> piece;
  for (uint32_t face = 0; face < mesh.face_count();) {
    piece.clear();
    for (; face < mesh.face_count() && piece.size() < kPiece; ++face) {
      piece.push_back(mesh.triangle(face));
    }
    absl::Status status = sink.Append(AsBytes(piece));
    if (!status.ok()) return status;
  }
  return absl::OkStatus();
}

template <typename T>
absl::Status ReadArray(BlobBody& body, Checkpoint& checkpoint,
                       std::vector<T>& values) {
  std::span<char> bytes(reinterpret_cast<char*>(values.data()),
                        values.size() * sizeof(T));
  while (!bytes.empty()) {
    const size_t count = std::min(bytes.size(), kPieceBytes);
    absl::Status status = checkpoint.Poll({});
    if (status.ok()) status = body.Read(bytes.first(count));
    if (!status.ok()) return status;
    bytes = bytes.subspan(count);
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<std::unique_ptr<MeshFiles>> MeshFiles::Open(
    const DataFolder& folder, uint64_t capacity,
    std::function<void(const std::string&)> warn) {
  std::unique_ptr<MeshFiles> files(new MeshFiles());
  auto blobs = BlobStore::Open(
      folder, {.kind = "mesh",
               .capacity = capacity,
               .is_named_by_content = true,
               .removed =
                   [files = files.get()](const std::string& digest) {
                     files->ForgetFiles(digest);
                     if (files->removed_) files->removed_(digest);
                   },
               .warn = std::move(warn)});
  if (!blobs.ok()) return blobs.status();
  files->blobs_ = *std::move(blobs);
  files->blobs_->ForEach(
      [&](const std::string& name, std::string_view metadata) {
        const std::optional<Metadata> decoded = Decode(metadata);
        if (decoded && decoded->file) files->RememberFile(*decoded->file, name);
      });
  return files;
}

std::optional<MeshDescription> MeshFiles::Describe(const std::string& digest) {
  std::optional<BlobInfo> info = blobs_->Find(digest);
  return info ? ToDescription(*std::move(info)) : std::nullopt;
}

std::vector<MeshDescription> MeshFiles::List(const std::string& after,
                                             size_t count) const {
  std::vector<MeshDescription> page;
  for (BlobInfo& info : blobs_->List(after, count)) {
    if (auto mesh = ToDescription(std::move(info))) {
      page.push_back(*std::move(mesh));
    }
  }
  return page;
}

absl::Status MeshFiles::Admit(uint64_t vertices, uint64_t faces) {
  // Metadata of the largest size.
  const std::string metadata =
      Encode(MeshSummary(), FileKey{UploadFormat::kStl, std::string(64, '0')});
  return blobs_->Admit(BodyBytes(vertices, faces), metadata.size());
}

absl::Status MeshFiles::Put(const ResidentMesh& mesh,
                            const std::optional<FileKey>& file) {
  const Mesh& arrays = *mesh.mesh;
  absl::Status status = Admit(arrays.vertex_count(), arrays.face_count());
  if (!status.ok()) return status;
  const auto write = [&](BlobSink& sink) {
    absl::Status written =
        sink.Append(MeshDigestHead(arrays.vertex_count(), arrays.face_count()));
    if (written.ok()) written = sink.Append(AsBytes(arrays.positions()));
    if (written.ok()) written = AppendTriangles(arrays, sink);
    return written;
  };
  status =
      blobs_->Put(mesh.digest, Encode(mesh.summary, file),
                  BodyBytes(arrays.vertex_count(), arrays.face_count()), write);
  if (status.ok()) return status;
  return WithRetryAfter(
      absl::Status(status.code(),
                   absl::StrCat("the mesh cannot be kept: ", status.message(),
                                "; delete meshes or free the server's disk")),
      kRetryDelay);
}

absl::StatusOr<TriangleSoup> MeshFiles::Load(const MeshDescription& mesh,
                                             Checkpoint& checkpoint) {
  TriangleSoup soup;
  const absl::Status status = blobs_->Read(mesh.digest, [&](BlobBody& body) {
    const std::string expected =
        MeshDigestHead(mesh.summary.vertices, mesh.summary.faces);
    if (body.bytes_left() !=
        BodyBytes(mesh.summary.vertices, mesh.summary.faces)) {
      return absl::DataLossError("the body has not the size of the mesh");
    }
    // The head holds the counts, which the digest covers.
    std::string head(expected.size(), '\0');
    absl::Status read = body.Read(head);
    if (!read.ok()) return read;
    if (head != expected) {
      return absl::DataLossError("the counts are not those of the mesh");
    }
    soup.positions.resize(mesh.summary.vertices);
    soup.triangles.resize(mesh.summary.faces);
    read = ReadArray(body, checkpoint, soup.positions);
    if (read.ok()) read = ReadArray(body, checkpoint, soup.triangles);
    return read;
  });
  if (status.ok()) return soup;
  if (absl::IsDataLoss(status)) {
    return absl::NotFoundError(absl::StrCat(
        "mesh ", mesh.digest,
        " was damaged on the server's disk and set aside; upload it again"));
  }
  if (absl::IsNotFound(status)) return NotResident(mesh.digest);
  return absl::IsCancelled(status) ? status
                                   : WithRetryAfter(status, kRetryDelay);
}

absl::Status MeshFiles::Erase(const std::string& digest) {
  absl::Status status = blobs_->Erase(digest);
  if (absl::IsNotFound(status)) return NotResident(digest);
  if (status.ok()) ForgetFiles(digest);
  return status;
}

}  // namespace geodesic::server
