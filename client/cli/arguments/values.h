// What single options may say.

#ifndef GEODESIC_CLIENT_CLI_ARGUMENTS_VALUES_H_
#define GEODESIC_CLIENT_CLI_ARGUMENTS_VALUES_H_

#include <cstdint>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "client/picture/picture.h"

namespace geodesic::client {

// "AZIMUTH,ELEVATION" in degrees.
// Errors: INVALID_ARGUMENT naming the text, likewise for the next ones.
absl::StatusOr<ViewDirection> ParseView(std::string_view text);

// "WIDTHxHEIGHT" in pixels.
struct PictureSize {
  int width = 0;
  int height = 0;
};
absl::StatusOr<PictureSize> ParseSize(std::string_view text);

// At least 0; "inf" is fine.
absl::StatusOr<double> ParseRadius(std::string_view text);

// Finite, above 0.
absl::StatusOr<double> ParseLevel(std::string_view text);

// Seconds above 0; "inf" is fine.
absl::StatusOr<double> ParseTimeout(std::string_view text);

// "HOST:PORT", or "[IPV6]:PORT".
absl::StatusOr<std::string> ParseServer(std::string_view text);

// At least 1.
absl::StatusOr<uint64_t> ParseCount(std::string_view text);

}  // namespace geodesic::client

#endif  // GEODESIC_CLIENT_CLI_ARGUMENTS_VALUES_H_
