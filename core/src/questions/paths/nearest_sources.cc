#include <cstdint>
#include <vector>

#include "absl/status/status.h"
#include "geodesic/field_quantities.h"
#include "questions/paths/traced_field.h"

namespace geodesic {

absl::StatusOr<std::vector<uint32_t>> NearestSources(
    const Mesh& mesh, const ValidQuery& query, const DistanceField& field) {
  absl::StatusOr<TracedField> traced = TracedField::Create(mesh, query, field);
  if (!traced.ok()) return traced.status();
  std::vector<uint32_t> labels(mesh.vertex_count(), kNoSource);
  std::vector<uint32_t> chain;
  for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    // From pseudo-source to pseudo-source, up to a label or an anchor.
    uint32_t at = v;
    chain.clear();
    while (traced->IsVertex(at) && labels[at] == kNoSource) {
      if (chain.size() == mesh.vertex_count()) {
        return absl::InternalError("the trace leads in circles");
      }
      chain.push_back(at);
      at = traced->VertexArrival(at).pseudo_source;
    }
    if (at == kNoPseudoSource) continue;
    const uint32_t label =
        traced->IsVertex(at) ? labels[at] : traced->AnchorOf(at).source;
    for (const uint32_t passed : chain) labels[passed] = label;
  }
  return labels;
}

}  // namespace geodesic
