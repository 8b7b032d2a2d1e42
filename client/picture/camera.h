// An orthographic view of a mesh, and one that shows much of it.

#ifndef GEODESIC_CLIENT_PICTURE_CAMERA_H_
#define GEODESIC_CLIENT_PICTURE_CAMERA_H_

#include <vector>

#include "client/picture/vector3.h"
#include "geodesic_client/mesh.h"

namespace geodesic::client {

enum class UpAxis { kY, kZ };

// Where the viewer stands, in degrees. Azimuth 0 looks along -z if y is up and
// along +y if z is up; it grows as the viewer walks to the right. Elevation
// grows as the viewer rises.
struct View {
  UpAxis up = UpAxis::kY;
  double azimuth = 0;
  double elevation = 0;
};

// A rectangle on the screen, in pixels; y points down.
struct Rectangle {
  double left = 0;
  double top = 0;
  double width = 0;
  double height = 0;
};

// Immutable.
class Camera {
 public:
  // Shows all of `points` in the middle of `area`, as large as fits.
  // Coordinates of any magnitude are fine, and so are no points.
  Camera(const std::vector<Point>& points, const View& view,
         const Rectangle& area);

  // Pixels to the right, pixels down, and pixels toward the viewer.
  Vector3 Project(const Point& point) const;

  // Pixels that half the longest side of the points' bounding box takes.
  double scale() const { return scale_; }

  // Unit vectors of the screen, in the mesh's axes.
  const Vector3& right() const { return right_; }
  const Vector3& up() const { return up_; }
  const Vector3& toward_viewer() const { return toward_viewer_; }

 private:
  Vector3 right_;
  Vector3 up_;
  Vector3 toward_viewer_;
  // The middle of the points' bounding box, and the reciprocal of its longest
  // side: what comes first, so that no square overflows.
  Vector3 middle_;
  double inverse_size_ = 1;
  // Pixels for a unit of the scaled points, and the pixel of their middle.
  double scale_ = 1;
  double center_x_ = 0;
  double center_y_ = 0;
};

// z for a mesh that is flat along z, as terrains are, or that would stand on a
// floor along z but fall over along y; y otherwise, as in most models.
UpAxis GuessUpAxis(const std::vector<Point>& positions);

// Tries oblique views of `shown`, the points that are to fit, from all around
// and takes the one in which the mesh has the largest outline, preferring those
// that see more of the marks, which lie on the surface.
View ChooseView(const MeshArrays& mesh, const std::vector<Point>& shown,
                const std::vector<Point>& marks, UpAxis up);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_CAMERA_H_
