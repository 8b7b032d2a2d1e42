#include "client/cli/commands/drawings.h"

#include <type_traits>
#include <utility>

#include "client/cli/commands/question.h"

namespace geodesic::client {
namespace {

// Where a point lies in space.
Point PositionOf(const SurfacePoint& point, const MeshArrays& mesh) {
  std::vector<std::pair<double, uint64_t>> corners;  // weights and vertices
  if (const auto* vertex = std::get_if<VertexPoint>(&point)) {
    corners = {{1, vertex->vertex}};
  } else if (const auto* edge = std::get_if<EdgePoint>(&point)) {
    corners = {{1 - edge->t, edge->from}, {edge->t, edge->to}};
  } else if (const auto& at = std::get<FacePoint>(point);
             at.face < mesh.triangles.size()) {
    for (size_t i = 0; i < at.weights.size(); ++i) {
      corners.emplace_back(at.weights[i], mesh.triangles[at.face][i]);
    }
  }
  Point sum = {};
  for (const auto& [weight, vertex] : corners) {
    if (vertex >= mesh.positions.size()) continue;
    for (size_t axis = 0; axis < sum.size(); ++axis) {
      sum[axis] += weight * mesh.positions[vertex][axis];
    }
  }
  return sum;
}

}  // namespace

void ShowSources(const std::vector<Source>& sources, const MeshArrays& mesh,
                 PictureContent* content) {
  const auto show = [&](const auto& place) {
    if constexpr (std::is_same_v<decltype(place), const Curve&>) {
      PictureLine& line = content->bold_lines.emplace_back();
      for (const SurfacePoint& point : place.points) {
        line.points.push_back(PositionOf(point, mesh));
      }
    } else {
      content->sources.push_back(PositionOf(place, mesh));
    }
  };
  for (const Source& source : sources) std::visit(show, source.place);
}

void ShowTargets(const std::vector<SurfacePoint>& targets,
                 const MeshArrays& mesh, PictureContent* content) {
  for (const SurfacePoint& target : targets) {
    content->targets.push_back(PositionOf(target, mesh));
  }
}

absl::StatusOr<uint64_t> WritePicture(const std::string& path,
                                      const MeshArrays& mesh,
                                      const PictureContent& content,
                                      const PictureOptions& options) {
  absl::StatusOr<std::string> png = Render(mesh, content, options).EncodePng();
  if (!png.ok()) return png.status();
  return WriteFile(path, [&png](AtomicFile* file) { file->Append(*png); });
}

}  // namespace geodesic::client
