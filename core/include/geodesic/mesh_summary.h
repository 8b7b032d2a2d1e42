// Facts about a mesh that people ask for before they query it.

#ifndef GEODESIC_MESH_SUMMARY_H_
#define GEODESIC_MESH_SUMMARY_H_

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/mesh.h"
#include "geodesic_types/mesh_summary.h"

namespace geodesic {

// O(V + F). Thread-safe.
MeshSummary Summarize(const Mesh& mesh);
// The same; asks the checkpoint every few milliseconds. Errors: as
// `checkpoint`.
absl::StatusOr<MeshSummary> Summarize(const Mesh& mesh, Checkpoint& checkpoint);

// The part of the summary that Notes tells of: O(F), and less than a part of
// building the mesh.
MeshSummary SummarizeReading(const Mesh& mesh);

// What a user of the mesh has to know: what was joined, left out or guessed,
// and what looks as if it should have been joined. A sentence each, without an
// end, e.g. "joined 646 seam edges". Empty for most meshes.
std::vector<std::string> Notes(const MeshSummary& summary);

}  // namespace geodesic

#endif  // GEODESIC_MESH_SUMMARY_H_
