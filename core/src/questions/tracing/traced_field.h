// A field with a trace, and the query that it answers, ready for following
// shortest paths back.

#ifndef GEODESIC_QUESTIONS_TRACING_TRACED_FIELD_H_
#define GEODESIC_QUESTIONS_TRACING_TRACED_FIELD_H_

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/distance_field.h"
#include "geodesic/mesh.h"
#include "geodesic/surface_point.h"
#include "geodesic/valid_query.h"
#include "surface/anchors.h"

namespace geodesic {

// A point that shortest paths end at.
struct PathEnd {
  SurfacePoint point;
  double distance = 0;  // in the mesh's scaled unit
  Arrival arrival;
};

// Where a field lies: its distances times 2^-exponent are in the scaled unit.
struct TracedDistances {
  std::span<const double> vertices, targets;
  std::span<const Arrival> vertex_arrivals, target_arrivals;
  int exponent = 0;
};

// Refers to the mesh and the distances. Thread-safe.
class TracedField {
 public:
  // Errors: INVALID_ARGUMENT: a field without trace, or of another mesh or
  // another query.
  static absl::StatusOr<TracedField> Create(const Mesh& mesh,
                                            const ValidQuery& query,
                                            const DistanceField& field);
  // REQUIRES: they are those of a computation of this query on this mesh.
  TracedField(const Mesh& mesh, const ValidQuery& query,
              const TracedDistances& distances)
      : mesh_(&mesh),
        query_(query),
        distances_(distances),
        anchors_(AnchorsOf(query)),
        rounding_(Scaled(std::numeric_limits<double>::denorm_min())) {}

  const Mesh& mesh() const { return *mesh_; }
  const TracedDistances& distances() const { return distances_; }
  const std::vector<SurfacePoint>& targets() const { return query_->targets; }

  // In the scaled unit; +infinity if no path leads there.
  double VertexDistance(uint32_t v) const {
    return Scaled(distances_.vertices[v]);
  }
  const Arrival& VertexArrival(uint32_t v) const {
    return distances_.vertex_arrivals[v];
  }
  PathEnd Vertex(uint32_t v) const {
    return {VertexPoint{v}, VertexDistance(v), VertexArrival(v)};
  }
  PathEnd Target(uint32_t t) const {
    return {targets()[t], Scaled(distances_.targets[t]),
            distances_.target_arrivals[t]};
  }

  // Whether a pseudo-source is a vertex; otherwise it is an anchor.
  bool IsVertex(uint32_t pseudo_source) const {
    return pseudo_source < mesh_->vertex_count();
  }
  // The anchor that a pseudo-source is.
  // REQUIRES: !IsVertex(pseudo_source) and it is not kNoPseudoSource.
  const Anchor& AnchorOf(uint32_t pseudo_source) const {
    return anchors_[pseudo_source - mesh_->vertex_count()];
  }

  // One rounding of a distance of the field, which only a mesh of subnormal
  // size can tell from 0.
  double rounding() const { return rounding_; }

 private:
  double Scaled(double distance) const;

  const Mesh* mesh_;
  ValidQuery query_;
  TracedDistances distances_;
  std::vector<Anchor> anchors_;
  double rounding_;
};

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_TRACING_TRACED_FIELD_H_
