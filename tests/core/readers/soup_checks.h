// What the tests of the readers expect of soups and of refusals.

#ifndef GEODESIC_TESTS_CORE_READERS_SOUP_CHECKS_H_
#define GEODESIC_TESTS_CORE_READERS_SOUP_CHECKS_H_

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/read_mesh.h"
#include "geodesic/triangle_soup.h"

namespace geodesic::test {

// A StatusOr refused as INVALID_ARGUMENT with exactly this message.
MATCHER_P(IsInvalid, message, "") {
  *result_listener << arg.status().ToString();
  return absl::IsInvalidArgument(arg.status()) &&
         std::string(arg.status().message()) == message;
}

// A StatusOr refused as INVALID_ARGUMENT with this in its message.
MATCHER_P(IsInvalidWith, part, "") {
  *result_listener << arg.status().ToString();
  return absl::IsInvalidArgument(arg.status()) &&
         std::string(arg.status().message()).find(part) != std::string::npos;
}

// What every reader promises of what it returns.
inline void ExpectSound(const TriangleSoup& soup) {
  for (const Point& point : soup.positions) {
    for (const double coordinate : point) {
      ASSERT_TRUE(std::isfinite(coordinate));
    }
  }
  for (const Triangle& triangle : soup.triangles) {
    for (const uint32_t vertex : triangle) {
      ASSERT_LT(vertex, soup.positions.size());
    }
  }
}

// The soup, or a failure that shows the message and an empty soup.
inline TriangleSoup ExpectRead(absl::StatusOr<TriangleSoup> soup) {
  EXPECT_TRUE(soup.ok()) << soup.status();
  if (!soup.ok()) return {};
  ExpectSound(*soup);
  return *std::move(soup);
}

// Files that are refused as INVALID_ARGUMENT, with exactly these messages.
struct Refusal {
  std::string bytes;
  std::string message;
};
inline void ExpectRefused(MeshFormat format,
                          const std::vector<Refusal>& refusals) {
  for (const auto& [bytes, message] : refusals) {
    EXPECT_THAT(ReadMesh(bytes, format), IsInvalid(message));
  }
}

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_CORE_READERS_SOUP_CHECKS_H_
