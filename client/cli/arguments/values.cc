#include "client/cli/arguments/values.h"

#include <algorithm>
#include <cmath>

#include "absl/status/status.h"
#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "client/output/number_text.h"

namespace geodesic::client {
namespace {

absl::Status Wrong(std::string_view text, std::string_view expected) {
  return absl::InvalidArgumentError(
      absl::StrCat("'", std::string(text), "' is not ", std::string(expected)));
}

template <typename Number, typename Accept>
absl::StatusOr<Number> ParseIf(std::string_view text, std::string_view expected,
                               Accept accept) {
  Number number = 0;
  if (!ParseNumber(text, &number) || !accept(number)) {
    return Wrong(text, expected);
  }
  return number;
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
  return ParseIf<double>(text,
                         "a radius: a number >= 0, in the unit of the mesh",
                         [](double radius) { return radius >= 0; });
}

absl::StatusOr<double> ParseLevel(std::string_view text) {
  return ParseIf<double>(
      text, "a level: a distance above 0, in the unit of the mesh",
      [](double level) { return level > 0 && std::isfinite(level); });
}

absl::StatusOr<double> ParseTimeout(std::string_view text) {
  return ParseIf<double>(text, "a time: a number of seconds above 0",
                         [](double seconds) { return seconds > 0; });
}

absl::StatusOr<uint64_t> ParseCount(std::string_view text) {
  return ParseIf<uint64_t>(text, "a count: a whole number from 1",
                           [](uint64_t count) { return count > 0; });
}

absl::StatusOr<std::string> ParseServer(std::string_view text) {
  const size_t colon = text.rfind(':');
  const std::string_view host = text.substr(0, colon);
  const bool is_ipv6 =
      host.size() > 2 && host.starts_with('[') && host.ends_with(']');
  const bool is_host =
      is_ipv6 || (!host.empty() && std::ranges::all_of(host, [](char c) {
        return absl::ascii_isalnum(c) || c == '.' || c == '-' || c == '_';
      }));
  uint16_t port = 0;
  if (colon == std::string_view::npos || !is_host ||
      !ParseNumber(text.substr(colon + 1), &port) || port == 0) {
    return Wrong(text,
                 "a server: HOST:PORT, such as 127.0.0.1:50051 or "
                 "[::1]:50051, with a port from 1 to 65535");
  }
  return std::string(text);
}

}  // namespace geodesic::client
