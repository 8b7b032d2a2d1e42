// Pictures and their colours.

#ifndef GEODESIC_CLIENT_PICTURE_IMAGE_H_
#define GEODESIC_CLIENT_PICTURE_IMAGE_H_

#include <cairo.h>

#include <memory>
#include <string>

#include "absl/status/statusor.h"

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
// Each channel brought into 0 to 1.
LinearColor Clamp(const LinearColor& color);

// Pixels in sRGB (IEC 61966-2-1), and Cairo to draw lines and text over them.
// Coordinates are in pixels, from the left and from the top.
class Image {
 public:
  // White. REQUIRES: 0 < width, height <= 32767.
  Image(int width, int height);

  int width() const;
  int height() const;

  // Of a colour beyond 0 to 1, the nearest that the screen can show.
  // REQUIRES: nothing has been drawn with cairo() yet.
  void Set(int x, int y, const LinearColor& color);

  // Draws on this image, for as long as it lives.
  cairo_t* cairo() { return cairo_.get(); }
  // What cairo() draws with from now on.
  void SetInk(const LinearColor& color);
  // As much of `text`, which is ASCII, as fits into `width` pixels in letters
  // of `size` pixels; an ellipsis takes the place of what does not.
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

  // Holds the pixels too.
  std::unique_ptr<cairo_t, Destroy> cairo_;
};

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_PICTURE_IMAGE_H_
