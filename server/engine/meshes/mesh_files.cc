#include "server/engine/meshes/mesh_files.h"

#include <chrono>
#include <string_view>
#include <utility>

#include "absl/strings/str_cat.h"
#include "server/engine/base/argument_checks.h"
#include "server/engine/base/binary_codec.h"
#include "server/engine/base/status_details.h"
#include "server/engine/meshes/mesh_body.h"

namespace geodesic::server {
namespace {

// Freeing disk space takes longer than a second.
constexpr std::chrono::milliseconds kDiskRetryDelay{5000};

// Calls `visit` for each number of a summary, in the order of the file.
template <typename Summary, typename Visit>
void VisitNumbers(Summary& summary, Visit visit) {
  ForEachFact(summary, [&](std::string_view, auto& fact) {
    if constexpr (requires { fact.size(); }) {
      for (auto& number : fact) visit(number);
    } else if constexpr (!requires { fact.has_value(); }) {
      visit(fact);
    }
  });
  visit(summary.crossing_polygons);
  visit(summary.first_crossing_polygon);
}

struct Metadata {
  MeshSummary summary;
  std::optional<FileKey> file;
};

uint32_t FormatNumber(const UploadFormat& format) {
  return format == kArrays ? 0 : 1 + static_cast<uint32_t>(*format);
}

std::string Encode(const MeshSummary& summary,
                   const std::optional<FileKey>& file) {
  BinaryWriter writer;
  writer.Put(kMeshRecord);
  VisitNumbers(summary, [&](auto number) { writer.Put(number); });
  writer.Put(summary.genus.has_value());
  writer.Put(summary.genus.value_or(0));
  writer.Put(file.has_value());
  writer.Put(file ? FormatNumber(file->format) : 0);
  writer.PutString(file ? file->sha256 : "");
  const Welding welding = file ? file->welding : Welding();
  writer.Put(static_cast<uint32_t>(welding.kind));
  writer.Put(welding.distance);
  return writer.bytes();
}

// Empty if the metadata is another record.
std::optional<Metadata> Decode(std::string_view bytes) {
  return DecodeRecord<Metadata>(
      bytes, kMeshRecord, [](BinaryReader& reader, Metadata& metadata) {
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
        uint32_t kind = 0;
        reader.Get(kind);
        reader.Get(file.welding.distance);
        file.welding.kind = static_cast<Welding::Kind>(kind);
        if (format != 0) file.format = static_cast<MeshFormat>(format - 1);
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
  // As much metadata as any file has.
  const std::string metadata = Encode(
      MeshSummary(),
      FileKey{.format = MeshFormat::kVtp, .sha256 = std::string(64, '0')});
  return blobs_->Admit(MeshBodyBytes(vertices, faces), metadata.size());
}

absl::Status MeshFiles::Put(const ResidentMesh& mesh,
                            const std::optional<FileKey>& file) {
  const Mesh& arrays = *mesh.mesh;
  const std::string metadata = Encode(mesh.summary, file);
  const uint64_t bytes = MeshBodyBytes(arrays);
  absl::Status status = blobs_->Admit(bytes, metadata.size());
  if (!status.ok()) return status;
  const auto write = [&](BlobSink& sink) {
    return WriteMeshBody(
        arrays, [&](std::string_view part) { return sink.Append(part); });
  };
  status = blobs_->Put(mesh.digest, metadata, bytes, write);
  if (status.ok()) return status;
  return WithRetryAfter(
      absl::Status(status.code(),
                   absl::StrCat("the mesh cannot be kept: ", status.message(),
                                "; delete meshes or free the server's disk")),
      kDiskRetryDelay);
}

absl::Status MeshFiles::Look(const std::string& digest) {
  const absl::Status status = blobs_->Look(digest);
  return status.ok() || absl::IsNotFound(status)
             ? status
             : WithRetryAfter(status, kDiskRetryDelay);
}

absl::StatusOr<TriangleSoup> MeshFiles::Load(const MeshDescription& mesh,
                                             Checkpoint& checkpoint) {
  absl::StatusOr<TriangleSoup> soup = TriangleSoup();
  const auto take = [&](std::string_view, BlobBody& body) {
    soup = ReadMeshBody(body, mesh.summary.vertices, mesh.summary.faces,
                        checkpoint);
    return soup.status();
  };
  const absl::Status status = blobs_->Read(mesh.digest, take);
  if (status.ok()) return soup;
  if (absl::IsDataLoss(status)) {
    return WithMesh(
        absl::NotFoundError(absl::StrCat("mesh ", mesh.digest,
                                         " was damaged on the server's disk "
                                         "and set aside; upload it again")),
        mesh.digest);
  }
  if (absl::IsNotFound(status)) return NotResident(mesh.digest);
  return absl::IsCancelled(status) ? status
                                   : WithRetryAfter(status, kDiskRetryDelay);
}

absl::Status MeshFiles::Erase(const std::string& digest) {
  absl::Status status = blobs_->Erase(digest);
  if (absl::IsNotFound(status)) return NotResident(digest);
  if (status.ok()) ForgetFiles(digest);
  return status;
}

}  // namespace geodesic::server
