#include "geodesic/approximate/prepare.h"

#include "absl/status/status.h"
#include "geodesic/approximate/fast_marching.h"

namespace geodesic {

absl::StatusOr<std::shared_ptr<const PreparedMethod>> PrepareMethod(
    const Mesh& mesh, ApproximateMethod method, const MethodOptions& options,
    Checkpoint& checkpoint) {
  switch (method) {
    case ApproximateMethod::kFmm:
      return FastMarching::Prepare(mesh, MarchingQueue::kHeap, checkpoint);
    case ApproximateMethod::kFmmUntidy:
      return FastMarching::Prepare(mesh, MarchingQueue::kUntidy, checkpoint);
    case ApproximateMethod::kHeat:
      return HeatMethod::Prepare(mesh, options.heat, checkpoint);
    case ApproximateMethod::kSvg:
      return SaddleVertexGraph::Prepare(mesh, options.svg, checkpoint);
    case ApproximateMethod::kGtu:
      return TriangleUnfolding::Prepare(mesh, options.gtu, checkpoint);
  }
  return absl::InternalError("no such approximate method");
}

absl::Status Validate(const MethodChoice& choice) {
  switch (choice.method) {
    case ApproximateMethod::kFmm:
    case ApproximateMethod::kFmmUntidy:
      return absl::OkStatus();
    case ApproximateMethod::kHeat:
      return HeatMethod::Check({.lambda = choice.lambda});
    case ApproximateMethod::kSvg:
      return SaddleVertexGraph::Check({.neighbours = choice.neighbours});
    case ApproximateMethod::kGtu:
      return TriangleUnfolding::Check({.samples = choice.samples});
  }
  return absl::InternalError("no such approximate method");
}

absl::StatusOr<std::shared_ptr<const PreparedMethod>> PrepareMethod(
    const Mesh& mesh, const MethodChoice& choice, uint32_t threads,
    Checkpoint& checkpoint) {
  return PrepareMethod(
      mesh, choice.method,
      {.heat = {.lambda = choice.lambda},
       .svg = {.neighbours = choice.neighbours, .threads = threads},
       .gtu = {.samples = choice.samples, .threads = threads}},
      checkpoint);
}

}  // namespace geodesic
