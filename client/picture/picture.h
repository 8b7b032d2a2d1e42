// A picture of a mesh coloured by a distance field.
//
//   PictureOptions options;
//   Image image = RenderField(mesh, field.distances, {0}, options);
//   absl::StatusOr<std::string> png = EncodePng(image);

#ifndef GEODESIC_CLIENT_PICTURE_PICTURE_H_
#define GEODESIC_CLIENT_PICTURE_PICTURE_H_

#include <cstdint>
#include <optional>
#include <vector>

#include "client/picture/camera.h"
#include "client/picture/image.h"
#include "geodesic_client/mesh.h"

namespace geodesic::client {

inline constexpr int kLeastPictureSize = 64;
inline constexpr int kMostPictureSize = 4096;

struct ViewDirection {
  double azimuth = 0;
  double elevation = 0;
};

struct PictureOptions {
  // In pixels, each from kLeastPictureSize to kMostPictureSize.
  int width = 1600;
  int height = 1200;
  // As View has them. DEFAULT: chosen by the mesh and its first source.
  std::optional<ViewDirection> direction;
  // DEFAULT: guessed from the mesh.
  std::optional<UpAxis> up;
};

// Draws the mesh on white: smooth shading; colours from 0 to the largest finite
// distance, told by a colour bar; dark isolines of constant width at round
// distances; light grey where a corner's distance is infinite; a dot on each
// visible source.
// REQUIRES: one distance per vertex; indices in range. Coordinates and
// distances of any magnitude are fine. Takes memory of 32 bytes a pixel.
Image RenderField(const MeshArrays& mesh, const std::vector<double>& distances,
                  const std::vector<uint64_t>& sources,
                  const PictureOptions& options);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_PICTURE_H_
