// Numbers as they travel in `bytes` fields, little endian.

#ifndef GEODESIC_SERVER_RPC_MESSAGES_VALUE_BYTES_H_
#define GEODESIC_SERVER_RPC_MESSAGES_VALUE_BYTES_H_

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "geodesic/v1/query.pb.h"

namespace geodesic::server {

// Numbers are sent as they lie in memory.
static_assert(std::endian::native == std::endian::little);

// Replaces what `bytes` holds, whose room is used again.
template <typename T>
void SetBytes(std::span<const T> items, std::string& bytes) {
  bytes.assign(reinterpret_cast<const char*>(items.data()),
               items.size() * sizeof(T));
}

template <typename T>
void AppendBytes(T item, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(&item), sizeof(T));
}

inline void SetValues(std::span<const double> values, v1::ValueType type,
                      std::string& bytes) {
  if (type != v1::VALUE_TYPE_FLOAT32) {
    SetBytes(values, bytes);
    return;
  }
  bytes.resize(values.size() * sizeof(float));
  char* at = bytes.data();
  for (const double value : values) {
    const float rounded = static_cast<float>(value);
    std::char_traits<char>::copy(at, reinterpret_cast<const char*>(&rounded),
                                 sizeof(float));
    at += sizeof(float);
  }
}

}  // namespace geodesic::server

#endif  // GEODESIC_SERVER_RPC_MESSAGES_VALUE_BYTES_H_
