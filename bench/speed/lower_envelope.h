// The least number of windows that an edge-window method creates.

#ifndef GEODESIC_BENCH_SPEED_LOWER_ENVELOPE_H_
#define GEODESIC_BENCH_SPEED_LOWER_ENVELOPE_H_

#include <cstdint>

#include "geodesic/mesh.h"

namespace geodesic::speed {

// How many windows are nearest somewhere on their half-edge once all is done:
// what fwp-mmp ends with if it keeps every list.
uint64_t LowerEnvelope(const Mesh& mesh, uint32_t source);

}  // namespace geodesic::speed

#endif  // GEODESIC_BENCH_SPEED_LOWER_ENVELOPE_H_
