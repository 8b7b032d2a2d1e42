// Geodesic triangle unfolding: exact distances between some samples, and from
// every vertex to three samples around it. Any distance is then a few triangles
// laid into the plane.
//
//   auto unfolding = TriangleUnfolding::Prepare(*mesh, {}, checkpoint);
//   double distance = (*unfolding)->Distance(0, 99);   // O(1)
//
// After Xin, Ying, He: Constant-time all-pairs geodesic distance query on
// triangle meshes. I3D 2012.

#ifndef GEODESIC_APPROXIMATE_TRIANGLE_UNFOLDING_H_
#define GEODESIC_APPROXIMATE_TRIANGLE_UNFOLDING_H_

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "absl/status/statusor.h"
#include "geodesic/approximate/prepared_method.h"
#include "geodesic/mesh.h"

namespace geodesic {

// Parameters of the method.
struct TriangleUnfoldingOptions {
  // m. Memory is 4 m^2 bytes and 24 a vertex, time m exact fields. In [1,
  // 20000]. DEFAULT: 200.
  uint32_t samples = MethodChoice().samples;
  // How many threads share the fields, in [1, kMostSolveThreads]; the calling
  // thread is one of them. What is made is the same to the bit. DEFAULT: 1.
  uint32_t threads = 1;
};

// Guarantees:
//   1. exact on a convex part of the plane, but for single precision: some 1e-3
//      of a distance where samples lie all but in line with a vertex, since the
//      height of such a triangle is the root of a difference;
//   2. exact between samples, in single precision;
//   3. +infinity exactly where no path leads, 0 from a vertex to itself.
// Distances that are short beside those between samples have the largest
// errors.
//
// Sources are points, with offsets; one that is no vertex starts from the
// corners around it.
class TriangleUnfolding final : public PreparedMethod {
 public:
  // Farthest-point samples, their fields and each vertex' triangle.
  // Errors: INVALID_ARGUMENT for an option out of range, or fewer samples than
  // components; as Solve; whatever `checkpoint` returns.
  static absl::StatusOr<std::shared_ptr<const TriangleUnfolding>> Prepare(
      const Mesh& mesh, const TriangleUnfoldingOptions& options,
      Checkpoint& checkpoint);

  // Errors: INVALID_ARGUMENT naming an option out of range (field_path.h).
  static absl::Status Check(const TriangleUnfoldingOptions& options);

  ApproximateMethod method() const override;
  uint64_t bytes() const override;

  // In the unit of the file. O(1). REQUIRES: the vertices are of the mesh.
  double Distance(uint32_t from, uint32_t to) const;

  // How many samples there are.
  uint32_t sample_count() const { return sample_count_; }

 private:
  // O(n) a source.
  absl::StatusOr<std::vector<double>> Compute(
      const ValidQuery& query, Checkpoint& checkpoint) const override;

  class Builder;

  static constexpr uint32_t kNone = 0xffffffffu;
  // The samples around a vertex, and how far they are; kNone where there are
  // not so many.
  struct Corners {
    std::array<uint32_t, 3> samples = {kNone, kNone, kNone};
    std::array<float, 3> distances = {};
  };

  explicit TriangleUnfolding(const Mesh& mesh) : PreparedMethod(mesh) {}

  float Between(uint32_t sample, uint32_t other) const {
    return between_[uint64_t{sample} * sample_count_ + other];
  }
  // From the vertex of `around` to a place that is so far from its corners.
  double Unfold(const Corners& around, const std::array<double, 3>& to) const;
  // In the scaled unit.
  double ScaledDistance(uint32_t from, uint32_t to) const;

  uint32_t sample_count_ = 0;
  std::vector<float> between_;    // samples x samples, in the scaled unit
  std::vector<Corners> corners_;  // by vertex
};

}  // namespace geodesic

#endif  // GEODESIC_APPROXIMATE_TRIANGLE_UNFOLDING_H_
