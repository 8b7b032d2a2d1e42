// A line sweeps over the plane from left to right (Shamos and Hoey, "Geometric
// intersection problems", 1976) and holds the sides that it meets, from below
// upwards.
//
// Invariant: sides that are neighbours on the line do not cross up to where the
// first of them ends, and above each of them the polygon winds once or not at
// all. Sides that lie on each other (Tied) may come in any order, and only
// above the last of them does the winding count.

#include "polygons/covers_once.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "absl/container/btree_set.h"

namespace geodesic {
namespace {

// A side has the number of the corner in which it begins.
struct Side {
  Flat left;
  Flat right;
};

Side SideOf(const FlatPolygon& polygon, uint32_t side) {
  const Flat begin = polygon.At(side);
  const Flat end = polygon.At(polygon.Next(side));
  return begin < end ? Side{begin, end} : Side{end, begin};
}

// Above 0 if a point of the side's range lies above it.
double Over(const Side& side, const Flat& point, double slack) {
  return Turn(side.right - side.left, point - side.left, slack);
}

// Above 0 if `b` lies above `a`, where their ranges overlap: as it does where
// the second of them begins, or else where the first of them ends.
double Order(const Side& a, const Side& b, double slack) {
  const double begin =
      b.left < a.left ? -Over(b, a.left, slack) : Over(a, b.left, slack);
  if (begin != 0) return begin;
  return a.right < b.right ? -Over(b, a.right, slack) : Over(a, b.right, slack);
}

bool Tied(const Side& a, const Side& b) {
  return Order(a, b, kStraightCorner) == 0;
}

// Whether `below` ends above `above`, or this one below it.
bool Cross(const Side& below, const Side& above) {
  return below.right < above.right
             ? Over(above, below.right, kStraightCorner) > 0
             : Over(below, above.right, kStraightCorner) < 0;
}

// Of the sides on the line.
struct FromBelow {
  using is_transparent = void;

  bool operator()(uint32_t a, uint32_t b) const {
    const Side first = SideOf(*polygon, a);
    const Side second = SideOf(*polygon, b);
    // What is tied keeps the order of its rounding, which has no circles.
    for (const double slack : {kStraightCorner, 0.0}) {
      const double order = Order(first, second, slack);
      if (order != 0) return order > 0;
    }
    return a < b;
  }
  bool operator()(uint32_t side, const Flat& point) const {
    return Over(SideOf(*polygon, side), point, kStraightCorner) > 0;
  }
  bool operator()(const Flat& point, uint32_t side) const {
    return Over(SideOf(*polygon, side), point, kStraightCorner) < 0;
  }

  const FlatPolygon* polygon;
};

class Sweep {
 public:
  Sweep(const FlatPolygon& polygon, Pace& pace)
      : polygon_(polygon), pace_(pace), on_line_(FromBelow{&polygon}) {}

  bool Run() {
    // A heap, since sorting could not be stopped.
    to_come_.reserve(polygon_.size());
    const auto later = [this](uint32_t a, uint32_t b) {
      return polygon_.At(b) < polygon_.At(a);
    };
    for (uint32_t corner = 0; corner < polygon_.size(); ++corner) {
      to_come_.push_back(corner);
      std::push_heap(to_come_.begin(), to_come_.end(), later);
      if (!pace_.Goes()) return false;
    }
    windings_.resize(polygon_.size());
    while (!to_come_.empty()) {
      // All corners at this place.
      const Flat place = polygon_.At(to_come_.front());
      auto here = to_come_.end();
      while (here != to_come_.begin() &&
             polygon_.At(to_come_.front()) == place) {
        std::pop_heap(to_come_.begin(), here, later);
        --here;
        if (!pace_.Goes()) return false;
      }
      if (!Leave(here, place) || !Enter(here, place) || !Check(place)) {
        return false;
      }
      to_come_.erase(here, to_come_.end());
    }
    return true;
  }

 private:
  using Corners = std::vector<uint32_t>::const_iterator;

  // Takes the sides off the line that end at these corners.
  bool Leave(Corners corner, const Flat& place) {
    for (; corner != to_come_.end(); ++corner) {
      const uint32_t before = polygon_.Previous(*corner);
      if ((polygon_.At(before) < place && on_line_.erase(before) == 0) ||
          (polygon_.At(polygon_.Next(*corner)) < place &&
           on_line_.erase(*corner) == 0) ||
          !pace_.Goes()) {
        // What is not found is out of order: sides cross.
        return false;
      }
    }
    return true;
  }

  // Puts the sides on the line that begin at these corners.
  bool Enter(Corners corner, const Flat& place) {
    for (; corner != to_come_.end(); ++corner) {
      const uint32_t before = polygon_.Previous(*corner);
      if (place < polygon_.At(before)) on_line_.insert(before);
      if (place < polygon_.At(polygon_.Next(*corner))) on_line_.insert(*corner);
      if (!pace_.Goes()) return false;
    }
    return true;
  }

  // Checks the invariant around a place where sides have come and gone.
  bool Check(const Flat& place) {
    auto next = on_line_.lower_bound(place);
    std::optional<Side> below;
    int32_t winding = 0;
    if (next != on_line_.begin()) {
      const uint32_t side = *std::prev(next);
      below = SideOf(polygon_, side);
      winding = windings_[side];
    }
    for (; next != on_line_.end(); ++next) {
      const Side side = SideOf(polygon_, *next);
      const bool is_tied = below.has_value() && Tied(*below, side);
      if (!is_tied && (winding < 0 || winding > 1)) return false;
      if (below.has_value() && Cross(*below, side)) return false;
      if (on_line_.key_comp()(place, *next)) return true;
      winding += side.left == polygon_.At(*next) ? 1 : -1;
      windings_[*next] = winding;
      below = side;
      if (!pace_.Goes()) return false;
    }
    return winding == 0;
  }

  const FlatPolygon& polygon_;
  Pace& pace_;
  // A heap of the corners that the line has still to pass, the next in front.
  std::vector<uint32_t> to_come_;
  absl::btree_set<uint32_t, FromBelow> on_line_;
  // How often the polygon winds around what is just above a side on the line.
  std::vector<int32_t> windings_;
};

}  // namespace

bool CoversOnce(const FlatPolygon& polygon, Pace& pace) {
  return Sweep(polygon, pace).Run();
}

}  // namespace geodesic
