#include "client/picture/shading.h"

#include <algorithm>

namespace geodesic::client {

Lighting::Lighting(const Camera& camera)
    : toward_viewer_(camera.toward_viewer()),
      up_(camera.up()),
      toward_lamp_(Normalized(-0.50 * camera.right() + 0.60 * camera.up() +
                              0.80 * camera.toward_viewer())) {}

LinearColor Lighting::Shade(const LinearColor& albedo, Vector3 normal) const {
  if (Dot(normal, toward_viewer_) < 0) normal = -1 * normal;
  const double lamp = std::max(0.0, Dot(normal, toward_lamp_));
  const double sky = 0.5 + 0.5 * Dot(normal, up_);
  // A surface that faces the lamp keeps its colour, so that it can be read off
  // the colour bar.
  const double light = 0.27 + 0.16 * sky + 0.66 * lamp;
  return static_cast<float>(light) * albedo;
}

}  // namespace geodesic::client
