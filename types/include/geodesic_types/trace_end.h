// Why a line that runs straight on ends.

#ifndef GEODESIC_TYPES_TRACE_END_H_
#define GEODESIC_TYPES_TRACE_END_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace geodesic {

// Numbered as in the protocol's array `end`.
enum class TraceEnd : uint8_t {
  kLength,    // it is as long as was asked for
  kBoundary,  // it comes to a boundary
  // It comes to where there is no straight on: an edge of three faces or more,
  // a vertex where surfaces touch or faces disagree in orientation, a face
  // without area.
  kSingular,
};

// "length", "boundary" or "singular".
constexpr std::string_view TraceEndName(TraceEnd end) {
  constexpr std::array<std::string_view, 3> kNames = {"length", "boundary",
                                                      "singular"};
  return kNames[static_cast<size_t>(end)];
}

}  // namespace geodesic

#endif  // GEODESIC_TYPES_TRACE_END_H_
