#include "server/engine/meshes/mesh_library.h"

#include <map>
#include <utility>

#include "absl/strings/str_cat.h"
#include "geodesic/field_path.h"
#include "server/engine/base/argument_checks.h"

namespace geodesic::server {
namespace {

// Of the mesh store.
uint64_t BytesToKeep(const std::string& digest, uint64_t vertices,
                     uint64_t faces) {
  return Mesh::EstimateResidentBytes(vertices, faces) + sizeof(ResidentMesh) +
         digest.capacity();
}

// Of the upload memory, for a mesh whose arrays are all it comes from.
uint64_t BytesFromArrays(uint64_t vertices, uint64_t faces) {
  return vertices * sizeof(Point) + faces * sizeof(Triangle) +
         MeshLibrary::BytesToBuild(vertices, faces);
}

}  // namespace

MeshLibrary::MeshLibrary(const Limits& limits, const Clock& clock,
                         Scheduler& scheduler,
                         std::shared_ptr<ByteBudget> upload_memory)
    : upload_memory_(std::move(upload_memory)),
      store_(limits.mesh_store_bytes),
      loads_(scheduler, clock, limits.progress_interval) {}

void MeshLibrary::Attach(
    MeshFiles& files, std::function<void(const std::string& digest)> removed) {
  files_ = &files;
  files.SetRemoved(
      [this, removed = std::move(removed)](const std::string& digest) {
        store_.Erase(digest);
        removed(digest);
      });
}

MeshHandle MeshLibrary::FindResident(const std::string& digest) {
  MeshHandle mesh = store_.Find(digest);
  if (mesh != nullptr && files_ != nullptr) files_->Contains(digest);
  return mesh;
}

std::optional<MeshDescription> MeshLibrary::Describe(
    const std::string& digest) {
  const MeshHandle resident = store_.Find(digest);
  if (files_ == nullptr) {
    return resident == nullptr ? std::nullopt
                               : std::optional(resident->Describe());
  }
  std::optional<MeshDescription> mesh = files_->Describe(digest);
  if (mesh && resident != nullptr) {
    mesh->resident_bytes = resident->mesh->resident_bytes();
  }
  return mesh;
}

bool MeshLibrary::Contains(const std::string& digest) {
  return files_ == nullptr ? store_.Find(digest) != nullptr
                           : files_->Contains(digest);
}

std::optional<std::string> MeshLibrary::FindFile(const FileKey& file) {
  std::optional<std::string> digest =
      files_ == nullptr ? store_.FindFile(file) : files_->FindFile(file);
  return digest && Contains(*digest) ? digest : std::nullopt;
}

std::vector<MeshDescription> MeshLibrary::List(const std::string& after,
                                               size_t count) const {
  std::map<std::string, MeshDescription> page;
  if (files_ != nullptr) {
    for (MeshDescription& mesh : files_->List(after, count)) {
      page.emplace(mesh.digest, std::move(mesh));
    }
  }
  for (const MeshHandle& resident : store_.List(after, count)) {
    const auto stored = page.find(resident->digest);
    if (stored != page.end()) {
      stored->second.resident_bytes = resident->mesh->resident_bytes();
    } else if (files_ == nullptr) {
      page.emplace(resident->digest, resident->Describe());
    }
  }
  std::vector<MeshDescription> meshes;
  meshes.reserve(page.size());
  for (auto& [digest, mesh] : page) meshes.push_back(std::move(mesh));
  return meshes;
}

absl::StatusOr<std::optional<MeshLoads::Ticket>> MeshLibrary::Await(
    const std::string& digest, MeshCallback done, const std::string& client) {
  if (MeshHandle mesh = FindResident(digest)) {
    done(std::move(mesh));
    return std::nullopt;
  }
  const std::optional<MeshDescription> mesh = Describe(digest);
  if (!mesh) return NotResident(digest);
  absl::Status status =
      CheckMemory(digest, mesh->summary.vertices, mesh->summary.faces);
  if (!status.ok()) return status;
  auto memory = std::make_shared<LoadMemory>();
  absl::StatusOr<MeshLoads::Ticket> ticket =
      loads_.Join(digest, {.done = std::move(done)}, JobPriority::kBuild, [&] {
        return SharedWork<MeshHandle>{
            .priority = JobPriority::kBuild,
            .client = client,
            .reserve = [this, digest,
                        memory] { return Reserve(digest, *memory); },
            .run = [this, digest, memory](JobCheckpoint& checkpoint)
                -> absl::StatusOr<std::optional<MeshHandle>> {
              return Load(digest, *memory, checkpoint);
            }};
      });
  if (!ticket.ok()) return ticket.status();
  return *std::move(ticket);
}

absl::Status MeshLibrary::CheckCapacity(const UploadHeader& header) const {
  absl::Status status =
      upload_memory_->CheckCapacity(MeshUpload::BytesToParse(header));
  if (!status.ok() || header.format != UploadFormat::kArrays) return status;
  return CheckCapacity(/*digest=*/{}, header.vertex_count, header.face_count);
}

absl::Status MeshLibrary::CheckCapacity(const std::string& digest,
                                        uint64_t vertices,
                                        uint64_t faces) const {
  absl::Status status = CheckMemory(digest, vertices, faces);
  if (!status.ok() || files_ == nullptr) return status;
  return files_->Admit(vertices, faces);
}

absl::Status MeshLibrary::CheckMemory(const std::string& digest,
                                      uint64_t vertices, uint64_t faces) const {
  absl::Status status =
      upload_memory_->CheckCapacity(BytesFromArrays(vertices, faces));
  if (!status.ok()) return status;
  return store_.CheckCapacity(BytesToKeep(digest, vertices, faces));
}

absl::Status MeshLibrary::Reserve(const std::string& digest,
                                  LoadMemory& memory) {
  if (MeshHandle mesh = FindResident(digest)) {
    memory.mesh = std::move(mesh);
    return absl::OkStatus();
  }
  const std::optional<MeshDescription> mesh = files_->Describe(digest);
  if (!mesh) return NotResident(digest);
  absl::StatusOr<ByteReservation> arrays = ByteReservation::Make(
      upload_memory_,
      BytesFromArrays(mesh->summary.vertices, mesh->summary.faces));
  if (!arrays.ok()) return arrays.status();
  absl::StatusOr<ByteReservation> room =
      ReserveResident(digest, mesh->summary.vertices, mesh->summary.faces);
  if (!room.ok()) return room.status();
  memory = {.arrays = *std::move(arrays), .room = *std::move(room)};
  return absl::OkStatus();
}

absl::StatusOr<MeshHandle> MeshLibrary::Load(const std::string& digest,
                                             LoadMemory& memory,
                                             Checkpoint& checkpoint) {
  if (memory.mesh != nullptr) return std::move(memory.mesh);
  const std::optional<MeshDescription> mesh = files_->Describe(digest);
  if (!mesh) return NotResident(digest);
  absl::StatusOr<TriangleSoup> soup = files_->Load(*mesh, checkpoint);
  if (!soup.ok()) return soup.status();
  absl::StatusOr<std::shared_ptr<const Mesh>> built =
      Mesh::Build(*std::move(soup), checkpoint);
  if (absl::IsInvalidArgument(built.status())) {
    // It was built once, from the same bytes.
    return absl::InternalError(absl::StrCat(
        "mesh ", digest, " cannot be built: ", built.status().message()));
  }
  if (!built.ok()) return built.status();
  MeshHandle kept =
      Keep({digest, *std::move(built), mesh->summary}, std::move(memory.room))
          .mesh;
  if (kept == nullptr) return NotResident(digest);
  ++meshes_loaded_;
  return kept;
}

MeshStore::Inserted MeshLibrary::Keep(ResidentMesh mesh, ByteReservation room) {
  const std::string digest = mesh.digest;
  MeshStore::Inserted kept = store_.Insert(std::move(mesh), std::move(room));
  // Whoever erased it from the disk before this moment found nothing in memory
  // to erase; whoever does so later will.
  if (files_ != nullptr && !files_->Contains(digest)) {
    store_.Erase(digest);
    kept.mesh = nullptr;
  }
  return kept;
}

std::optional<UploadResult> MeshLibrary::FindUploaded(
    const MeshUpload& upload) {
  const std::optional<std::string> digest = FindFile(upload.file());
  const std::string& expected = upload.header().expected_digest;
  if (!digest || (!expected.empty() && expected != *digest)) {
    return std::nullopt;
  }
  std::optional<MeshDescription> mesh = Describe(*digest);
  if (!mesh) return std::nullopt;
  return UploadResult{*std::move(mesh), true};
}

void MeshLibrary::RememberFile(const MeshUpload& upload,
                               const std::string& digest) {
  // The bytes of arrays do not say how many of them are vertices, so they do
  // not name a mesh.
  if (upload.header().format == UploadFormat::kArrays) return;
  if (files_ != nullptr) {
    files_->AddFile(upload.file(), digest);
  } else {
    store_.AddFile(upload.file(), digest);
  }
}

absl::StatusOr<ByteReservation> MeshLibrary::ReserveResident(
    const std::string& digest, uint64_t vertices, uint64_t faces) {
  return store_.Reserve(BytesToKeep(digest, vertices, faces));
}

uint64_t MeshLibrary::BytesToBuild(uint64_t vertices, uint64_t faces) {
  // What stays is the mesh store's.
  return Mesh::EstimateBuildBytes(vertices, faces) -
         Mesh::EstimateResidentBytes(vertices, faces);
}

std::optional<UploadResult> MeshLibrary::FindBuilt(const std::string& digest,
                                                   const MeshUpload& upload) {
  std::optional<MeshDescription> present = Describe(digest);
  if (!present) return std::nullopt;
  RememberFile(upload, digest);
  return UploadResult{*std::move(present), true};
}

absl::StatusOr<UploadResult> MeshLibrary::Build(TriangleSoup soup,
                                                const std::string& digest,
                                                const MeshUpload& upload,
                                                ByteReservation room,
                                                Checkpoint& checkpoint) {
  absl::StatusOr<std::shared_ptr<const Mesh>> built =
      Mesh::Build(std::move(soup), checkpoint);
  if (absl::Status s = checkpoint.Poll({}); !s.ok()) return s;
  if (!built.ok()) {
    return absl::IsInvalidArgument(built.status())
               ? WithFieldPath(built.status(), "chunk.data")
               : built.status();
  }
  ResidentMesh mesh{digest, *built, Summarize(**built)};
  if (absl::Status s = checkpoint.Poll({}); !s.ok()) return s;
  MeshDescription description = mesh.Describe();
  if (files_ != nullptr) {
    const bool is_file = upload.header().format != UploadFormat::kArrays;
    absl::Status status = files_->Put(
        mesh, is_file ? std::optional(upload.file()) : std::nullopt);
    if (!status.ok()) return status;
    if (const auto stored = files_->Describe(digest)) {
      description.stored_bytes = stored->stored_bytes;
    }
  }
  const bool is_new = Keep(std::move(mesh), std::move(room)).is_new;
  RememberFile(upload, digest);
  ++meshes_built_;
  return UploadResult{std::move(description), !is_new};
}

absl::Status MeshLibrary::Erase(const std::string& digest) {
  if (files_ == nullptr) {
    return store_.Erase(digest) ? absl::OkStatus() : NotResident(digest);
  }
  // The disk first: nobody brings the mesh back from there afterwards.
  absl::Status status = files_->Erase(digest);
  if (status.ok() || absl::IsNotFound(status)) store_.Erase(digest);
  return status;
}

}  // namespace geodesic::server
