#include "server/engine/fields/derived_quantities.h"

#include <utility>

#include "geodesic/field_path.h"
#include "geodesic/field_quantities.h"

namespace geodesic::server {
namespace {

// Moves the value out, or passes the error on.
template <typename T>
absl::Status Assign(absl::StatusOr<T> from, T& to) {
  if (!from.ok()) return from.status();
  to = *std::move(from);
  return absl::OkStatus();
}

}  // namespace

uint64_t DerivedBytes(const FieldExtras& extras, uint64_t vertices) {
  if (!extras.NeedTrace()) return 0;
  uint64_t per_vertex = 0;
  if (extras.nearest_sources) per_vertex += sizeof(uint32_t);
  if (extras.gradients) per_vertex += sizeof(Point);
  if (extras.log_map) per_vertex += sizeof(LogMap::coordinates[0]);
  return vertices * per_vertex + sizeof(DerivedQuantities);
}

absl::StatusOr<std::shared_ptr<const DerivedQuantities>> Derive(
    const MeshHandle& mesh, const ValidQuery& query, const FieldHandle& field,
    const FieldExtras& extras, double radius, ByteReservation memory) {
  auto derived = std::make_shared<DerivedQuantities>();
  derived->memory = std::move(memory);
  derived->mesh = mesh;
  derived->field = field;
  absl::Status status;
  if (extras.nearest_sources) {
    status = Assign(NearestSources(*mesh->mesh, query, *field),
                    derived->nearest_sources);
  }
  if (status.ok() && extras.gradients) {
    status = Assign(Gradients(*mesh->mesh, query, *field), derived->gradients);
  }
  if (status.ok() && extras.log_map) {
    status = Assign(ComputeLogMap(*mesh->mesh, query, *field, radius),
                    derived->log_map);
    if (absl::IsInvalidArgument(status))
      status = WithFieldPath(status, "source");
  }
  if (status.ok() && extras.paths) {
    absl::StatusOr<PathTracer> paths =
        PathTracer::Create(*mesh->mesh, query, *field);
    if (!paths.ok()) return paths.status();
    derived->paths = *std::move(paths);
  }
  if (!status.ok()) return status;
  return derived;
}

}  // namespace geodesic::server
