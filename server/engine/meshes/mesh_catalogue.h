// What a server knows of its meshes, in memory or on disk, and how they are
// named.

#ifndef GEODESIC_SERVER_ENGINE_MESHES_MESH_CATALOGUE_H_
#define GEODESIC_SERVER_ENGINE_MESHES_MESH_CATALOGUE_H_

#include <compare>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/approximate/prepare.h"
#include "geodesic/checkpoint.h"
#include "geodesic/join_seams.h"
#include "geodesic/mesh.h"
#include "geodesic/mesh_summary.h"
#include "geodesic/triangle_soup.h"
#include "geodesic_types/mesh_format.h"
#include "server/locks/mutex.h"

namespace geodesic::server {

// How the bytes of an upload are to be read: as a file, or as the canonical
// arrays themselves.
using UploadFormat = std::optional<MeshFormat>;
inline constexpr UploadFormat kArrays = std::nullopt;

struct UploadHeader {
  UploadFormat format = kArrays;
  uint64_t size_bytes = 0;
  // kArrays only.
  uint64_t vertex_count = 0;
  uint64_t face_count = 0;
  // If not empty, a mesh with another digest is refused.
  std::string expected_digest;
  // Arrays are joined within a distance only.
  Welding welding;
};

// Names a file as the client holds it.
struct FileKey {
  UploadFormat format = kArrays;
  std::string sha256;
  Welding welding = {};

  friend auto operator<=>(const FileKey&, const FileKey&) = default;
};

// Something that an approximate method has made of a mesh.
struct MethodDescription {
  MethodChoice choice;
  uint64_t bytes = 0;
  // To make it, or to load it from disk.
  double prepare_seconds = 0;
};

struct MeshDescription {
  std::string digest;
  MeshSummary summary;
  uint64_t resident_bytes = 0;                  // 0: not in memory
  uint64_t stored_bytes = 0;                    // 0: not on disk
  uint32_t landmarks = 0;                       // in memory
  std::vector<MethodDescription> methods = {};  // prepared, in memory
};

struct ResidentMesh {
  std::string digest;
  std::shared_ptr<const Mesh> mesh;
  MeshSummary summary;

  MeshDescription Describe() const {
    return {.digest = digest,
            .summary = summary,
            .resident_bytes = mesh->resident_bytes()};
  }
};

// The catalogue of a server is its MeshFiles, or its MeshStore if it has no
// data folder. Thread-safe.
class MeshCatalogue {
 public:
  virtual ~MeshCatalogue() = default;

  // Describes the mesh and marks it as used; empty if it is not there.
  virtual std::optional<MeshDescription> Describe(
      const std::string& digest) = 0;
  bool Contains(const std::string& digest) {
    return Describe(digest).has_value();
  }

  // Up to `count` meshes in order of digest, from the first above `after`.
  // Marks nothing as used.
  virtual std::vector<MeshDescription> List(const std::string& after,
                                            size_t count) const = 0;

  // The digest of the mesh that was uploaded as this file.
  std::optional<std::string> FindFile(const FileKey& file) const;

  // Remembers that `file` holds the mesh, for as long as the mesh is kept. Only
  // the latest few files of a mesh are remembered.
  void AddFile(const FileKey& file, const std::string& digest);

  // Drops the mesh; handles to it stay valid.
  // Errors: NOT_FOUND; UNAVAILABLE (it cannot be removed from the disk).
  virtual absl::Status Erase(const std::string& digest) = 0;

  // Whether the meshes outlive the process. If so, the methods below wait for
  // the disk, as Erase does; otherwise they do nothing.
  virtual bool is_durable() const { return false; }

  // Whether a mesh of this size can ever be kept; see BlobStore::Admit.
  virtual absl::Status Admit(uint64_t /*vertices*/, uint64_t /*faces*/) {
    return absl::OkStatus();
  }

  // Returns when the mesh is on the disk for good.
  // Errors: as Admit; RESOURCE_EXHAUSTED (disk or budget full), UNAVAILABLE,
  // both with a retry hint.
  virtual absl::Status Put(const ResidentMesh& /*mesh*/,
                           const std::optional<FileKey>& /*file*/) {
    return absl::OkStatus();
  }

  // Whether the mesh is on the disk; if not, it is forgotten.
  // Errors: NOT_FOUND; UNAVAILABLE, with a retry hint.
  virtual absl::Status Look(const std::string& /*digest*/) {
    return absl::OkStatus();
  }

  // Reads the arrays of `mesh` from disk into memory.
  // Errors: NOT_FOUND (not there, or damaged and set aside), what `checkpoint`
  // says, RESOURCE_EXHAUSTED, UNAVAILABLE (it cannot be read now).
  virtual absl::StatusOr<TriangleSoup> Load(const MeshDescription& mesh,
                                            Checkpoint& checkpoint);

 protected:
  // These call nothing under their lock.
  void RememberFile(const FileKey& file, const std::string& digest);
  void ForgetFiles(const std::string& digest);

 private:
  mutable Mutex files_mutex_;
  // Each is the other's inverse.
  std::map<FileKey, std::string> digest_of_file_ ABSL_GUARDED_BY(files_mutex_);
  std::map<std::string, std::deque<FileKey>> files_of_digest_
      ABSL_GUARDED_BY(files_mutex_);
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESHES_MESH_CATALOGUE_H_
