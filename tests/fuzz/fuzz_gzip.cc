// libFuzzer target of Gunzip: whatever the bytes, it keeps to its bound and its
// errors.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "geodesic/gzip.h"

namespace geodesic {
namespace {

constexpr uint64_t kMost = 1 << 20;

void Require(bool promise) {
  if (!promise) std::abort();
}

void CheckGunzip(std::string_view bytes) {
  Require(PromisedGzipBytes(bytes) >= 1);
  const absl::StatusOr<std::vector<char>> inflated = Gunzip(bytes, kMost);
  if (inflated.ok()) {
    Require(inflated->size() <= kMost);
    Require(inflated->capacity() <= 2 * kMost);
  } else {
    Require(absl::IsInvalidArgument(inflated.status()) ||
            absl::IsResourceExhausted(inflated.status()));
  }
}

}  // namespace
}  // namespace geodesic

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  geodesic::CheckGunzip({reinterpret_cast<const char*>(data), size});
  return 0;
}
