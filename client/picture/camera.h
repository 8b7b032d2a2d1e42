// An orthographic view of a mesh, and the choice of a good one.

#ifndef GEODESIC_CLIENT_PICTURE_CAMERA_H_
#define GEODESIC_CLIENT_PICTURE_CAMERA_H_

#include <vector>

#include "client/picture/vector3.h"
#include "geodesic_client/mesh.h"

namespace geodesic::client {

enum class UpAxis { kY, kZ };

// Where the viewer stands. Angles are in degrees. Azimuth 0 looks along -z if y
// is up and along +y if z is up. Azimuth grows as the viewer walks to the
// right, and elevation as the viewer rises.
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
  // Coordinates may have any magnitude, and `points` may be empty.
  Camera(const std::vector<Point>& points, const View& view,
         const Rectangle& area);

  // The point in pixels: to the right, down, and toward the viewer.
  Vector3 Project(const Point& point) const;

  // Half the longest side of the points' bounding box, in pixels.
  double scale() const { return scale_; }

  // Unit vectors of the screen, in the mesh's axes.
  const Vector3& right() const { return right_; }
  const Vector3& up() const { return up_; }
  const Vector3& toward_viewer() const { return toward_viewer_; }

 private:
  Vector3 right_;
  Vector3 up_;
  Vector3 toward_viewer_;
  // The middle of the points' bounding box, and the reciprocal of half its
  // longest side. Points are scaled by these first, so that no square
  // overflows.
  Vector3 middle_;
  double inverse_size_ = 1;
  // Pixels per unit of the scaled points, and the pixel of their middle.
  double scale_ = 1;
  double center_x_ = 0;
  double center_y_ = 0;
};

// z for a mesh that is flat along z, as terrains are, or that would stand
// upright along z but not along y. Otherwise y, as in most models.
UpAxis GuessUpAxis(const std::vector<Point>& positions);

// Tries oblique views from all around that fit the points `shown`. Takes the
// one with the best score, which grows with the area of the mesh's outline and
// with the share of `marks`, points on the surface, that are visible.
View ChooseView(const MeshArrays& mesh, const std::vector<Point>& shown,
                const std::vector<Point>& marks, UpAxis up);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_CAMERA_H_
