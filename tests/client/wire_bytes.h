// What the client's tests of received messages have in common.

#ifndef GEODESIC_TESTS_CLIENT_WIRE_BYTES_H_
#define GEODESIC_TESTS_CLIENT_WIRE_BYTES_H_

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "absl/status/status.h"

namespace geodesic::client {

// Elements as they travel.
template <typename Element>
std::string Bytes(const std::vector<Element>& elements) {
  return {reinterpret_cast<const char*>(elements.data()),
          elements.size() * sizeof(Element)};
}

inline void ExpectDataLoss(const absl::Status& status,
                           const std::string& words) {
  EXPECT_EQ(status.code(), absl::StatusCode::kDataLoss) << status;
  EXPECT_THAT(std::string(status.message()), ::testing::HasSubstr(words));
}

}  // namespace geodesic::client

#endif  // GEODESIC_TESTS_CLIENT_WIRE_BYTES_H_
