#include "connectivity.h"

#include <algorithm>
#include <utility>

namespace geodesic {
namespace {

// A side of a face, filed under the lower of its two vertices.
struct Side {
  uint32_t upper;
  HalfEdge half_edge;

  friend auto operator<=>(const Side&, const Side&) = default;
};

class SidesByEdge {
 public:
  SidesByEdge(std::span<const Triangle> triangles, uint32_t vertex_count)
      : begin_(vertex_count + 1, 0), sides_(3 * triangles.size()) {
    ForEachSide(triangles, [&](uint32_t lower, Side) { ++begin_[lower + 1]; });
    for (uint32_t v = 0; v < vertex_count; ++v) begin_[v + 1] += begin_[v];
    std::vector<uint32_t> fill(begin_.begin(), begin_.end() - 1);
    ForEachSide(triangles, [&](uint32_t lower, Side side) {
      sides_[fill[lower]++] = side;
    });
    for (uint32_t v = 0; v < vertex_count; ++v) {
      std::sort(sides_.begin() + begin_[v], sides_.begin() + begin_[v + 1]);
    }
  }

  // The sides whose lower vertex is `lower`, sorted by the upper one.
  std::span<const Side> WithLower(uint32_t lower) const {
    return {sides_.data() + begin_[lower], sides_.data() + begin_[lower + 1]};
  }

 private:
  template <typename Visit>
  static void ForEachSide(std::span<const Triangle> triangles, Visit visit) {
    for (size_t f = 0; f < triangles.size(); ++f) {
      for (uint32_t i = 0; i < 3; ++i) {
        const auto [lower, upper] =
            std::minmax(triangles[f][i], triangles[f][i == 2 ? 0 : i + 1]);
        visit(lower, Side{upper, static_cast<HalfEdge>(3 * f + i)});
      }
    }
  }

  std::vector<uint32_t> begin_;
  std::vector<Side> sides_;
};

}  // namespace

Connectivity FindConnectivity(std::span<const Triangle> triangles,
                              uint32_t vertex_count) {
  const SidesByEdge by_edge(triangles, vertex_count);
  Connectivity result;
  result.exits.assign(3 * triangles.size(), kNoHalfEdge);
  const auto from = [&](HalfEdge h) { return triangles[h / 3][h % 3]; };
  for (uint32_t lower = 0; lower < vertex_count; ++lower) {
    std::span<const Side> rest = by_edge.WithLower(lower);
    while (!rest.empty()) {
      size_t count = 1;
      while (count < rest.size() && rest[count].upper == rest[0].upper) ++count;
      const std::span<const Side> sides = rest.first(count);
      rest = rest.subspan(count);
      if (count == 1) continue;
      const HalfEdge a = sides[0].half_edge, b = sides[1].half_edge;
      if (count == 2 && from(a) != from(b)) {
        result.exits[a] = b;
        result.exits[b] = a;
        continue;
      }
      if (result.crowds_begin.empty()) result.crowds_begin.push_back(0);
      const Exit crowd =
          kIrregularExit + static_cast<Exit>(result.crowds_begin.size() - 1);
      for (const Side& side : sides) {
        result.exits[side.half_edge] = crowd;
        result.crowds.push_back(side.half_edge);
      }
      result.crowds_begin.push_back(
          static_cast<uint32_t>(result.crowds.size()));
    }
  }
  return result;
}

}  // namespace geodesic
