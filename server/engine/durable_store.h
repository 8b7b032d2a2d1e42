// What a server keeps in its data folder: meshes for good, fields within a
// budget.

#ifndef GEODESIC_SERVER_ENGINE_DURABLE_STORE_H_
#define GEODESIC_SERVER_ENGINE_DURABLE_STORE_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "server/engine/fields/field_files.h"
#include "server/engine/meshes/mesh_files.h"
#include "server/store/data_folder.h"
#include "server/store/quarantine.h"

namespace geodesic::server {

class DurableStore {
 public:
  struct Options {
    std::string path;
    // Bytes of disk.
    uint64_t mesh_bytes = 0;
    uint64_t field_bytes = 0;
    // Of the program; see FieldFiles.
    std::string version;
    // Hears, in a line for people, of damaged files.
    std::function<void(const std::string& line)> warn;
  };

  // Takes possession of the folder and reads what is in it.
  // Errors: as DataFolder::Open and BlobStore::Open.
  static absl::StatusOr<std::unique_ptr<DurableStore>> Open(
      const Options& options);

  MeshFiles& meshes() { return *meshes_; }
  FieldFiles& fields() { return *fields_; }
  const MeshFiles& meshes() const { return *meshes_; }
  const FieldFiles& fields() const { return *fields_; }
  const Quarantine& quarantine() const { return folder_.quarantine(); }

 private:
  explicit DurableStore(DataFolder folder) : folder_(std::move(folder)) {}

  DataFolder folder_;
  std::unique_ptr<MeshFiles> meshes_;
  std::unique_ptr<FieldFiles> fields_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_DURABLE_STORE_H_
