// Values on the command line: sources, views, sizes.

#include <charconv>
#include <cmath>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "client/cli/arguments.h"

namespace geodesic::client {
namespace {

// Whether all of `text` is a number.
template <typename Number>
bool Parse(std::string_view text, Number* number) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, *number);
  return error == std::errc() && stop == end;
}

absl::Status Wrong(std::string_view text, std::string_view expected) {
  return absl::InvalidArgumentError(
      absl::StrCat("'", std::string(text), "' is not ", std::string(expected)));
}

}  // namespace

absl::StatusOr<Source> ParseSource(std::string_view text) {
  constexpr std::string_view kExpected =
      "a source: a vertex number from 0, or VERTEX:OFFSET with an offset >= 0";
  Source source;
  const size_t colon = text.find(':');
  if (!Parse(text.substr(0, colon), &source.vertex)) {
    return Wrong(text, kExpected);
  }
  if (colon != std::string_view::npos &&
      (!Parse(text.substr(colon + 1), &source.offset) ||
       !std::isfinite(source.offset) || source.offset < 0)) {
    return Wrong(text, kExpected);
  }
  return source;
}

absl::StatusOr<ViewDirection> ParseView(std::string_view text) {
  ViewDirection view;
  const size_t comma = text.find(',');
  if (comma == std::string_view::npos ||
      !Parse(text.substr(0, comma), &view.azimuth) ||
      !Parse(text.substr(comma + 1), &view.elevation) ||
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
  if (x == std::string_view::npos || !Parse(text.substr(0, x), &size.width) ||
      !Parse(text.substr(x + 1), &size.height) || !in_range(size.width) ||
      !in_range(size.height)) {
    return Wrong(
        text, absl::StrCat("a size: WIDTHxHEIGHT in pixels, such as "
                           "1600x1200 (each from ",
                           kLeastPictureSize, " to ", kMostPictureSize, ")"));
  }
  return size;
}

}  // namespace geodesic::client
