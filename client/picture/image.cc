#include "client/picture/image.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <new>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"

namespace geodesic::client {
namespace {

double SrgbFromLinear(float linear) {
  return linear <= 0.0031308F ? 12.92 * linear
                              : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

uint32_t EncodeChannel(float linear) {
  return static_cast<uint32_t>(std::lround(255 * SrgbFromLinear(linear)));
}

cairo_t* NewDrawing(int width, int height) {
  cairo_surface_t* surface =
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
  cairo_t* cairo = cairo_create(surface);
  cairo_surface_destroy(surface);  // `cairo` has a reference.
  if (cairo_status(cairo) != CAIRO_STATUS_SUCCESS) throw std::bad_alloc();
  return cairo;
}

cairo_status_t Append(void* to, const unsigned char* data,
                      unsigned int length) {
  static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(data),
                                        length);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

LinearColor Clamp(const LinearColor& color) {
  return {std::clamp(color.red, 0.0F, 1.0F),
          std::clamp(color.green, 0.0F, 1.0F),
          std::clamp(color.blue, 0.0F, 1.0F)};
}

Image::Image(int width, int height) : cairo_(NewDrawing(width, height)) {
  SetInk({1, 1, 1});
  cairo_paint(cairo());
  cairo_surface_flush(cairo_get_target(cairo()));
  cairo_set_line_cap(cairo(), CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(cairo(), CAIRO_LINE_JOIN_ROUND);
  cairo_select_font_face(cairo(), "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         CAIRO_FONT_WEIGHT_NORMAL);
}

int Image::width() const {
  return cairo_image_surface_get_width(cairo_get_target(cairo_.get()));
}

int Image::height() const {
  return cairo_image_surface_get_height(cairo_get_target(cairo_.get()));
}

void Image::Set(int x, int y, const LinearColor& color) {
  cairo_surface_t* surface = cairo_get_target(cairo());
  unsigned char* row =
      cairo_image_surface_get_data(surface) +
      static_cast<ptrdiff_t>(y) * cairo_image_surface_get_stride(surface);
  const LinearColor shown = Clamp(color);
  reinterpret_cast<uint32_t*>(row)[x] = EncodeChannel(shown.red) << 16 |
                                        EncodeChannel(shown.green) << 8 |
                                        EncodeChannel(shown.blue);
}

void Image::SetInk(const LinearColor& color) {
  cairo_set_source_rgb(cairo(), SrgbFromLinear(color.red),
                       SrgbFromLinear(color.green), SrgbFromLinear(color.blue));
}

std::string Image::Shortened(const std::string& text, double width,
                             double size) {
  cairo_set_font_size(cairo(), size);
  const auto fits = [this, width](const std::string& shown) {
    cairo_text_extents_t extents;
    cairo_text_extents(cairo(), shown.c_str(), &extents);
    return extents.x_advance <= width;
  };
  // Letters are added from the front, since the name of a curve may be very
  // long.
  size_t whole = 0;
  size_t cut = 0;
  while (whole < text.size() && fits(text.substr(0, whole + 1))) {
    ++whole;
    if (fits(text.substr(0, whole) + "…")) cut = whole;
  }
  return whole == text.size() ? text : text.substr(0, cut) + "…";
}

double Image::DrawText(const std::string& text, double left, double baseline,
                       double size) {
  cairo_set_font_size(cairo(), size);
  cairo_move_to(cairo(), left, baseline);
  cairo_show_text(cairo(), text.c_str());
  double end = left;
  cairo_get_current_point(cairo(), &end, nullptr);
  cairo_new_path(cairo());
  return end;
}

absl::StatusOr<std::string> Image::EncodePng() const {
  std::string bytes;
  cairo_status_t status = cairo_status(cairo_.get());
  if (status == CAIRO_STATUS_SUCCESS) {
    status = cairo_surface_write_to_png_stream(cairo_get_target(cairo_.get()),
                                               Append, &bytes);
  }
  if (status != CAIRO_STATUS_SUCCESS) {
    return absl::InternalError(
        absl::StrCat("cannot draw the picture: Cairo says \"",
                     cairo_status_to_string(status), "\""));
  }
  return bytes;
}

}  // namespace geodesic::client
