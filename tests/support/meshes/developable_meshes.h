// Surfaces that unroll into the plane but for one apex, with their distances
// in closed form.

#ifndef GEODESIC_TESTS_SUPPORT_MESHES_DEVELOPABLE_MESHES_H_
#define GEODESIC_TESTS_SUPPORT_MESHES_DEVELOPABLE_MESHES_H_

#include <cstdint>
#include <vector>

#include "geodesic/triangle_soup.h"

namespace geodesic::test {

// Flat sectors around an apex (vertex 0): a cone below 2 pi, a disc at 2 pi, a
// saddle fan above. An open fan is not joined at the ends: its apex is on the
// boundary.
struct FanOptions {
  uint32_t spokes = 8;  // sectors; even where a closed fan exceeds 2 pi
  uint32_t rings = 2;
  double total_angle = 6;  // radians; below spokes * pi
  bool closed = true;
};

class Fan {
 public:
  explicit Fan(const FanOptions& options);

  const TriangleSoup& soup() const { return soup_; }

  // By the law of cosines where the angle between is below pi, else by way of
  // the apex.
  double Distance(uint32_t v, uint32_t w) const;

 private:
  FanOptions options_;
  TriangleSoup soup_;
  std::vector<double> radius_, angle_;  // polar coordinates about the apex
};

// The side of a right prism over a regular polygon, without base and top.
struct PrismOptions {
  uint32_t sides = 7, rows = 4;
  double side_length = 1, row_height = 0.8;
};

class Prism {
 public:
  explicit Prism(const PrismOptions& options);

  const TriangleSoup& soup() const { return soup_; }

  // Unrolled: the shorter of the two ways around.
  double Distance(uint32_t v, uint32_t w) const;

 private:
  PrismOptions options_;
  TriangleSoup soup_;
};

// A rectangle folded along lines across it by random angles.
class FoldedSheet {
 public:
  FoldedSheet(uint32_t columns, uint32_t rows, uint64_t seed);

  const TriangleSoup& soup() const { return soup_; }

  // Euclid on the sheet laid flat.
  double Distance(uint32_t v, uint32_t w) const;

 private:
  TriangleSoup soup_;
  std::vector<Point> flat_;
};

}  // namespace geodesic::test

#endif  // GEODESIC_TESTS_SUPPORT_MESHES_DEVELOPABLE_MESHES_H_
