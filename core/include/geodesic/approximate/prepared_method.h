// What all approximate methods have in common: something is made of the mesh
// once, and then asked for fields.

#ifndef GEODESIC_APPROXIMATE_PREPARED_METHOD_H_
#define GEODESIC_APPROXIMATE_PREPARED_METHOD_H_

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/checkpoint.h"
#include "geodesic/query.h"
#include "geodesic/valid_query.h"
#include "geodesic_types/algorithms.h"

namespace geodesic {

// Distances that are nearly right, in the unit of the mesh's file. Nothing is
// certified: no method bounds its error.
struct ApproximateField {
  // One per vertex; +infinity exactly where no path from any source leads.
  std::vector<double> distances;
  ApproximateMethod method;
  double solve_seconds = 0;
};

// Errors: INVALID_ARGUMENT naming a source that the method cannot start from: a
// curve, and with heat one that has an offset.
absl::Status CheckSources(ApproximateMethod method,
                          std::span<const Source> sources);
// INVALID_ARGUMENT: the place of this path is no vertex, and no method gives
// the distance of anything else.
absl::Status NoVertex(ApproximateMethod method, const std::string& path);
// Errors: as CheckSources; NoVertex for the first target that is none.
absl::Status CheckPlaces(ApproximateMethod method, const Query& query);

// Immutable: const functions are thread-safe, and many may run at once. The
// mesh that it was made of must outlive it.
class PreparedMethod {
 public:
  virtual ~PreparedMethod() = default;

  // Which method it is.
  virtual ApproximateMethod method() const = 0;

  // The field of the query's sources. The query's algorithm plays no part, and
  // the same arguments give the same bits. `checkpoint` is never told of a
  // settled radius or of distances.
  // Errors: INVALID_ARGUMENT with the path (field_path.h) of what the method
  // cannot do: curves, targets, a trace; each method names what else. Whatever
  // `checkpoint` returns.
  absl::StatusOr<ApproximateField> Distances(const ValidQuery& query,
                                             Checkpoint& checkpoint) const;

  // Bytes held beside the mesh.
  virtual uint64_t bytes() const = 0;

  // The mesh that it was made of.
  const Mesh& mesh() const { return mesh_; }

 protected:
  explicit PreparedMethod(const Mesh& mesh) : mesh_(mesh) {}

 private:
  // ApproximateField::distances.
  virtual absl::StatusOr<std::vector<double>> Compute(
      const ValidQuery& query, Checkpoint& checkpoint) const = 0;

  const Mesh& mesh_;
};

}  // namespace geodesic

#endif  // GEODESIC_APPROXIMATE_PREPARED_METHOD_H_
