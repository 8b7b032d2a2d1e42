// Segments put together into polylines.

#ifndef GEODESIC_QUESTIONS_ISOLINES_CHAINS_H_
#define GEODESIC_QUESTIONS_ISOLINES_CHAINS_H_

#include <cstdint>
#include <span>
#include <vector>

#include "questions/isolines/face_regions.h"

namespace geodesic {

struct Chain {
  std::vector<uint32_t> crossings;
  bool is_closed = false;  // its last crossing is followed by the first
};

// All segments between the crossings 0 .. crossing_count - 1, each in one
// chain: first the open chains, then the closed ones, each kind in order of
// its first crossing. Chains end where other than two segments meet. They run
// as their segments do, but where segments that run against each other meet;
// closed ones begin at their least crossing.
std::vector<Chain> ChainSegments(uint32_t crossing_count,
                                 std::span<const Segment> segments);

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_ISOLINES_CHAINS_H_
