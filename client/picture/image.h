// Pictures while they are drawn and when they are done.

#ifndef GEODESIC_CLIENT_PICTURE_IMAGE_H_
#define GEODESIC_CLIENT_PICTURE_IMAGE_H_

#include <cstddef>
#include <cstdint>
#include <vector>

namespace geodesic::client {

// Red, green and blue in linear light, 0 to 1: what may be added and averaged.
struct LinearColor {
  float red = 0;
  float green = 0;
  float blue = 0;
};

inline LinearColor operator+(const LinearColor& a, const LinearColor& b) {
  return {a.red + b.red, a.green + b.green, a.blue + b.blue};
}
inline LinearColor operator*(float s, const LinearColor& a) {
  return {s * a.red, s * a.green, s * a.blue};
}
// `a` where t is 0, `b` where it is 1.
inline LinearColor Mix(const LinearColor& a, const LinearColor& b, float t) {
  return (1 - t) * a + t * b;
}

// Rows from the top, pixels from the left.
template <typename Pixel>
struct Raster {
  Raster(int w, int h, Pixel fill)
      : width(w), height(h), pixels(static_cast<size_t>(w) * h, fill) {}

  Pixel& At(int x, int y) { return pixels[static_cast<size_t>(y) * width + x]; }
  const Pixel& At(int x, int y) const {
    return pixels[static_cast<size_t>(y) * width + x];
  }

  int width;
  int height;
  std::vector<Pixel> pixels;
};

using LinearImage = Raster<LinearColor>;

// sRGB, 8 bits a channel.
struct Rgb8 {
  uint8_t red = 0;
  uint8_t green = 0;
  uint8_t blue = 0;

  friend bool operator==(const Rgb8&, const Rgb8&) = default;
};

using Image = Raster<Rgb8>;

// The transfer function of sRGB (IEC 61966-2-1) and its inverse.
float SrgbFromLinear(float linear);
float LinearFromSrgb(float srgb);

// Encodes for the screen; values beyond 0 to 1 are clipped.
Image Encode(const LinearImage& image);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_IMAGE_H_
