// What colour the surface has at each sample of the screen.

#ifndef GEODESIC_CLIENT_PICTURE_SURFACE_H_
#define GEODESIC_CLIENT_PICTURE_SURFACE_H_

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "client/picture/camera.h"
#include "client/picture/colormap.h"
#include "client/picture/corner_normals.h"
#include "client/picture/image.h"
#include "client/picture/isolines.h"
#include "client/picture/nearest_cells.h"
#include "client/picture/rasterizer.h"
#include "client/picture/vector3.h"
#include "geodesic_client/mesh.h"

namespace geodesic::client {

// A colour for each source, far from those of the sources before and after it.
LinearColor ColorOfSource(uint32_t source);

// A mesh on the screen, and all that colours a sample of it.
class Surface {
 public:
  // What is told by colour; as PictureContent has it.
  struct Values {
    std::span<const double> distances;
    std::span<const uint32_t> nearest_sources;
    double largest = 0;
  };

  // `screen` are the mesh's vertices in samples; `line_width`, of isolines, is
  // in pixels. What is referred to must outlive the object.
  Surface(const MeshArrays& mesh, const Values& values,
          const std::vector<Vector3>& screen, const Camera& camera,
          const IsolineScale& isolines, double line_width);

  const Colormap& colormap() const { return colormap_; }

  // Sets the image's pixels to the average of their samples.
  void Draw(const VisibilityBuffer& samples, Image* image) const;

 private:
  // The colour of `triangle` at a point of the screen inside it.
  LinearColor ColorAt(uint32_t triangle, double x, double y) const;
  // `albedo` under light from the upper left in front, and a soft one from
  // above and below that leaves no part black. Both sides are lit alike.
  LinearColor Shade(const LinearColor& albedo, Vector3 normal) const;
  Vector3 NormalAt(uint32_t triangle, const Barycentric& weights) const;
  // Change of the distance per pixel, in the direction it changes most.
  double Gradient(const Triangle& triangle,
                  const std::array<double, 3>& distances) const;

  const MeshArrays& mesh_;
  Values values_;
  const std::vector<Vector3>& screen_;
  const Camera& camera_;
  Vector3 toward_lamp_;
  std::vector<std::array<Normal, 3>> normals_;
  std::optional<NearestCells> cells_;
  Colormap colormap_;
  IsolineScale isolines_;
  double line_width_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_SURFACE_H_
