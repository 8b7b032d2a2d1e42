// Pieces of isolines put together.

#ifndef GEODESIC_QUESTIONS_ISOLINES_CHAINING_H_
#define GEODESIC_QUESTIONS_ISOLINES_CHAINING_H_

#include <cstdint>
#include <span>
#include <vector>

namespace geodesic {

// A piece of an isoline inside a face, between two crossings, by number. What
// is nearer lies to its left (where faces run anticlockwise).
struct Segment {
  uint32_t from = 0;
  uint32_t to = 0;
  // Places in between.
  uint32_t first_sample = 0;
  uint32_t sample_count = 0;
};

struct Chain {
  struct Link {
    uint32_t segment = 0;
    bool is_forward = true;
  };
  std::vector<uint32_t> crossings;
  std::vector<Link> links;  // from each crossing to the next
  bool is_closed = false;   // the last link leads to the first crossing
};

// Puts all segments between the crossings 0 .. crossing_count - 1 together,
// each in one chain: first the open chains, then the closed ones, each kind in
// order of its first crossing. Chains end where other than two segments meet.
// They run as their segments do, but where segments that run against each other
// meet; closed ones begin at their least crossing.
std::vector<Chain> ChainsOf(uint32_t crossing_count,
                            std::span<const Segment> segments);

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_ISOLINES_CHAINING_H_
