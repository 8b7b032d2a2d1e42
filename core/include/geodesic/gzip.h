// Bytes that were compressed with gzip, as in "horse.ply.gz".

#ifndef GEODESIC_GZIP_H_
#define GEODESIC_GZIP_H_

#include <cstdint>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace geodesic {

class Checkpoint;

// Whether the bytes begin as gzip's do.
bool IsGzip(std::string_view bytes);

// How many bytes they say they hold, which may be a lie: at least one, and no
// more than any so many bytes could. O(1).
uint64_t PromisedGzipBytes(std::string_view bytes);

// What the bytes hold, which may be several pieces one behind another. Takes no
// more memory than twice `most`. `checkpoint` is polled now and then, unless it
// is null. Linear in the bytes and what they hold.
// Errors: INVALID_ARGUMENT for bytes that are damaged or cut off;
// RESOURCE_EXHAUSTED if they hold more than `most`; what `checkpoint` returns.
absl::StatusOr<std::vector<char>> Gunzip(std::string_view bytes, uint64_t most,
                                         Checkpoint* checkpoint = nullptr);

}  // namespace geodesic

#endif  // GEODESIC_GZIP_H_
