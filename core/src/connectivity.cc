#include "connectivity.h"

#include <algorithm>
#include <string>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"

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

absl::Status RefuseCrowdedEdge(uint32_t lower, std::span<const Side> sides) {
  constexpr size_t kMostNamed = 8;
  std::string faces =
      absl::StrJoin(sides.first(std::min(sides.size(), kMostNamed)), ", ",
                    [](std::string* out, const Side& side) {
                      absl::StrAppend(out, side.half_edge / 3);
                    });
  if (sides.size() > kMostNamed) absl::StrAppend(&faces, ", ...");
  return absl::InvalidArgumentError(
      absl::StrCat("the mesh is not manifold: edge (", lower, ", ",
                   sides[0].upper, ") belongs to ", sides.size(),
                   " faces: ", faces, "; at most two faces may share an edge"));
}

absl::Status RefuseOrientation(uint32_t lower, std::span<const Side> sides) {
  return absl::InvalidArgumentError(absl::StrCat(
      "faces ", sides[0].half_edge / 3, " and ", sides[1].half_edge / 3,
      " run along edge (", lower, ", ", sides[0].upper,
      ") in the same direction: one of them is flipped, or the surface is not "
      "orientable"));
}

}  // namespace

absl::StatusOr<std::vector<HalfEdge>> FindTwins(
    std::span<const Triangle> triangles, uint32_t vertex_count) {
  const SidesByEdge by_edge(triangles, vertex_count);
  std::vector<HalfEdge> twins(3 * triangles.size(), kNoHalfEdge);
  for (uint32_t lower = 0; lower < vertex_count; ++lower) {
    std::span<const Side> rest = by_edge.WithLower(lower);
    while (!rest.empty()) {
      size_t count = 1;
      while (count < rest.size() && rest[count].upper == rest[0].upper) ++count;
      const std::span<const Side> sides = rest.first(count);
      rest = rest.subspan(count);
      if (count == 1) continue;
      if (count > 2) return RefuseCrowdedEdge(lower, sides);
      const HalfEdge a = sides[0].half_edge, b = sides[1].half_edge;
      if (triangles[a / 3][a % 3] == triangles[b / 3][b % 3]) {
        return RefuseOrientation(lower, sides);
      }
      twins[a] = b;
      twins[b] = a;
    }
  }
  return twins;
}

}  // namespace geodesic
