#include "server/engine/meshes/mesh_library.h"

#include <algorithm>
#include <stop_token>
#include <utility>

#include "absl/strings/str_cat.h"
#include "digest/sha256.h"
#include "geodesic_types/field_path.h"
#include "server/engine/base/argument_checks.h"
#include "server/engine/base/status_details.h"
#include "server/engine/meshes/mesh_digest.h"

namespace geodesic::server {
namespace {

constexpr size_t kMaxDigestsPerRequest = 1000;
constexpr int kDefaultPageSize = 100;
constexpr int kMaxPageSize = 1000;

// The upload memory that a build takes beside its arrays. The mesh itself is
// charged to the mesh store.
uint64_t BytesToBuild(uint64_t vertices, uint64_t faces) {
  return Mesh::EstimateBuildBytes(vertices, faces) -
         Mesh::EstimateResidentBytes(vertices, faces);
}

// The upload memory for a mesh that is built from its arrays.
uint64_t BytesFromArrays(uint64_t vertices, uint64_t faces) {
  return vertices * sizeof(Point) + faces * sizeof(Triangle) +
         BytesToBuild(vertices, faces);
}

}  // namespace

MeshLibrary::MeshLibrary(const Limits& limits, const Clock& clock,
                         Scheduler& scheduler,
                         std::shared_ptr<ByteBudget> upload_memory,
                         std::function<void(const std::string&)> removed)
    : limits_(limits),
      scheduler_(scheduler),
      upload_memory_(std::move(upload_memory)),
      removed_(std::move(removed)),
      landmarks_(limits.landmark_memory_bytes),
      methods_(limits.prepared_memory_bytes),
      store_(limits.mesh_store_bytes,
             [this](const std::string& digest) {
               landmarks_.Erase(digest);
               methods_.EraseMesh(digest);
             }),
      uploads_(scheduler, clock, limits.progress_interval),
      loads_(scheduler, clock, limits.progress_interval) {}

void MeshLibrary::Attach(MeshFiles& files) {
  catalogue_ = &files;
  files.SetRemoved([this](const std::string& digest) {
    (void)store_.Erase(digest);
    removed_(digest);
  });
}

MeshHandle MeshLibrary::FindResident(const std::string& digest) {
  MeshHandle mesh = store_.Find(digest);
  // Marks the mesh as used on disk, too.
  if (mesh != nullptr) catalogue_->Contains(digest);
  return mesh;
}

std::optional<MeshDescription> MeshLibrary::Find(const std::string& digest) {
  const MeshHandle resident = store_.Find(digest);
  std::optional<MeshDescription> mesh = catalogue_->Describe(digest);
  if (mesh && resident != nullptr) {
    DescribeMemory(resident->mesh->resident_bytes(), *mesh);
  }
  return mesh;
}

void MeshLibrary::DescribeMemory(uint64_t resident_bytes,
                                 MeshDescription& mesh) const {
  mesh.resident_bytes = resident_bytes;
  mesh.landmarks = landmarks_.CountOf(mesh.digest);
  mesh.methods = methods_.Describe(mesh.digest);
}

std::optional<std::string> MeshLibrary::FindFile(const FileKey& file) {
  std::optional<std::string> digest = catalogue_->FindFile(file);
  return digest && catalogue_->Contains(*digest) ? digest : std::nullopt;
}

absl::StatusOr<MissingMeshes> MeshLibrary::FindMissing(
    const std::vector<std::string>& mesh_digests,
    const std::vector<FileKey>& files) {
  if (mesh_digests.size() + files.size() > kMaxDigestsPerRequest) {
    return InvalidField(
        "mesh_digests",
        absl::StrCat("mesh_digests and files have ",
                     mesh_digests.size() + files.size(),
                     " items together; at most ", kMaxDigestsPerRequest,
                     " are answered at once"));
  }
  MissingMeshes missing;
  for (size_t i = 0; i < mesh_digests.size(); ++i) {
    absl::Status status =
        CheckDigest(absl::StrCat("mesh_digests[", i, "]"), mesh_digests[i]);
    if (!status.ok()) return status;
    // Marks the mesh as used: the client's next request is likely to find it.
    if (!catalogue_->Contains(mesh_digests[i])) {
      missing.mesh_digests.push_back(mesh_digests[i]);
    }
  }
  for (size_t i = 0; i < files.size(); ++i) {
    absl::Status status =
        CheckDigest(absl::StrCat("files[", i, "].sha256"), files[i].sha256);
    if (!status.ok()) return status;
    if (const auto digest = FindFile(files[i])) {
      missing.known_files.push_back({files[i], *digest});
    } else {
      missing.files.push_back(files[i]);
    }
  }
  return missing;
}

absl::StatusOr<MeshHandle> MeshLibrary::Get(const std::string& digest,
                                            std::string_view field) {
  if (absl::Status status = CheckDigest(field, digest); !status.ok()) {
    return status;
  }
  MeshHandle mesh = FindResident(digest);
  if (mesh == nullptr) return NotResident(digest);
  return mesh;
}

absl::StatusOr<MeshDescription> MeshLibrary::Describe(
    const std::string& digest) {
  if (absl::Status status = CheckDigest("digest", digest); !status.ok()) {
    return status;
  }
  if (std::optional<MeshDescription> mesh = Find(digest)) {
    return *std::move(mesh);
  }
  // The disk could not take it (Fetch).
  const MeshHandle resident = store_.Find(digest);
  if (resident == nullptr) return NotResident(digest);
  MeshDescription mesh = resident->Describe();
  DescribeMemory(mesh.resident_bytes, mesh);
  return mesh;
}

absl::StatusOr<MeshPage> MeshLibrary::List(int page_size,
                                           const std::string& token) {
  if (page_size < 0) {
    return InvalidField("page_size", absl::StrCat("page_size is ", page_size,
                                                  "; it must not be negative"));
  }
  // A token is the last digest of the page before.
  if (!token.empty() && !IsSha256Hex(token)) {
    return InvalidField("page_token",
                        "page_token is none that this server gave out");
  }
  const size_t count =
      page_size == 0 ? kDefaultPageSize : std::min(page_size, kMaxPageSize);
  MeshPage page{.meshes = catalogue_->List(token, count + 1)};
  std::vector<MeshDescription>& meshes = page.meshes;
  for (const MeshDescription& resident : store_.List(token, count + 1)) {
    const auto mesh = std::ranges::lower_bound(meshes, resident.digest, {},
                                               &MeshDescription::digest);
    if (mesh != meshes.end() && mesh->digest == resident.digest) {
      DescribeMemory(resident.resident_bytes, *mesh);
    }
  }
  if (meshes.size() > count) {
    meshes.pop_back();
    page.next_token = meshes.back().digest;
  }
  return page;
}

absl::Status MeshLibrary::Delete(const std::string& digest,
                                 std::function<void(const absl::Status&)> done,
                                 const std::string& client) {
  if (absl::Status status = CheckDigest("digest", digest); !status.ok()) {
    return status;
  }
  if (!catalogue_->is_durable()) {
    done(Erase(digest));
    return absl::OkStatus();
  }
  Job job{.priority = JobPriority::kBuild,
          .client = client,
          .waits_for_disk = [] { return true; },
          .abandon = done};
  job.run = [this, digest, done = std::move(done)](const std::stop_token&) {
    done(Guarded("deleted a mesh", [&] { return Erase(digest); }));
  };
  return scheduler_.Submit(std::move(job)).status();
}

absl::Status MeshLibrary::Erase(const std::string& digest) {
  // The disk goes first, so the mesh cannot be loaded again from there.
  absl::Status status = catalogue_->Erase(digest);
  if (status.ok() || absl::IsNotFound(status)) {
    // Memory may have one that the disk could not take (Fetch).
    const bool was_resident = store_.Erase(digest).ok();
    removed_(digest);
    if (was_resident) return absl::OkStatus();
  }
  return status;
}

MeshStore::Inserted MeshLibrary::Keep(ResidentMesh mesh, ByteReservation room) {
  const std::string digest = mesh.digest;
  MeshStore::Inserted kept = store_.Insert(std::move(mesh), std::move(room));
  // An Erase before this moment found nothing in memory; a later one will.
  if (!catalogue_->Contains(digest)) {
    (void)store_.Erase(digest);
    kept.value = nullptr;
  }
  return kept;
}

absl::Status MeshLibrary::CheckMemory(uint64_t vertices, uint64_t faces) const {
  absl::Status status =
      upload_memory_->CheckCapacity(BytesFromArrays(vertices, faces));
  return status.ok() ? store_.CheckCapacity(vertices, faces) : status;
}

absl::Status MeshLibrary::CheckCapacity(uint64_t vertices,
                                        uint64_t faces) const {
  absl::Status status = CheckMemory(vertices, faces);
  return status.ok() ? catalogue_->Admit(vertices, faces) : status;
}

absl::StatusOr<std::unique_ptr<MeshUpload>> MeshLibrary::StartUpload(
    UploadHeader header) {
  if (scheduler_.is_draining()) return ShuttingDown();
  absl::StatusOr<std::unique_ptr<MeshUpload>> upload =
      MeshUpload::Start(std::move(header), limits_, upload_memory_);
  if (!upload.ok()) return upload;
  const UploadHeader& started = (*upload)->header();
  absl::Status fits =
      upload_memory_->CheckCapacity(MeshUpload::BytesToParse(started));
  if (fits.ok() && started.format == kArrays) {
    fits = CheckCapacity(started.vertex_count, started.face_count);
  }
  if (!fits.ok()) return fits;
  return upload;
}

absl::StatusOr<UploadJobs::Ticket> MeshLibrary::FinishUpload(
    std::unique_ptr<MeshUpload> upload, UploadCallback done,
    const std::string& client, std::function<void(const UploadResult&)> built) {
  if (absl::Status status = upload->Finish(); !status.ok()) return status;
  auto build = std::make_shared<MeshBuild>();
  if (std::optional<UploadResult> known = FindUploaded(*upload)) {
    if (!catalogue_->is_durable()) {
      upload.reset();
      built = nullptr;  // the client's next request may come before the return
      done(*std::move(known));
      return UploadJobs::Ticket();
    }
    build->known = known->mesh.digest;
  }
  build->upload = std::move(upload);
  return uploads_.Join(
      next_upload_++, {.done = std::move(done)}, JobPriority::kBuild, [&] {
        return SharedWork<UploadResult>{
            .client = client,
            .reserve = [this, build] { return Reserve(*build); },
            .run =
                [this, build,
                 built = std::move(built)](JobCheckpoint& checkpoint) {
                  auto result = Run(*build, checkpoint);
                  if (built && result.ok() && result->has_value())
                    built(**result);
                  return result;
                },
            .waits_for_disk =
                [this, build] {
                  return catalogue_->is_durable() &&
                         (build->built.has_value() || !build->known.empty());
                }};
      });
}

std::optional<UploadResult> MeshLibrary::FindUploaded(
    const MeshUpload& upload) {
  const std::optional<std::string> digest =
      upload.file() ? FindFile(*upload.file()) : std::nullopt;
  const std::string& expected = upload.header().expected_digest;
  if (!digest || (!expected.empty() && expected != *digest)) {
    return std::nullopt;
  }
  std::optional<MeshDescription> mesh = Find(*digest);
  if (!mesh) return std::nullopt;
  return UploadResult{*std::move(mesh), true};
}

absl::Status MeshLibrary::Reserve(MeshBuild& build) {
  if (build.built.has_value() || !build.known.empty()) return absl::OkStatus();
  return build.upload->is_parsed() ? ReserveForMesh(build)
                                   : build.upload->ReserveForParse();
}

absl::Status MeshLibrary::ReserveForMesh(MeshBuild& build) {
  const uint64_t vertices = build.upload->soup().positions.size();
  const uint64_t faces = build.upload->soup().triangles.size();
  ByteReservation& memory = build.upload->memory();
  const uint64_t held = memory.bytes();
  absl::Status status = memory.GrowTo(held + BytesToBuild(vertices, faces));
  if (!status.ok()) return status;
  absl::StatusOr<ByteReservation> room = store_.Reserve(vertices, faces);
  if (!room.ok()) {
    // A waiting job must not hold memory that it does not use yet.
    memory.ShrinkTo(held);
    return room.status();
  }
  build.room = *std::move(room);
  return absl::OkStatus();
}

absl::StatusOr<std::optional<UploadResult>> MeshLibrary::Run(
    MeshBuild& build, Checkpoint& checkpoint) {
  MeshUpload& upload = *build.upload;
  if (build.built.has_value()) return Keep(build);
  if (!build.known.empty()) return FindKnown(build);
  if (upload.is_parsed()) return Build(build, checkpoint);
  const absl::StatusOr<bool> is_parsed = upload.Parse(checkpoint);
  if (!is_parsed.ok()) return is_parsed.status();
  if (!*is_parsed) return std::nullopt;
  if (catalogue_->Contains(upload.digest())) {
    build.known = upload.digest();
    if (catalogue_->is_durable()) return std::nullopt;
    return FindKnown(build);
  }
  absl::Status fits = CheckCapacity(upload.soup().positions.size(),
                                    upload.soup().triangles.size());
  if (!fits.ok()) return fits;
  // Usually the memory is available, and the job need not wait again.
  if (!ReserveForMesh(build).ok()) return std::nullopt;
  return Build(build, checkpoint);
}

absl::StatusOr<std::optional<UploadResult>> MeshLibrary::FindKnown(
    MeshBuild& build) {
  const std::string digest = std::exchange(build.known, {});
  const absl::Status status = catalogue_->Look(digest);
  if (!status.ok() && !absl::IsNotFound(status)) return status;
  std::optional<MeshDescription> mesh = Find(digest);
  MeshUpload& upload = *build.upload;
  if (status.ok() && mesh.has_value()) {
    if (upload.is_parsed()) AddFile(upload);
    return UploadResult{*std::move(mesh), true};
  }
  if (!upload.is_parsed()) return std::nullopt;
  absl::Status fits = CheckCapacity(upload.soup().positions.size(),
                                    upload.soup().triangles.size());
  if (!fits.ok()) return fits;
  return std::nullopt;
}

absl::StatusOr<std::optional<UploadResult>> MeshLibrary::Build(
    MeshBuild& build, Checkpoint& checkpoint) {
  MeshUpload& upload = *build.upload;
  absl::StatusOr<std::shared_ptr<const Mesh>> built =
      Mesh::Build(std::move(upload.soup()), checkpoint);
  if (absl::Status s = checkpoint.Poll({}); !s.ok()) return s;
  if (!built.ok()) {
    return absl::IsInvalidArgument(built.status())
               ? WithFieldPath(built.status(), "chunk.data")
               : built.status();
  }
  absl::StatusOr<MeshSummary> summary = Summarize(**built, checkpoint);
  if (!summary.ok()) return summary.status();
  build.built = {upload.digest(), *built, *std::move(summary)};
  // What the build took beside the mesh.
  upload.memory().ShrinkTo(0);
  if (catalogue_->is_durable()) return std::nullopt;
  return Keep(build);
}

absl::StatusOr<UploadResult> MeshLibrary::Keep(MeshBuild& build) {
  const MeshUpload& upload = *build.upload;
  ResidentMesh& mesh = *build.built;
  if (absl::Status s = catalogue_->Put(mesh, upload.file()); !s.ok()) return s;
  MeshDescription description = mesh.Describe();
  if (const auto stored = catalogue_->Describe(mesh.digest)) {
    description.stored_bytes = stored->stored_bytes;
  }
  const MeshStore::Inserted kept = Keep(std::move(mesh), std::move(build.room));
  AddFile(upload);
  ++meshes_built_;
  if (shared_ != nullptr && kept.value != nullptr) shared_->Put(*kept.value);
  return UploadResult{std::move(description), !kept.is_new};
}

void MeshLibrary::AddFile(const MeshUpload& upload) {
  if (upload.file()) catalogue_->AddFile(*upload.file(), upload.digest());
}

absl::StatusOr<MeshLoads::Ticket> MeshLibrary::Await(
    const std::string& digest, MeshCallback done, const std::string& client) {
  if (MeshHandle mesh = FindResident(digest)) {
    done(std::move(mesh));
    return MeshLoads::Ticket();
  }
  if (const std::optional<MeshDescription> mesh = Find(digest)) {
    absl::Status status =
        CheckMemory(mesh->summary.vertices, mesh->summary.faces);
    if (!status.ok()) return status;
  } else if (shared_ == nullptr) {
    return NotResident(digest);
  }
  auto load = std::make_shared<MeshLoad>(MeshLoad{.digest = digest});
  return loads_.Join(
      digest, {.done = std::move(done)}, JobPriority::kBuild, [&] {
        return SharedWork<MeshHandle>{
            .client = client,
            .reserve = [this, load] { return Reserve(*load); },
            .run =
                [this, load](JobCheckpoint& checkpoint) {
                  return Run(*load, checkpoint);
                },
            .waits_for_disk = [this, load] { return WaitsForDisk(*load); }};
      });
}

bool MeshLibrary::WaitsForDisk(const MeshLoad& load) const {
  if (!catalogue_->is_durable() || load.read.has_value()) return false;
  return load.fetched.has_value() ||
         catalogue_->Describe(load.digest).has_value();
}

absl::Status MeshLibrary::Reserve(MeshLoad& load) {
  if (load.has_begun()) return absl::OkStatus();
  load.mesh = FindResident(load.digest);
  if (load.mesh != nullptr) return absl::OkStatus();
  if (const auto mesh = catalogue_->Describe(load.digest)) {
    return Reserve(load, mesh->summary.vertices, mesh->summary.faces);
  }
  if (shared_ == nullptr) return NotResident(load.digest);
  // To ask for it takes no memory.
  if (!load.found.has_value()) return absl::OkStatus();
  return Reserve(load, load.found->vertices, load.found->faces);
}

absl::Status MeshLibrary::Reserve(MeshLoad& load, uint64_t vertices,
                                  uint64_t faces) {
  absl::StatusOr<ByteReservation> arrays =
      ByteReservation::Make(upload_memory_, BytesFromArrays(vertices, faces));
  if (!arrays.ok()) return arrays.status();
  absl::StatusOr<ByteReservation> room = store_.Reserve(vertices, faces);
  if (!room.ok()) return room.status();
  load.arrays = *std::move(arrays);
  load.room = *std::move(room);
  return absl::OkStatus();
}

absl::StatusOr<std::optional<MeshHandle>> MeshLibrary::Run(
    MeshLoad& load, Checkpoint& checkpoint) {
  if (load.mesh != nullptr) return std::move(load.mesh);
  if (load.fetched.has_value()) return KeepFetched(load);
  if (load.found.has_value()) {
    absl::StatusOr<ResidentMesh> mesh = Fetch(load, checkpoint);
    if (!mesh.ok()) return mesh.status();
    load.fetched = *std::move(mesh);
    load.arrays = {};
    return std::nullopt;
  }
  if (const auto mesh = catalogue_->Describe(load.digest)) {
    // It may have come to the disk after Reserve.
    if (load.arrays.bytes() == 0) return std::nullopt;
    if (load.read.has_value()) return BuildRead(load, *mesh, checkpoint);
    absl::StatusOr<TriangleSoup> soup = catalogue_->Load(*mesh, checkpoint);
    if (!soup.ok()) return soup.status();
    load.read = *std::move(soup);
    return std::nullopt;
  }
  if (shared_ == nullptr) return NotResident(load.digest);
  if (absl::Status s = FindShared(load); !s.ok()) return s;
  return std::nullopt;
}

absl::Status MeshLibrary::FindShared(MeshLoad& load) {
  std::optional<SharedMesh> found = shared_->Find(load.digest);
  if (!found) return NotResident(load.digest);
  const std::string who =
      absl::StrCat("mesh ", load.digest, " of the shared tier has");
  absl::Status fits = CheckCount("vertices", found->vertices, "max_vertices",
                                 limits_.max_vertices, who);
  fits.Update(
      CheckCount("faces", found->faces, "max_faces", limits_.max_faces, who));
  // Larger counts would overflow there.
  if (fits.ok()) fits = CheckCapacity(found->vertices, found->faces);
  if (fits.ok()) load.found = std::move(found);
  return fits;
}

absl::StatusOr<MeshHandle> MeshLibrary::BuildRead(MeshLoad& load,
                                                  const MeshDescription& mesh,
                                                  Checkpoint& checkpoint) {
  absl::StatusOr<std::shared_ptr<const Mesh>> built =
      Mesh::Build(*std::move(load.read), checkpoint);
  if (absl::IsInvalidArgument(built.status())) {
    // It was built from the same bytes before, so this is a defect.
    return absl::InternalError(absl::StrCat(
        "mesh ", load.digest, " cannot be built: ", built.status().message()));
  }
  if (!built.ok()) return built.status();
  MeshHandle kept =
      Keep({load.digest, *std::move(built), mesh.summary}, std::move(load.room))
          .value;
  if (kept == nullptr) return NotResident(load.digest);
  ++meshes_loaded_;
  return kept;
}

absl::StatusOr<ResidentMesh> MeshLibrary::Fetch(MeshLoad& load,
                                                Checkpoint& checkpoint) {
  absl::StatusOr<TriangleSoup> soup = shared_->Read(*load.found, checkpoint);
  // Whoever has the mesh may send it again.
  if (absl::IsNotFound(soup.status())) return NotResident(load.digest);
  if (!soup.ok()) return soup.status();
  if (MeshDigest(*soup) != load.digest) return NotResident(load.digest);
  absl::StatusOr<std::shared_ptr<const Mesh>> built =
      Mesh::Build(*std::move(soup), checkpoint);
  if (absl::IsInvalidArgument(built.status())) return NotResident(load.digest);
  if (!built.ok()) return built.status();
  absl::StatusOr<MeshSummary> summary = Summarize(**built, checkpoint);
  if (!summary.ok()) return summary.status();
  return ResidentMesh{load.digest, *built, *std::move(summary)};
}

absl::StatusOr<MeshHandle> MeshLibrary::KeepFetched(MeshLoad& load) {
  ResidentMesh& mesh = *load.fetched;
  // A disk that is full or fails keeps nobody from an answer: the tier has the
  // mesh, and here it stays in memory alone.
  const bool is_stored = catalogue_->Put(mesh, std::nullopt).ok();
  MeshHandle kept =
      is_stored ? Keep(std::move(mesh), std::move(load.room)).value
                : store_.Insert(std::move(mesh), std::move(load.room)).value;
  if (kept == nullptr) return NotResident(load.digest);
  ++meshes_fetched_;
  return kept;
}

}  // namespace geodesic::server
