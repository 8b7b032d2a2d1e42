// What approximate methods have prepared of meshes in memory. Whatever is
// dropped here can be made again.

#ifndef GEODESIC_SERVER_ENGINE_MESHES_METHOD_STORE_H_
#define GEODESIC_SERVER_ENGINE_MESHES_METHOD_STORE_H_

#include <compare>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/approximate/prepare.h"
#include "geodesic/rows/rows.h"
#include "geodesic_types/algorithms.h"
#include "server/engine/base/lru_store.h"
#include "server/engine/meshes/mesh_catalogue.h"
#include "server/engine/meshes/mesh_store.h"

namespace geodesic::server {

// A method that can be asked. Pins what was prepared, and the mesh that it was
// made of.
struct MethodHandle {
  MeshHandle mesh;
  MethodChoice choice;
  // Null: not prepared yet (CheckPrepared).
  std::shared_ptr<const PreparedMethod> method;
  double prepare_seconds = 0;
};

// What a good question is answered if its method has still to be prepared; OK
// if it has none. IsNotPrepared tells this error from all others.
absl::Status CheckPrepared(const std::optional<MethodHandle>& method);
bool IsNotPrepared(const absl::Status& status);

// As the rows of a question take it (geodesic/rows/rows.h).
std::optional<RowMethod> RowMethodOf(const std::optional<MethodHandle>& method);

// Thread-safe. See LruStore for what is kept and what is evicted.
class MethodStore {
 public:
  explicit MethodStore(uint64_t capacity)
      : methods_("prepared memory", capacity) {}

  // Marks it as used.
  std::optional<MethodHandle> Find(const MeshHandle& mesh,
                                   const MethodChoice& choice);

  // Makes room, if it can ever be had, and keeps what `made` holds, or what is
  // there already. Returns a handle to it.
  // Errors: RESOURCE_EXHAUSTED naming the budget and the need.
  absl::StatusOr<MethodHandle> Insert(const MethodHandle& made);

  void EraseMesh(const std::string& digest);

  // All that a mesh has, in the order of the methods.
  std::vector<MethodDescription> Describe(const std::string& digest) const;

  size_t size() const { return methods_.size(); }
  uint64_t used_bytes() const { return methods_.used_bytes(); }
  uint64_t evictions() const { return methods_.evictions(); }

 private:
  struct Key {
    std::string mesh_digest;
    MethodChoice choice;

    friend auto operator<=>(const Key&, const Key&) = default;
  };
  // Does not pin the mesh, which would never be evicted then.
  struct Kept {
    MethodDescription description;
    std::weak_ptr<const ResidentMesh> mesh;
    std::shared_ptr<const PreparedMethod> method;
  };
  using Methods = LruStore<Key, Kept>;

  // What asks `kept`, and pins it.
  static MethodHandle ToHandle(const MeshHandle& mesh,
                               const Methods::Handle& kept);

  Methods methods_;
};

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_ENGINE_MESHES_METHOD_STORE_H_
