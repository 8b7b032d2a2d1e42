#include "tests/support/oracles/strip_paths.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "tests/support/vec.h"

namespace geodesic::test {
namespace {

// An edge that a string passes, as it is seen on the way.
struct Gate {
  uint32_t left, right;
};

// The third corner, to the left of from -> to.
Vec2 LaidBeside(const TriangleSoup& soup, uint32_t from, uint32_t to,
                uint32_t corner, const std::vector<Vec2>& laid) {
  const std::vector<Point>& p = soup.positions;
  const Real length = Distance(p[from], p[to]);
  const Real to_from = Distance(p[from], p[corner]);
  const Real to_to = Distance(p[to], p[corner]);
  const Real along =
      (length + (to_from - to_to) * (to_from + to_to) / length) / 2;
  const Real height = std::sqrt((to_from - along) * (to_from + along));
  const Vec2 direction = (1 / length) * (laid[to] - laid[from]);
  return laid[from] + along * direction + height * Perpendicular(direction);
}

std::vector<Vec2> LaidIntoPlane(const TriangleSoup& soup) {
  std::vector<Vec2> laid(soup.positions.size());
  std::vector<bool> is_laid(laid.size(), false);
  const Triangle& first = soup.triangles.front();
  laid[first[1]] = {
      Distance(soup.positions[first[0]], soup.positions[first[1]]), 0};
  is_laid[first[0]] = is_laid[first[1]] = true;
  for (const Triangle& t : soup.triangles) {
    for (int i = 0; i < 3; ++i) {
      if (is_laid[t[i]]) continue;
      laid[t[i]] = LaidBeside(soup, t[(i + 1) % 3], t[(i + 2) % 3], t[i], laid);
      is_laid[t[i]] = true;
    }
  }
  return laid;
}

// Between triangles i and i + 1, passed in this direction.
std::vector<Gate> GatesOf(const TriangleSoup& soup) {
  std::vector<Gate> gates;
  for (size_t i = 0; i + 1 < soup.triangles.size(); ++i) {
    const Triangle& t = soup.triangles[i];
    const Triangle& next = soup.triangles[i + 1];
    for (int k = 0; k < 3; ++k) {
      if (std::ranges::find(next, t[k]) == next.end()) {
        gates.push_back({t[(k + 2) % 3], t[(k + 1) % 3]});
      }
    }
  }
  return gates;
}

// Where a string bends next, and the last gate that it has passed by then.
struct Bend {
  uint32_t at;
  size_t gate;
};

// Of a string from `apex` through the gates from `first` on, taut; its end at
// the last of them, which is a point, if it bends nowhere. A funnel runs from
// the apex to the gate that it has come to; where a gate turns one side of it
// over the other, the string bends.
Bend NextBend(const std::vector<Vec2>& laid, uint32_t apex,
              std::span<const Gate> gates, size_t first) {
  const auto turn = [&](uint32_t a, uint32_t b) {
    return Cross(laid[a] - laid[apex], laid[b] - laid[apex]);
  };
  // Gates that the apex is an end of bound nothing.
  while (gates[first].left == apex || gates[first].right == apex) ++first;
  Gate sides = gates[first];
  size_t left_gate = first, right_gate = first;
  for (size_t i = first + 1; i < gates.size(); ++i) {
    const Gate& next = gates[i];
    if (turn(sides.left, next.left) <= 0) {
      if (turn(sides.right, next.left) < 0) return {sides.right, right_gate};
      sides.left = next.left;
      left_gate = i;
    }
    if (turn(sides.right, next.right) >= 0) {
      if (turn(sides.left, next.right) > 0) return {sides.left, left_gate};
      sides.right = next.right;
      right_gate = i;
    }
  }
  return {gates.back().left, gates.size() - 1};
}

}  // namespace

std::vector<double> StripDistances(const TriangleSoup& soup, uint32_t source) {
  const std::vector<Vec2> laid = LaidIntoPlane(soup);
  const std::vector<Gate> gates = GatesOf(soup);
  // The first and last triangle of each vertex.
  struct Range {
    size_t first, last;
  };
  std::vector<Range> ranges(soup.positions.size(), {soup.triangles.size(), 0});
  for (size_t i = 0; i < soup.triangles.size(); ++i) {
    for (const uint32_t v : soup.triangles[i]) {
      ranges[v] = {std::min(ranges[v].first, i), i};
    }
  }
  std::vector<double> distances;
  for (uint32_t v = 0; v < soup.positions.size(); ++v) {
    std::vector<Gate> passed;
    for (size_t i = ranges[source].last; i < ranges[v].first; ++i) {
      passed.push_back(gates[i]);
    }
    for (size_t i = ranges[source].first; i-- > ranges[v].last;) {
      passed.push_back({gates[i].right, gates[i].left});
    }
    passed.push_back({v, v});
    Real length = 0;
    for (Bend from{source, 0}; from.at != v;) {
      const Bend bend = NextBend(laid, from.at, passed, from.gate);
      length += Norm(laid[bend.at] - laid[from.at]);
      from = bend;
    }
    distances.push_back(static_cast<double>(length));
  }
  return distances;
}

}  // namespace geodesic::test
