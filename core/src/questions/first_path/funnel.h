// The shortest path within a strip of faces, laid into the plane: the funnel of
// Lee and Preparata (Euclidean shortest paths in the presence of rectilinear
// barriers. Networks 14(3), 1984).

#ifndef GEODESIC_QUESTIONS_FIRST_PATH_FUNNEL_H_
#define GEODESIC_QUESTIONS_FIRST_PATH_FUNNEL_H_

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "questions/first_path/portal.h"
#include "solver/windows/window.h"
#include "surface/plane_point.h"

namespace geodesic {

// For one thread; kept for its memory.
class Funnel {
 public:
  // Where the shortest path bends or ends.
  struct Bend {
    PlanePoint at;
    uint32_t portal;  // the first that ends there; of the end, portals.size()
    bool is_left;
  };

  // `begin`: in the frame of the first portal; `end`: in that of the last one.
  // O(portals). REQUIRES: there is a portal.
  void Find(std::span<const Portal> portals, const PlanePoint& begin,
            const PlanePoint& end);

  // Of the last Find. The bends in order, and then the end.
  std::span<const Bend> bends() const { return bends_; }
  const PlanePoint& begin() const { return corners_[0].bend.at; }
  // The ends of portal i.
  const PlanePoint& Left(uint32_t i) const { return left_[i]; }
  const PlanePoint& Right(uint32_t i) const { return right_[i]; }

  uint64_t bytes() const;

 private:
  // One of the chains' corners.
  struct Corner {
    Bend bend;
    uint32_t before;  // on the way from the begin
  };

  // To the chain on that side.
  template <Side kSide>
  void Add(const Bend& bend);
  const PlanePoint& PointOf(size_t k) const {
    return corners_[chain_[k]].bend.at;
  }

  std::vector<PlanePoint> left_, right_;
  std::vector<Corner> corners_;
  uint32_t corner_count_ = 0;
  // Numbers of corners: from first_ to apex_ the left chain, the last one
  // first, and from there to last_ the right one.
  std::vector<uint32_t> chain_;
  size_t first_ = 0, apex_ = 0, last_ = 0;
  std::vector<Bend> bends_;
};

}  // namespace geodesic

#endif  // GEODESIC_QUESTIONS_FIRST_PATH_FUNNEL_H_
