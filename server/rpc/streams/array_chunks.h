// Arrays of points, triangles or joined vertices in chunks of bytes, as they
// lie in memory.

#ifndef GEODESIC_SERVER_RPC_STREAMS_ARRAY_CHUNKS_H_
#define GEODESIC_SERVER_RPC_STREAMS_ARRAY_CHUNKS_H_

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

#include "geodesic/triangle_soup.h"

namespace geodesic::server {

static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(Point) == 24 && sizeof(Triangle) == 12 &&
              sizeof(JoinedVertex) == 8);

inline constexpr uint64_t kChunkBytes = uint64_t{512} << 10;

// Copies one chunk of the `count` items that `item` gives, from `begin` on;
// returns where the next chunk begins.
template <typename Item>
uint64_t FillChunk(uint64_t count, uint64_t begin, Item item,
                   std::string& bytes) {
  constexpr size_t kItemBytes = sizeof(item(0));
  const uint64_t end = std::min(begin + kChunkBytes / kItemBytes, count);
  bytes.resize((end - begin) * kItemBytes);
  char* to = bytes.data();
  for (uint64_t i = begin; i < end; ++i, to += kItemBytes) {
    std::memcpy(to, &item(i), kItemBytes);
  }
  return end;
}

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_STREAMS_ARRAY_CHUNKS_H_
