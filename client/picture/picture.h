// Draws a mesh and what was computed on it.
//
//   Image image = Render(mesh, {.distances = field.distances,
//                               .isolines = true,
//                               .sources = {mesh.positions[0]}}, {});
//   absl::StatusOr<std::string> png = image.EncodePng();

#ifndef GEODESIC_CLIENT_PICTURE_PICTURE_H_
#define GEODESIC_CLIENT_PICTURE_PICTURE_H_

#include <cstdint>
#include <optional>
#include <span>
#include <string>
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
  // The angles of a View. DEFAULT: chosen by the mesh and what is drawn on it.
  std::optional<ViewDirection> direction;
  // DEFAULT: guessed from the mesh.
  std::optional<UpAxis> up;
};

// A line on the surface.
struct PictureLine {
  std::vector<Point> points;
  // Whether the last point leads back to the first.
  bool is_closed = false;
};

struct PictureContent {
  // The title of a picture of distances that are not exact, "approximate: heat"
  // or "within 0.001 (relative error)"; none for exact ones.
  std::string approximation;
  // One per vertex. Colours run from 0 to the largest finite distance, as a
  // colour bar shows. A triangle is light grey if a corner's distance is
  // infinite. Empty: the mesh has one colour.
  std::span<const double> distances;
  // One per vertex: colours each source's cell instead. Needs distances too.
  std::span<const uint32_t> nearest_sources;
  // Names of sources in the legend, indexed by number.
  std::vector<std::string> source_names;
  // Dark lines of constant width at round distances.
  bool isolines = false;
  // Thin dark lines for computed isolines. The colour bar marks `levels`.
  std::vector<PictureLine> thin_lines;
  std::vector<double> levels;
  // Bold lines for paths and curves. Hidden parts show faintly.
  std::vector<PictureLine> bold_lines;
  // Dots of two colours, which the legend below the picture names. Hidden ones
  // are dashed rings.
  std::vector<Point> sources;
  std::vector<Point> targets;
};

// The largest finite distance; 0 if there is none.
double LargestFinite(std::span<const double> distances);

// Draws the mesh on white, smoothly shaded, with lines and dots. A picture too
// narrow for a colour bar or a legend of sources has none.
// REQUIRES: one distance and nearest source per vertex, or none; indices in
// range.
// Coordinates and distances may have any magnitude. Takes 36 bytes a pixel.
Image Render(const MeshArrays& mesh, const PictureContent& content,
             const PictureOptions& options);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_PICTURE_H_
