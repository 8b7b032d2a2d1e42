// Values on the command line: views, sizes.

#include <cmath>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "client/cli/arguments.h"
#include "client/output/number_text.h"

namespace geodesic::client {
namespace {

absl::Status Wrong(std::string_view text, std::string_view expected) {
  return absl::InvalidArgumentError(
      absl::StrCat("'", std::string(text), "' is not ", std::string(expected)));
}

}  // namespace

absl::StatusOr<ViewDirection> ParseView(std::string_view text) {
  ViewDirection view;
  const size_t comma = text.find(',');
  if (comma == std::string_view::npos ||
      !ParseNumber(text.substr(0, comma), &view.azimuth) ||
      !ParseNumber(text.substr(comma + 1), &view.elevation) ||
      !(std::abs(view.azimuth) <= 360) || !(std::abs(view.elevation) <= 90)) {
    return Wrong(text,
                 "a view: AZIMUTH,ELEVATION in degrees, such as 30,20 "
                 "(azimuth -360 to 360, elevation -90 to 90)");
  }
  return view;
}

absl::StatusOr<PictureSize> ParseSize(std::string_view text) {
  PictureSize size;
  const size_t x = text.find('x');
  const auto in_range = [](int pixels) {
    return pixels >= kLeastPictureSize && pixels <= kMostPictureSize;
  };
  if (x == std::string_view::npos ||
      !ParseNumber(text.substr(0, x), &size.width) ||
      !ParseNumber(text.substr(x + 1), &size.height) || !in_range(size.width) ||
      !in_range(size.height)) {
    return Wrong(
        text, absl::StrCat("a size: WIDTHxHEIGHT in pixels, such as "
                           "1600x1200 (each from ",
                           kLeastPictureSize, " to ", kMostPictureSize, ")"));
  }
  return size;
}

absl::StatusOr<double> ParseRadius(std::string_view text) {
  double radius = 0;
  if (!ParseNumber(text, &radius) || !(radius >= 0)) {
    return Wrong(text, "a radius: a number >= 0, in the unit of the mesh");
  }
  return radius;
}

absl::StatusOr<double> ParseLevel(std::string_view text) {
  double level = 0;
  if (!ParseNumber(text, &level) || !std::isfinite(level) || level <= 0) {
    return Wrong(text, "a level: a distance above 0, in the unit of the mesh");
  }
  return level;
}

absl::StatusOr<uint64_t> ParseCount(std::string_view text) {
  uint64_t count = 0;
  if (!ParseNumber(text, &count) || count == 0) {
    return Wrong(text, "a count: a whole number from 1");
  }
  return count;
}

}  // namespace geodesic::client
