#include "client/picture/image.h"

#include <algorithm>
#include <cmath>

namespace geodesic::client {
namespace {

uint8_t EncodeChannel(float linear) {
  const float srgb = SrgbFromLinear(std::clamp(linear, 0.0F, 1.0F));
  return static_cast<uint8_t>(std::lround(255 * srgb));
}

}  // namespace

float SrgbFromLinear(float linear) {
  return linear <= 0.0031308F ? 12.92F * linear
                              : 1.055F * std::pow(linear, 1 / 2.4F) - 0.055F;
}

float LinearFromSrgb(float srgb) {
  return srgb <= 0.04045F ? srgb / 12.92F
                          : std::pow((srgb + 0.055F) / 1.055F, 2.4F);
}

Image Encode(const LinearImage& image) {
  Image encoded(image.width, image.height, Rgb8{});
  std::ranges::transform(
      image.pixels, encoded.pixels.begin(), [](const LinearColor& color) {
        return Rgb8{EncodeChannel(color.red), EncodeChannel(color.green),
                    EncodeChannel(color.blue)};
      });
  return encoded;
}

}  // namespace geodesic::client
