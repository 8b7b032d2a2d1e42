#include "server/engine/durable_store.h"

#include <utility>

namespace geodesic::server {

absl::StatusOr<std::unique_ptr<DurableStore>> DurableStore::Open(
    const Options& options) {
  absl::StatusOr<DataFolder> folder = DataFolder::Open(options.path);
  if (!folder.ok()) return folder.status();
  std::unique_ptr<DurableStore> store(new DurableStore(*std::move(folder)));
  auto meshes =
      MeshFiles::Open(store->folder_, options.mesh_bytes, options.warn);
  if (!meshes.ok()) return meshes.status();
  store->meshes_ = *std::move(meshes);
  auto fields = FieldFiles::Open(store->folder_, options.field_bytes,
                                 options.version, options.warn);
  if (!fields.ok()) return fields.status();
  store->fields_ = *std::move(fields);
  return store;
}

}  // namespace geodesic::server
