// Images and their colours.

#ifndef GEODESIC_CLIENT_PICTURE_IMAGE_H_
#define GEODESIC_CLIENT_PICTURE_IMAGE_H_

#include <cairo.h>

#include <memory>
#include <string>

#include "absl/status/statusor.h"

namespace geodesic::client {

// Red, green and blue in linear light, from 0 to 1, which can be added and
// averaged.
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
// Returns `a` if t is 0 and `b` if t is 1.
inline LinearColor Mix(const LinearColor& a, const LinearColor& b, float t) {
  return (1 - t) * a + t * b;
}
// Clamps each channel to 0..1.
LinearColor Clamp(const LinearColor& color);

// Pixels in sRGB (IEC 61966-2-1), and a Cairo context that draws lines and text
// over them. Coordinates are in pixels, from the left and from the top.
class Image {
 public:
  // A white image.
  // REQUIRES: 0 < width, height <= 32767.
  Image(int width, int height);

  int width() const;
  int height() const;

  // Clamps the colour to 0..1.
  // REQUIRES: nothing has been drawn with cairo() yet.
  void Set(int x, int y, const LinearColor& color);

  // Draws on this image. Valid as long as the image.
  cairo_t* cairo() { return cairo_.get(); }
  // Sets the colour that cairo() draws with.
  void SetInk(const LinearColor& color);
  // Returns as much of `text`, which is ASCII, as fits into `width` pixels in
  // letters of `size` pixels. An ellipsis replaces the rest.
  std::string Shortened(const std::string& text, double width, double size);
  // Writes a line of UTF-8 that stands on `baseline`, in letters of `size`
  // pixels. Returns where it ends.
  double DrawText(const std::string& text, double left, double baseline,
                  double size);

  // The bytes of a PNG file.
  // Errors: INTERNAL with Cairo's message, if it could not draw or encode.
  absl::StatusOr<std::string> EncodePng() const;

 private:
  struct Destroy {
    void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
  };

  // Owns the pixels too.
  std::unique_ptr<cairo_t, Destroy> cairo_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_IMAGE_H_
