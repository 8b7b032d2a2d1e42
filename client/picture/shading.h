// What colour a visible sample has.

#ifndef GEODESIC_CLIENT_PICTURE_SHADING_H_
#define GEODESIC_CLIENT_PICTURE_SHADING_H_

#include "client/picture/camera.h"
#include "client/picture/image.h"
#include "client/picture/vector3.h"

namespace geodesic::client {

// Light from the upper left in front, and a soft one from above and below that
// leaves no part black. Both sides of a surface are lit alike.
class Lighting {
 public:
  explicit Lighting(const Camera& camera);

  // `albedo` seen at a unit `normal`, which may point away from the viewer.
  LinearColor Shade(const LinearColor& albedo, Vector3 normal) const;

 private:
  Vector3 toward_viewer_;
  Vector3 up_;
  Vector3 toward_lamp_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_SHADING_H_
